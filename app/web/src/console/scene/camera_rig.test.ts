import {describe, expect, it} from 'vitest';
import {basisOf, bestYaw, eyeOf, fieldOfView_deg, fit, orbit, type Vector, zoom} from './camera_rig';

const dot = (a: Vector, b: Vector) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

describe('the camera', () => {
  it('faces the patient from the front with the head up and the left on the right', () => {
    const {right, up, forward} = basisOf({yaw: 0, pitch: 0});
    expect(right).toEqual([1, 0, 0]);
    expect(up.map((part) => part + 0)).toEqual([0, 0, 1]);
    expect(forward.map((part) => part + 0)).toEqual([0, 1, 0]);
    expect(eyeOf({target: [1, 2, 3], yaw: 0, pitch: 0, distance: 10})).toEqual([1, -8, 3]);
  });

  it('keeps a right-handed frame of unit vectors wherever it looks from', () => {
    for (const [yaw, pitch] of [[0.3, -1.2], [2.5, 0.7], [-4, 1.4]] as const) {
      const {right, up, forward} = basisOf({yaw, pitch});
      const cross: Vector = [
        right[1] * forward[2] - right[2] * forward[1],
        right[2] * forward[0] - right[0] * forward[2],
        right[0] * forward[1] - right[1] * forward[0],
      ];
      expect(dot(cross, up)).toBeCloseTo(1, 12);
      expect(dot(forward, forward)).toBeCloseTo(1, 12);
    }
  });

  it('sees every point it fits, and no more than it must', () => {
    const points = new Float32Array([0, 0, 0, 40, 10, 300, -20, -15, 120, 35, 0, 200]);
    for (const [yaw, pitch] of [[0, 0], [1.1, 0.4], [-2, -0.8]] as const) {
      const view = fit(points, {yaw, pitch}, 1.3);
      const {right, up, forward} = basisOf(view);
      const eye = eyeOf(view);
      const half = Math.tan((fieldOfView_deg * Math.PI) / 360);
      let fullest = 0;
      for (let i = 0; i < points.length; i += 3) {
        const ray: Vector = [(points[i] ?? 0) - eye[0], (points[i + 1] ?? 0) - eye[1], (points[i + 2] ?? 0) - eye[2]];
        const depth = dot(ray, forward);
        const reach = Math.max(Math.abs(dot(ray, right)) / (half * 1.3), Math.abs(dot(ray, up)) / half) / depth;
        expect(reach).toBeLessThan(1);
        fullest = Math.max(fullest, reach);
      }
      expect(fullest).toBeGreaterThan(0.9);
    }
  });

  it('does not turn over the head, and zooms back to where it was', () => {
    const view = {target: [0, 0, 0] as Vector, yaw: 0, pitch: 0, distance: 100};
    expect(orbit(view, 0, 10_000).pitch).toBeLessThan(Math.PI / 2);
    expect(zoom(zoom(view, 3), -3).distance).toBeCloseTo(100, 9);
  });

  it('starts from the side only when the vessel bends that way', () => {
    expect(bestYaw(new Float32Array([0, 0, 0, 50, 5, 300]))).toBe(0);
    expect(bestYaw(new Float32Array([0, 0, 0, 5, 50, 300]))).toBeCloseTo(Math.PI / 2);
  });
});
