// The instrument as a tube along its nodes. The buffers are written in place each frame; the radius
// is a number of the shader, because the picture and its inset draw the same tube at two sizes.
import {BufferAttribute, BufferGeometry, DynamicDrawUsage, GLSL3, Mesh, ShaderMaterial} from 'three';
import {nodeStride} from '../../wire/frame';
import {forceColour, instrumentColour, type Rgb, tipColour} from './palette';

const sides = 8;
const tipLength_nodes = 3;

const vertexShader = `
  uniform float radius;
  in vec3 tint;
  out vec3 shade_normal;
  out vec3 shade_tint;
  void main() {
    shade_normal = normalMatrix * normal;
    shade_tint = tint;
    gl_Position = projectionMatrix * modelViewMatrix * vec4(position + normal * radius, 1.0);
  }`;

// light from the upper left behind the eye, and a dark edge that lifts the wire off the wall
const fragmentShader = `
  in vec3 shade_normal;
  in vec3 shade_tint;
  out vec4 colour;
  void main() {
    vec3 n = normalize(shade_normal);
    float light = max(0.0, dot(n, normalize(vec3(-0.35, 0.55, 0.75))));
    float edge = smoothstep(0.0, 0.45, n.z);
    colour = vec4(shade_tint * (0.42 + 0.58 * light) * (0.35 + 0.65 * edge), 1.0);
  }`;

export class InstrumentTube {
  readonly mesh: Mesh<BufferGeometry, ShaderMaterial>;
  private readonly material: ShaderMaterial;
  private capacity = 0;  // rings of vertices that fit
  private centres = new Float32Array(0);
  private normals = new Float32Array(0);
  private tints = new Float32Array(0);
  private readonly colour: [number, number, number] = [0, 0, 0];
  private readonly frame = new RingFrame();

  constructor(
    private readonly base: Rgb = instrumentColour,
    private readonly tip: Rgb = tipColour,
  ) {
    this.material = new ShaderMaterial({
      glslVersion: GLSL3, vertexShader, fragmentShader, uniforms: {radius: {value: 1}},
    });
    this.mesh = new Mesh(new BufferGeometry(), this.material);
    this.mesh.frustumCulled = false;
    this.mesh.visible = false;
  }

  /** Drawn radius, mm. */
  set radius(value: number) {
    const uniform = this.material.uniforms.radius;
    if (!uniform || uniform.value === value) return;
    uniform.value = value;
    this.material.uniformsNeedUpdate = true;
  }

  /** `force_n` belongs to each node; `limit_n` is where the colour is red. */
  update(nodes: Float32Array, count: number, force_n: Float32Array, limit_n: number): void {
    this.mesh.visible = count > 1;
    if (count < 2) return;
    if (count > this.capacity) this.grow(count);
    this.frame.start(nodes, count);
    for (let ring = 0; ring < count; ++ring) {
      if (ring > 0) this.frame.carry(nodes, ring, count);
      this.tintOf(ring, count, (force_n[ring] ?? 0) / limit_n);
      this.writeRing(nodes, ring);
    }
    const geometry = this.mesh.geometry;
    for (const name of ['position', 'normal', 'tint']) {
      const attribute = geometry.getAttribute(name) as BufferAttribute;
      attribute.clearUpdateRanges();
      attribute.addUpdateRange(0, count * sides * 3);
      attribute.needsUpdate = true;
    }
    geometry.setDrawRange(0, (count - 1) * sides * 6);
  }

  dispose(): void {
    this.mesh.geometry.dispose();
    this.material.dispose();
  }

  private writeRing(nodes: Float32Array, ring: number): void {
    const {u, v} = this.frame;
    const node = ring * nodeStride;
    for (let side = 0; side < sides; ++side) {
      const cosine = cosines[side] ?? 0;
      const sine = sines[side] ?? 0;
      const start = (ring * sides + side) * 3;
      for (let axis = 0; axis < 3; ++axis) {
        this.centres[start + axis] = nodes[node + axis] ?? 0;
        this.normals[start + axis] = (u[axis] ?? 0) * cosine + (v[axis] ?? 0) * sine;
        this.tints[start + axis] = this.colour[axis] ?? 0;
      }
    }
  }

  private tintOf(ring: number, count: number, part: number): void {
    const base = ring >= count - tipLength_nodes ? this.tip : this.base;
    forceColour(part, this.colour);
    const strength = Math.min(1, part * 12);  // a touch already shows
    for (let i = 0; i < 3; ++i) {
      const from = base[i] ?? 0;
      this.colour[i] = from + ((this.colour[i] ?? 0) - from) * strength;
    }
  }

  private grow(count: number): void {
    this.capacity = Math.ceil(count * 1.5);
    const length = this.capacity * sides * 3;
    this.centres = new Float32Array(length);
    this.normals = new Float32Array(length);
    this.tints = new Float32Array(length);
    const geometry = new BufferGeometry();
    const dynamic = (values: Float32Array) => new BufferAttribute(values, 3).setUsage(DynamicDrawUsage);
    geometry.setAttribute('position', dynamic(this.centres));
    geometry.setAttribute('normal', dynamic(this.normals));
    geometry.setAttribute('tint', dynamic(this.tints));
    geometry.setIndex(new BufferAttribute(tubeIndex(this.capacity), 1));
    this.mesh.geometry.dispose();
    this.mesh.geometry = geometry;
  }
}

const cosines = Float32Array.from({length: sides}, (_, i) => Math.cos((2 * Math.PI * i) / sides));
const sines = Float32Array.from({length: sides}, (_, i) => Math.sin((2 * Math.PI * i) / sides));

/** Two triangles per side between one ring and the next, counter-clockwise seen from outside. */
export function tubeIndex(rings: number): Uint32Array {
  const index = new Uint32Array(Math.max(0, rings - 1) * sides * 6);
  let at = 0;
  for (let ring = 0; ring + 1 < rings; ++ring) {
    for (let side = 0; side < sides; ++side) {
      const a = ring * sides + side;
      const b = ring * sides + ((side + 1) % sides);
      index.set([a, b, a + sides, b, b + sides, a + sides], at);
      at += 6;
    }
  }
  return index;
}

// Two unit vectors across the instrument, carried from node to node with the least turn.
class RingFrame {
  readonly u: [number, number, number] = [1, 0, 0];
  readonly v: [number, number, number] = [0, 1, 0];
  private readonly tangent: [number, number, number] = [0, 0, 1];

  start(nodes: Float32Array, count: number): void {
    this.findTangent(nodes, 0, count);
    const [x, y, z] = this.tangent.map(Math.abs) as [number, number, number];
    const u = this.u;
    // any axis that is not along the instrument
    [u[0], u[1], u[2]] = x <= y && x <= z ? [1, 0, 0] : y <= z ? [0, 1, 0] : [0, 0, 1];
    this.straighten();
  }

  carry(nodes: Float32Array, ring: number, count: number): void {
    this.findTangent(nodes, ring, count);
    this.straighten();
  }

  private findTangent(nodes: Float32Array, ring: number, count: number): void {
    const back = Math.max(0, ring - 1) * nodeStride;
    const ahead = Math.min(count - 1, ring + 1) * nodeStride;
    const t = this.tangent;
    const x = (nodes[ahead] ?? 0) - (nodes[back] ?? 0);
    const y = (nodes[ahead + 1] ?? 0) - (nodes[back + 1] ?? 0);
    const z = (nodes[ahead + 2] ?? 0) - (nodes[back + 2] ?? 0);
    const length = Math.hypot(x, y, z);
    if (length < 1e-9) return;  // two nodes in one place: keep the direction
    t[0] = x / length;
    t[1] = y / length;
    t[2] = z / length;
  }

  // u becomes normal to the tangent, v completes the frame
  private straighten(): void {
    const {u, v, tangent: t} = this;
    const off = u[0] * t[0] + u[1] * t[1] + u[2] * t[2];
    const x = u[0] - off * t[0];
    const y = u[1] - off * t[1];
    const z = u[2] - off * t[2];
    const length = Math.hypot(x, y, z) || 1;
    u[0] = x / length;
    u[1] = y / length;
    u[2] = z / length;
    v[0] = t[1] * u[2] - t[2] * u[1];
    v[1] = t[2] * u[0] - t[0] * u[2];
    v[2] = t[0] * u[1] - t[1] * u[0];
  }
}
