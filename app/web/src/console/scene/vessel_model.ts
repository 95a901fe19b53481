// The vessel as one looks into it: the far wall dark and nearly solid, the near wall a breath with
// a bright outline. Loaded once per trial.
import {
  BackSide, BufferAttribute, BufferGeometry, FrontSide, GLSL3, Group, Mesh, type Object3D, ShaderMaterial, Sphere,
  Vector3,
} from 'three';
import {GLTFLoader} from 'three/examples/jsm/loaders/GLTFLoader.js';
import {chunksOf} from './mesh_chunks';
import {type Surface, thinned} from './mesh_thinning';
import {type Rgb, wallColour, wallEdgeColour, wallInsideColour} from './palette';

const vertexShader = `
  out vec3 shade_normal;
  out vec3 to_eye;
  void main() {
    vec4 seen = modelViewMatrix * vec4(position, 1.0);
    shade_normal = normalMatrix * normal;
    to_eye = -seen.xyz;
    gl_Position = projectionMatrix * seen;
  }`;

const fragmentShader = `
  uniform vec3 face_colour;
  uniform vec3 edge_colour;
  uniform vec2 opacity;   // facing the eye, at the outline
  uniform float sharpness;
  in vec3 shade_normal;
  in vec3 to_eye;
  out vec4 colour;
  void main() {
    vec3 n = normalize(shade_normal);
    float facing = abs(dot(n, normalize(to_eye)));
    float outline = pow(1.0 - facing, sharpness);
    float light = 0.78 + 0.22 * dot(n, normalize(vec3(-0.35, 0.55, 0.75)));
    colour = vec4(mix(face_colour, edge_colour, outline) * light, mix(opacity.x, opacity.y, outline));
  }`;

interface Look {
  face: Rgb;
  edge: Rgb;
  opacity: readonly [number, number];
  sharpness: number;
}

const farWall: Look = {face: wallInsideColour, edge: wallColour, opacity: [0.92, 0.75], sharpness: 1.6};
const nearWall: Look = {face: wallColour, edge: wallEdgeColour, opacity: [0.1, 0.95], sharpness: 2.2};

/** Layers of the scene: a camera that shows all of the vessel needs less of its detail. */
export const closeLayer = 1;
export const wholeLayer = 2;

/** How many triangles the machine draws fluently, near by and from afar. */
export interface Detail {
  readonly close: number;
  readonly whole: number;
}

export interface VesselModel {
  readonly group: Group;
  /** x, y, z of its corners, thinned out: enough to fit the camera. */
  readonly outline: Float32Array;
  dispose(): void;
}

const chunkSize_mm = 40;

/** Rejects when the mesh cannot be had; the message is a sentence. */
export async function loadVessel(url: string, detail: Detail): Promise<VesselModel> {
  const file = await new GLTFLoader().loadAsync(url).catch(() => {
    throw new Error('The vessel could not be loaded. Check the connection and try again.');
  });
  const surfaces = surfacesOf(file.scene);
  if (surfaces.length === 0) throw new Error('The vessel holds no surface. Tell your administrator.');
  const materials = [wallMaterial(farWall, BackSide), wallMaterial(nearWall, FrontSide)];
  const geometries: BufferGeometry[] = [];
  const group = new Group();
  for (const surface of surfaces) {
    const close = chunkGeometries(thinned(surface, detail.close), chunkSize_mm);
    const whole = chunkGeometries(thinned(surface, detail.whole), Infinity);
    geometries.push(...close, ...whole);
    addWalls(group, close, materials, closeLayer);
    addWalls(group, whole, materials, wholeLayer);
  }
  return {
    group,
    outline: thinnedOut(surfaces),
    dispose: () => [...geometries, ...materials].forEach((part) => part.dispose()),
  };
}

function addWalls(group: Group, geometries: readonly BufferGeometry[], materials: readonly ShaderMaterial[], layer: number): void {
  for (const geometry of geometries) {
    materials.forEach((material, order) => {
      const wall = new Mesh(geometry, material);
      wall.renderOrder = order + 1;  // behind the instrument first, then over it
      wall.layers.set(layer);
      group.add(wall);
    });
  }
}

// pieces share their vertices and differ in their triangles
function chunkGeometries(surface: Surface, size: number): BufferGeometry[] {
  const position = new BufferAttribute(surface.positions, 3);
  const normal = new BufferAttribute(surface.normals, 3);
  return chunksOf(surface, size).map((chunk) => {
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', position);
    geometry.setAttribute('normal', normal);
    geometry.setIndex(new BufferAttribute(chunk.index, 1));
    geometry.boundingSphere = new Sphere(new Vector3(...chunk.centre), chunk.radius);
    return geometry;
  });
}

// in the frame of the file, with whatever its nodes do to it
function surfacesOf(scene: Object3D): Surface[] {
  const surfaces: Surface[] = [];
  scene.updateMatrixWorld(true);
  scene.traverse((part) => {
    if (!(part instanceof Mesh)) return;
    const geometry = (part.geometry as BufferGeometry).applyMatrix4(part.matrixWorld);
    if (!geometry.getAttribute('normal')) geometry.computeVertexNormals();
    const values = (name: string) => new Float32Array(geometry.getAttribute(name).array);
    const count = geometry.getAttribute('position').count;
    const index = geometry.getIndex()?.array ?? Uint32Array.from({length: count}, (_, vertex) => vertex);
    surfaces.push({positions: values('position'), normals: values('normal'), index: new Uint32Array(index)});
    geometry.dispose();
  });
  return surfaces;
}

function wallMaterial(look: Look, side: typeof BackSide | typeof FrontSide): ShaderMaterial {
  return new ShaderMaterial({
    glslVersion: GLSL3, vertexShader, fragmentShader, side, transparent: true, depthWrite: false,
    uniforms: {
      face_colour: {value: new Vector3(...look.face)},
      edge_colour: {value: new Vector3(...look.edge)},
      opacity: {value: look.opacity},
      sharpness: {value: look.sharpness},
    },
  });
}

function thinnedOut(surfaces: readonly Surface[]): Float32Array {
  const most = 1500;
  const total = surfaces.reduce((sum, surface) => sum + surface.positions.length / 3, 0);
  const stride = 3 * Math.max(1, Math.floor(total / most));
  const points: number[] = [];
  for (const {positions} of surfaces) {
    for (let i = 0; i + 2 < positions.length; i += stride) {
      points.push(positions[i] ?? 0, positions[i + 1] ?? 0, positions[i + 2] ?? 0);
    }
  }
  return new Float32Array(points);
}
