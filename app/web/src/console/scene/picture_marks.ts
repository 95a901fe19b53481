// The flat marks over the 3-D picture: contact rings with the strongest force beside them, the tip,
// the axes of the patient, a scale bar, the edge of the inset. Plain SVG, changed in place.
import {fixed} from '../readings';
import type {Basis, Vector} from './camera_rig';
import {cssColour, forceColour, ringRadius} from './palette';

export interface Spot {
  x: number;  // px
  y: number;
}

const textInterval_ms = 100;  // a number that changes faster cannot be read
const axisLength_px = 24;

export class PictureMarks {
  readonly root: SVGSVGElement;
  private readonly rings: SVGCircleElement[];
  private readonly insetRings: SVGCircleElement[];
  private readonly leader: SVGPathElement;
  private readonly force: SVGTextElement;
  private readonly tip: SVGGElement;
  private readonly insetTip: SVGCircleElement;
  private readonly inset: SVGRectElement;
  private readonly insetName: SVGTextElement;
  private readonly axes: {line: SVGLineElement; label: SVGTextElement; axis: Vector}[];
  private readonly axesGroup: SVGGElement;
  private readonly scaleGroup: SVGGElement;
  private readonly scaleBar: SVGPathElement;
  private readonly scaleText: SVGTextElement;
  private readonly colour: [number, number, number] = [0, 0, 0];
  private textChanged_ms = -Infinity;
  private width = 0;

  constructor(host: HTMLElement, ringCount: number) {
    this.root = add('svg', {'aria-hidden': 'true', 'class': 'picture-marks'}, host);
    this.inset = add('rect', {fill: 'none', stroke: 'var(--line-strong)', rx: 4}, this.root);
    this.insetName = add('text', {'class': 'ax'}, this.root);
    this.insetTip = add('circle', {r: 3.5, fill: 'none', stroke: 'var(--text)', 'stroke-width': 1.5}, this.root);
    this.insetRings = Array.from({length: ringCount}, () => add('circle', {fill: 'none', 'stroke-width': 1.5}, this.root));
    this.tip = add('g', {fill: 'none', stroke: 'var(--text)', 'stroke-width': 1.25}, this.root);
    add('path', {d: 'M-11 0h5M6 0h5M0 -11v5M0 6v5'}, this.tip);
    this.rings = Array.from({length: ringCount}, () => add('circle', {fill: 'none'}, this.root));
    this.leader = add('path', {fill: 'none', stroke: 'var(--line-strong)'}, this.root);
    this.force = add('text', {'class': 'lab'}, this.root);
    this.axesGroup = add('g', {stroke: 'var(--line-strong)'}, this.root);
    const directions: [string, Vector][] = [['L', [1, 0, 0]], ['A', [0, -1, 0]], ['H', [0, 0, 1]]];
    this.axes = directions.map(([name, axis]) => {
      const line = add('line', {x1: 0, y1: 0}, this.axesGroup);
      const label = add('text', {'class': 'ax m', 'stroke': 'none'}, this.axesGroup);
      label.textContent = name;
      return {line, label, axis};
    });
    this.scaleGroup = add('g', {}, this.root);
    this.scaleBar = add('path', {fill: 'none', stroke: 'var(--text-3)'}, this.scaleGroup);
    this.scaleText = add('text', {'class': 'ax', 'x': 0, 'y': -8}, this.scaleGroup);
  }

  resize(width: number, height: number, inset: {left: number; top: number; size: number}): void {
    this.width = width;
    set(this.root, {viewBox: `0 0 ${width} ${height}`, width, height});
    set(this.inset, {x: inset.left + 0.5, y: inset.top + 0.5, width: inset.size - 1, height: inset.size - 1});
    set(this.insetName, {x: inset.left + 8, y: inset.top + 18});
    set(this.axesGroup, {transform: `translate(${48} ${height - 48})`});
    set(this.scaleGroup, {transform: `translate(${100} ${height - 24})`});
  }

  nameInset(name: string): void {
    this.insetName.textContent = name;
  }

  showAxes(basis: Basis): void {
    for (const {line, label, axis} of this.axes) {
      const x = dot(axis, basis.right) * axisLength_px;
      const y = -dot(axis, basis.up) * axisLength_px;
      const faint = Math.hypot(x, y) < 0.3 * axisLength_px;  // it points at the eye or away from it
      set(line, {x2: x, y2: y, opacity: faint ? 0.3 : 1});
      set(label, {x: x * 1.45, y: y * 1.45 + 4, opacity: faint ? 0 : 1});
    }
  }

  showScale(mmPerPixel: number): void {
    const length_mm = roundLength(80 * mmPerPixel);
    const length_px = Math.round((length_mm / mmPerPixel) * 10) / 10;
    const path = `M0.5 -4v4h${length_px}v-4`;
    if (this.scaleBar.getAttribute('d') === path) return;
    set(this.scaleBar, {d: path});
    this.scaleText.textContent = `${length_mm} mm`;
  }

  showTip(main: Spot | null, inset: Spot | null): void {
    place(this.tip, main);
    centre(this.insetTip, inset);
  }

  /** `part` of the limit; null hides the ring. */
  showRing(index: number, main: Spot | null, inset: Spot | null, part: number): void {
    forceColour(part, this.colour);
    const stroke = cssColour(this.colour);
    const ring = this.rings[index];
    const small = this.insetRings[index];
    if (ring) {
      centre(ring, main);
      if (main) set(ring, {r: ringRadius(part), stroke, 'stroke-width': 1.5 + part});
    }
    if (small) {
      centre(small, inset);
      if (inset) set(small, {r: ringRadius(part) * 0.6, stroke});
    }
  }

  /** The force at the strongest contact, on the side of it that has room. */
  showForce(spot: Spot | null, force_n: number, part: number, now_ms: number): void {
    if (!spot) {
      this.force.textContent = '';
      set(this.leader, {d: ''});
      return;
    }
    const side = spot.x > this.width - 130 ? -1 : 1;
    const from = ringRadius(part) + 2;
    set(this.leader, {d: `M${tidy(spot.x + side * from)} ${tidy(spot.y)}h${side * 18}`});
    set(this.force, {x: spot.x + side * (from + 23), y: spot.y + 4, 'text-anchor': side > 0 ? 'start' : 'end'});
    if (now_ms - this.textChanged_ms < textInterval_ms && this.force.textContent !== '') return;
    this.textChanged_ms = now_ms;
    this.force.textContent = `${fixed(force_n, 2)} N`;
    forceColour(part, this.colour);
    this.force.style.fill = cssColour(this.colour);
  }
}

/** 1, 2 or 5 times a power of ten, at most `length`. */
export function roundLength(length: number): number {
  const power = 10 ** Math.floor(Math.log10(length));
  const lead = length / power;
  return (lead >= 5 ? 5 : lead >= 2 ? 2 : 1) * power;
}

type Attributes = Record<string, string | number>;

function add<Tag extends keyof SVGElementTagNameMap>(tag: Tag, attributes: Attributes, parent: Element): SVGElementTagNameMap[Tag] {
  const element = document.createElementNS('http://www.w3.org/2000/svg', tag);
  set(element, attributes);
  parent.append(element);
  return element;
}

function set(element: Element, attributes: Attributes): void {
  for (const [name, value] of Object.entries(attributes)) {
    const text = typeof value === 'number' ? tidy(value) : value;
    if (element.getAttribute(name) !== text) element.setAttribute(name, text);  // a change costs a repaint
  }
}

function tidy(value: number): string {
  return String(Math.round(value * 10) / 10);
}

function place(element: SVGElement, spot: Spot | null): void {
  show(element, spot !== null);
  if (spot) set(element, {transform: `translate(${tidy(spot.x)} ${tidy(spot.y)})`});
}

function show(element: SVGElement, visible: boolean): void {
  set(element, {visibility: visible ? 'visible' : 'hidden'});
}

function centre(circle: SVGCircleElement, spot: Spot | null): void {
  show(circle, spot !== null);
  if (spot) set(circle, {cx: spot.x, cy: spot.y});
}

function dot(a: Vector, b: Vector): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
