// The vessel as one looks into it: the far wall dark and nearly solid, the near wall a breath with
// a bright outline. Loaded once per trial.
import {
  BackSide, BufferAttribute, BufferGeometry, FrontSide, GLSL3, Group, Mesh, type Object3D, ShaderMaterial, Vector3,
} from 'three';
import {GLTFLoader} from 'three/examples/jsm/loaders/GLTFLoader.js';
import {thinned} from './mesh_thinning';
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

export interface VesselModel {
  readonly group: Group;
  /** x, y, z of its corners, thinned out: enough to fit the camera. */
  readonly outline: Float32Array;
  dispose(): void;
}

/** Drawn with at most about `mostTriangles`. Rejects when the mesh cannot be had; the message is a sentence. */
export async function loadVessel(url: string, mostTriangles: number): Promise<VesselModel> {
  const file = await new GLTFLoader().loadAsync(url).catch(() => {
    throw new Error('The vessel could not be loaded. Check the connection and try again.');
  });
  const geometries = geometriesOf(file.scene).map((geometry) => lighter(geometry, mostTriangles));
  if (geometries.length === 0) throw new Error('The vessel holds no surface. Tell your administrator.');
  const materials = [wallMaterial(farWall, BackSide), wallMaterial(nearWall, FrontSide)];
  const group = new Group();
  for (const geometry of geometries) {
    materials.forEach((material, order) => {
      const wall = new Mesh(geometry, material);
      wall.renderOrder = order + 1;  // behind the instrument first, then over it
      group.add(wall);
    });
  }
  return {
    group,
    outline: thinnedOut(geometries),
    dispose: () => [...geometries, ...materials].forEach((part) => part.dispose()),
  };
}

// in the frame of the file, with whatever its nodes do to it
function geometriesOf(scene: Object3D): BufferGeometry[] {
  const geometries: BufferGeometry[] = [];
  scene.updateMatrixWorld(true);
  scene.traverse((part) => {
    if (!(part instanceof Mesh)) return;
    const geometry = (part.geometry as BufferGeometry).clone().applyMatrix4(part.matrixWorld);
    if (!geometry.getAttribute('normal')) geometry.computeVertexNormals();
    geometries.push(geometry);
  });
  return geometries;
}

function lighter(geometry: BufferGeometry, mostTriangles: number): BufferGeometry {
  const index = geometry.getIndex();
  if (!index || index.count / 3 <= mostTriangles) return geometry;
  const values = (name: string) => new Float32Array(geometry.getAttribute(name).array);
  const light = thinned(
    {positions: values('position'), normals: values('normal'), index: new Uint32Array(index.array)}, mostTriangles);
  geometry.dispose();
  const made = new BufferGeometry();
  made.setAttribute('position', new BufferAttribute(light.positions, 3));
  made.setAttribute('normal', new BufferAttribute(light.normals, 3));
  made.setIndex(new BufferAttribute(light.index, 1));
  return made;
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

function thinnedOut(geometries: readonly BufferGeometry[]): Float32Array {
  const most = 1500;
  const total = geometries.reduce((sum, geometry) => sum + geometry.getAttribute('position').count, 0);
  const stride = Math.max(1, Math.floor(total / most));
  const points: number[] = [];
  for (const geometry of geometries) {
    const position = geometry.getAttribute('position');
    for (let i = 0; i < position.count; i += stride) points.push(position.getX(i), position.getY(i), position.getZ(i));
  }
  return new Float32Array(points);
}
