import {describe, expect, it} from 'vitest';
import type {Frame} from '../../wire/frame';
import {NodeInterpolation} from './interpolation';

// nodes on the x axis, without force
let step = 0;
function frameOf(...x_mm: number[]): Frame {
  const nodes = new Float32Array(x_mm.flatMap((x) => [x, 0, 0, 0]));
  return {step: ++step, node_count: x_mm.length, nodes} as Frame;
}
const xs = (between: NodeInterpolation) => Array.from({length: between.count}, (_, i) => between.nodes[i * 4]);

describe('the picture between two frames', () => {
  it('is the first frame as it is', () => {
    const between = new NodeInterpolation();
    expect(between.sample(0)).toBe(false);
    between.push(frameOf(0, 2, 4), 100);
    expect(between.sample(100)).toBe(true);
    expect(xs(between)).toEqual([0, 2, 4]);
  });

  it('goes from one frame to the next in the time between frames, and no further', () => {
    const between = new NodeInterpolation();
    between.push(frameOf(0, 2, 4), 0);
    between.push(frameOf(1, 3, 5), 1000 / 60);
    between.sample(1000 / 60 + 1000 / 120);
    expect(xs(between).map((x) => Math.round((x ?? 0) * 100) / 100)).toEqual([0.5, 2.5, 4.5]);
    between.sample(500);
    expect(xs(between)).toEqual([1, 3, 5]);
    expect(between.sample(600)).toBe(false);
  });

  it('matches nodes from the tip when the instrument grows at the access', () => {
    const between = new NodeInterpolation();
    between.push(frameOf(0, 2, 4), 0);
    between.push(frameOf(0, 1, 3, 5), 1000 / 60);
    between.sample(1000 / 60);
    expect(xs(between)).toEqual([0, 0, 2, 4]);
  });

  it('and when it shrinks', () => {
    const between = new NodeInterpolation();
    between.push(frameOf(0, 1, 3, 5), 0);
    between.push(frameOf(0, 2, 4), 1000 / 60);
    between.sample(1000 / 60);
    expect(xs(between)).toEqual([1, 3, 5]);
  });

  it('rests while the simulation stands still', () => {
    const between = new NodeInterpolation();
    const frame = frameOf(0, 2, 4);
    between.push(frame, 0);
    between.sample(100);
    between.push({...frame, frame: 2}, 200);
    expect(between.sample(300)).toBe(false);
  });
});
