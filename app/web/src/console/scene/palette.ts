// Colours of the 3-D view, as they leave the shader (sRGB, 0 to 1). Force runs from sand over
// orange to red, which stands for the limit, as everywhere in the lab.
export type Rgb = readonly [number, number, number];

export function rgb(hex: string): Rgb {
  const value = Number.parseInt(hex.slice(1), 16);
  return [((value >> 16) & 255) / 255, ((value >> 8) & 255) / 255, (value & 255) / 255];
}

export const instrumentColour = rgb('#cfdbe6');
export const tipColour = rgb('#ffffff');
export const wallColour = rgb('#a9777a');
export const wallEdgeColour = rgb('#d49a97');
export const wallInsideColour = rgb('#4c3033');
export const sheathColour = rgb('#6d7885');

const sand = rgb('#d9c58f');
const orange = rgb('#f0a35e');
const red = rgb('#ff7a6e');

/** `part` of the limit, 0 to 1. Writes into `out`. */
export function forceColour(part: number, out: [number, number, number]): void {
  const [from, to] = part < 0.5 ? [sand, orange] : [orange, red];
  const t = Math.min(1, part < 0.5 ? part * 2 : part * 2 - 1);
  for (let i = 0; i < 3; ++i) out[i] = (from[i] ?? 0) + ((to[i] ?? 0) - (from[i] ?? 0)) * t;
}

export function cssColour(colour: readonly number[]): string {
  return `rgb(${colour.map((part) => Math.round(part * 255)).join(' ')})`;
}

/** Radius of a contact ring on the screen, px. */
export function ringRadius(part: number): number {
  return 4 + 7 * Math.min(1, part);
}
