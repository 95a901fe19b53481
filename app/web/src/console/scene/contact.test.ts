import {describe, expect, it} from 'vitest';
import {ContactFinder} from './contact';

// a straight wire along x with a node each 2 mm
function wire(forces: Record<number, number>, count = 60): Float32Array {
  const nodes = new Float32Array(count * 4);
  for (let i = 0; i < count; ++i) {
    nodes[i * 4] = 2 * i;
    nodes[i * 4 + 3] = forces[i] ?? 0;
  }
  return nodes;
}

describe('the contact places', () => {
  it('sum the force over 6 mm of the instrument', () => {
    const finder = new ContactFinder(4);
    finder.update(wire({30: 0.1, 31: 0.2, 32: 0.1}), 60);
    expect(finder.placeCount).toBe(1);
    expect(finder.places[0]?.node).toBe(31);
    expect(finder.places[0]?.force_n).toBeCloseTo(0.4, 5);
  });

  it('come strongest first and keep their distance', () => {
    const finder = new ContactFinder(4);
    finder.update(wire({10: 0.2, 11: 0.15, 40: 0.5}), 60);
    const places = finder.places.slice(0, finder.placeCount);
    expect(places.map((place) => place.node)).toEqual([40, 10]);
    expect(places[1]?.force_n).toBeCloseTo(0.35, 5);
  });

  it('are none when nothing presses, also after a frame with contact', () => {
    const finder = new ContactFinder(4);
    finder.update(wire({10: 0.2}), 60);
    finder.update(wire({}), 60);
    expect(finder.placeCount).toBe(0);
    finder.update(wire({}, 0), 0);
    expect(finder.placeCount).toBe(0);
  });

  it('follow the arc of a bent wire, not the straight distance', () => {
    const finder = new ContactFinder(4);
    const nodes = wire({}, 3);
    // a hairpin: the ends lie 1 mm apart but 9 mm along the wire
    nodes.set([0, 0, 0, 0.1, 4, 0.5, 0, 0, 0, 1, 0, 0.1]);
    finder.update(nodes, 3);
    expect(finder.places[0]?.force_n).toBeCloseTo(0.1, 5);
  });
});
