// Where one looks from. Orbits a point in the patient's frame (LPS: x left, y posterior, z head);
// yaw 0 looks from the front, as one faces the patient, with the patient's left on the right.
export type Vector = readonly [number, number, number];

export interface View {
  readonly target: Vector;
  readonly yaw: number;       // rad
  readonly pitch: number;     // rad, positive looks from above the head
  readonly distance: number;  // mm
}

export interface Basis {
  readonly right: Vector;
  readonly up: Vector;
  readonly forward: Vector;   // from the eye to the target
}

export const fieldOfView_deg = 26;
const steepest = 1.45;
const distances = {least: 25, most: 5000};

export function basisOf(view: Pick<View, 'yaw' | 'pitch'>): Basis {
  const [sy, cy] = [Math.sin(view.yaw), Math.cos(view.yaw)];
  const [sp, cp] = [Math.sin(view.pitch), Math.cos(view.pitch)];
  return {
    right: [cy, sy, 0],
    up: [-sy * sp, cy * sp, cp],
    forward: [-sy * cp, cy * cp, -sp],
  };
}

export function eyeOf(view: View): Vector {
  const {forward} = basisOf(view);
  return along(view.target, forward, -view.distance);
}

export function orbit(view: View, dx_px: number, dy_px: number): View {
  const perPixel = 0.008;
  const pitch = view.pitch + dy_px * perPixel;
  return {...view, yaw: view.yaw - dx_px * perPixel, pitch: Math.max(-steepest, Math.min(steepest, pitch))};
}

/** Negative steps come closer. */
export function zoom(view: View, steps: number): View {
  const distance = view.distance * 1.15 ** steps;
  return {...view, distance: Math.max(distances.least, Math.min(distances.most, distance))};
}

/** The view of all points in the given direction: as near as the picture allows, with some air. */
export function fit(points: Float32Array, direction: Pick<View, 'yaw' | 'pitch'>, aspect: number): View {
  const {right, up, forward} = basisOf(direction);
  const halfHeight = Math.tan((fieldOfView_deg * Math.PI) / 360);
  const halfWidth = halfHeight * aspect;
  const box = [right, up, forward].map((axis) => extent(points, axis)) as [Range, Range, Range];
  const middle = box.map((range) => (range.low + range.high) / 2) as [number, number, number];
  let distance = distances.least;
  for (let i = 0; i + 2 < points.length; i += 3) {
    const depth = dot(points, i, forward) - middle[2];
    const across = Math.abs(dot(points, i, right) - middle[0]) / halfWidth;
    const upwards = Math.abs(dot(points, i, up) - middle[1]) / halfHeight;
    distance = Math.max(distance, Math.max(across, upwards) - depth);
  }
  const target = along(along(along([0, 0, 0], right, middle[0]), up, middle[1]), forward, middle[2]);
  return {target, yaw: direction.yaw, pitch: direction.pitch, distance: distance * 1.06};
}

/** Of the front and the side, the one from which more can be seen. */
export function bestYaw(points: Float32Array): number {
  const width = (range: Range) => range.high - range.low;
  const left = width(extent(points, [1, 0, 0]));
  const depth = width(extent(points, [0, 1, 0]));
  return depth > 1.2 * left ? Math.PI / 2 : 0;
}

interface Range {
  low: number;
  high: number;
}

function extent(points: Float32Array, axis: Vector): Range {
  const range: Range = {low: Infinity, high: -Infinity};
  for (let i = 0; i + 2 < points.length; i += 3) {
    const value = dot(points, i, axis);
    if (value < range.low) range.low = value;
    if (value > range.high) range.high = value;
  }
  return range.low <= range.high ? range : {low: 0, high: 0};
}

function dot(points: Float32Array, start: number, axis: Vector): number {
  return (points[start] ?? 0) * axis[0] + (points[start + 1] ?? 0) * axis[1] + (points[start + 2] ?? 0) * axis[2];
}

function along(from: Vector, axis: Vector, by: number): Vector {
  return [from[0] + axis[0] * by, from[1] + axis[1] * by, from[2] + axis[2] * by];
}
