import {describe, expect, it} from 'vitest';
import {DrawPacer} from './draw_pacer';

function finishAt(reached: {value: boolean}) {
  return {isReached: () => reached.value, forget: () => undefined};
}

describe('the pace of drawing', () => {
  it('waits for the last picture, and for nothing else on a fast machine', () => {
    const pacer = new DrawPacer(false);
    const reached = {value: false};
    expect(pacer.mayDraw(0)).toBe(true);
    pacer.drawn(0, finishAt(reached));
    expect(pacer.mayDraw(16)).toBe(false);
    reached.value = true;
    expect(pacer.mayDraw(33)).toBe(true);
  });

  it('leaves as much time as a picture took where the processor draws', () => {
    const pacer = new DrawPacer(true);
    const reached = {value: false};
    pacer.drawn(100, finishAt(reached));
    reached.value = true;
    expect(pacer.mayDraw(140)).toBe(false);
    expect(pacer.mayDraw(170)).toBe(false);
    expect(pacer.mayDraw(180)).toBe(true);
  });

  it('goes on when a finish is never reported', () => {
    const pacer = new DrawPacer(false);
    pacer.drawn(0, finishAt({value: false}));
    expect(pacer.mayDraw(200)).toBe(false);
    expect(pacer.mayDraw(300)).toBe(true);
  });
});
