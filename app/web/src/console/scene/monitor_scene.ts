// The 3-D view of the console: vessel, instrument, marks, and the cameras of picture and inset.
// Draws when a frame came or the view changed, and rests otherwise. React only mounts it.
import {Color, PerspectiveCamera, Scene, Vector3, WebGLRenderer} from 'three';
import type {Frame} from '../../wire/frame';
import {nodeStride} from '../../wire/frame';
import {basisOf, bestYaw, eyeOf, fieldOfView_deg, fit, orbit, type View, zoom} from './camera_rig';
import {ContactFinder} from './contact';
import {DrawPacer, finishOf} from './draw_pacer';
import {InstrumentTube} from './instrument_tube';
import {NodeInterpolation} from './interpolation';
import {sheathColour} from './palette';
import {PictureMarks, type Spot} from './picture_marks';
import {closeLayer, type Detail, type VesselModel, wholeLayer} from './vessel_model';

export type ViewMode = 'whole' | 'follow';

export interface SceneSettings {
  /** what the big picture shows; the inset shows the other */
  readonly mode: ViewMode;
  /** the instrument as thin as it is, instead of thick enough to be seen */
  readonly trueSize: boolean;
}

export interface SceneInstrument {
  readonly radius_mm: number;
  /** the force that is drawn red */
  readonly fullForce_n: number;
}

const mostRings = 5;
const background = new Color('#0c0e11');
const wantedRadius_px = 1.9;
const mostThickening = 3;
const followHeight_mm = 90;      // what the picture shows around the tip
const followTime_s = 0.12;
const sheathLength_mm = 18;
const slowFrame_ms = 30;         // longer than this again and again: fewer pixels
const pixelRatios = [2, 1.5, 1, 0.75];

export class MonitorScene {
  private readonly renderer: WebGLRenderer;
  private readonly scene = new Scene();
  private readonly tube = new InstrumentTube();
  private readonly sheath = new InstrumentTube(sheathColour, sheathColour);
  private readonly contacts = new ContactFinder(mostRings);
  private readonly between = new NodeInterpolation();
  private readonly marks: PictureMarks;
  private readonly mainCamera = new PerspectiveCamera(fieldOfView_deg);
  private readonly insetCamera = new PerspectiveCamera(fieldOfView_deg);
  private readonly observer: ResizeObserver;
  private readonly point = new Vector3();
  private readonly tip = new Vector3();
  private vessel: VesselModel | null = null;
  private whole: View = {target: [0, 0, 0], yaw: 0, pitch: 0, distance: 800};
  private follow: View = {...this.whole, distance: distanceFor(followHeight_mm)};
  private settings: SceneSettings = {mode: 'whole', trueSize: false};
  private size = {width: 1, height: 1};
  private inset = {left: 0, top: 0, size: 1};
  private latest: Frame | null = null;
  private dirty = true;
  private request = 0;
  private drawn_ms = 0;
  private slowness_ms = 0;
  private ratio: number;
  private thickness = 1;
  private readonly pacer: DrawPacer;

  readonly detail: Detail;

  /** Throws when the browser has no WebGL 2. `thickened` hears how much thicker than life the instrument is drawn. */
  constructor(
    private readonly host: HTMLElement,
    private readonly instrument: SceneInstrument,
    private readonly thickened: (factor: number) => void,
  ) {
    const software = drawsInSoftware();
    this.detail = software ? {close: 14_000, whole: 3000} : {close: 600_000, whole: 600_000};
    this.pacer = new DrawPacer(software);
    this.renderer = new WebGLRenderer({antialias: !software, powerPreference: 'high-performance'});
    this.ratio = pixelRatios.find((ratio) => ratio <= window.devicePixelRatio) ?? 1;
    this.renderer.autoClear = false;
    this.renderer.domElement.setAttribute('aria-hidden', 'true');
    host.append(this.renderer.domElement);
    this.marks = new PictureMarks(host, mostRings);
    this.scene.add(this.tube.mesh, this.sheath.mesh);
    this.sheath.radius = instrument.radius_mm + 0.6;
    this.observer = new ResizeObserver(() => this.resize());
    this.observer.observe(host);
    this.resize();
    this.configure(this.settings);
    this.request = requestAnimationFrame(this.tick);
  }

  push(frame: Frame): void {
    const first = this.latest === null;
    this.latest = frame;
    this.between.push(frame, performance.now());
    if (first && frame.node_count > 1) this.begin(frame);
  }

  setVessel(vessel: VesselModel): void {
    if (this.vessel) this.scene.remove(this.vessel.group);
    this.vessel?.dispose();
    this.vessel = vessel;
    this.scene.add(vessel.group);
    this.reset();
  }

  configure(settings: SceneSettings): void {
    this.settings = settings;
    this.marks.nameInset(settings.mode === 'whole' ? 'Tip' : 'Whole vessel');
    this.dirty = true;
  }

  /** The view from the start: all of the vessel, from where most is seen. */
  reset(): void {
    const points = this.vessel?.outline ?? new Float32Array(0);
    this.whole = fit(points, {yaw: bestYaw(points), pitch: 0}, this.aspectOf('whole'));
    this.follow = {...this.follow, yaw: this.whole.yaw, pitch: 0, distance: distanceFor(followHeight_mm)};
    this.dirty = true;
  }

  orbit(dx_px: number, dy_px: number): void {
    this.whole = orbit(this.whole, dx_px, dy_px);
    this.follow = orbit(this.follow, dx_px, dy_px);
    this.dirty = true;
  }

  zoom(steps: number): void {
    if (this.settings.mode === 'whole') this.whole = zoom(this.whole, steps);
    else this.follow = zoom(this.follow, steps);
    this.dirty = true;
  }

  /** Whether a place on the host, in px, lies on the inset. */
  isOnInset(x: number, y: number): boolean {
    const {left, top, size} = this.inset;
    return x >= left && x <= left + size && y >= top && y <= top + size;
  }

  dispose(): void {
    cancelAnimationFrame(this.request);
    this.observer.disconnect();
    this.tube.dispose();
    this.sheath.dispose();
    this.vessel?.dispose();
    this.renderer.dispose();
    this.renderer.forceContextLoss();  // a browser has only a few contexts to give
    this.renderer.domElement.remove();
    this.marks.root.remove();
  }

  private readonly tick = (now_ms: number): void => {
    this.request = requestAnimationFrame(this.tick);
    if (!this.pacer.mayDraw(now_ms)) return;
    const moved = this.between.sample(performance.now());
    if (moved) this.shape();
    const swung = this.followTip((now_ms - this.drawn_ms) / 1000);
    if (!moved && !swung && !this.dirty) {
      this.drawn_ms = 0;
      return;
    }
    this.watchSpeed(now_ms);
    this.dirty = false;
    this.draw();
    this.pacer.drawn(now_ms, finishOf(this.renderer.getContext() as WebGL2RenderingContext));
    this.mark(now_ms);
  };

  // the sheath stands where the first node enters
  private begin(frame: Frame): void {
    const at = (node: number) => [0, 1, 2].map((axis) => frame.nodes[node * nodeStride + axis] ?? 0);
    const [access, next] = [at(0), at(1)];
    const inward = next.map((part, axis) => part - (access[axis] ?? 0));
    const length = Math.hypot(...inward) || 1;
    const outside = access.map((part, axis) => part - ((inward[axis] ?? 0) / length) * sheathLength_mm);
    this.sheath.update(new Float32Array([...outside, 0, ...access, 0]), 2, new Float32Array(2), 1);
    const last = at(frame.node_count - 1);
    this.follow = {...this.follow, target: [last[0] ?? 0, last[1] ?? 0, last[2] ?? 0]};
  }

  private shape(): void {
    const {nodes, count} = this.between;
    this.contacts.update(nodes, count);
    this.tube.update(nodes, count, this.contacts.windowForce_n, this.instrument.fullForce_n);
    this.locate(Math.max(0, count - 1), this.tip);
  }

  private followTip(seconds: number): boolean {
    if (this.between.count === 0) return false;
    const [x, y, z] = this.follow.target;
    const away = Math.hypot(this.tip.x - x, this.tip.y - y, this.tip.z - z);
    if (away < 0.02) return false;
    const part = 1 - Math.exp(-Math.min(0.1, Math.max(0, seconds)) / followTime_s);
    this.follow = {
      ...this.follow,
      target: [x + (this.tip.x - x) * part, y + (this.tip.y - y) * part, z + (this.tip.z - z) * part],
    };
    return true;
  }

  private draw(): void {
    const {width, height} = this.size;
    const {left, top, size} = this.inset;
    const [main, small] = this.settings.mode === 'whole' ? [this.whole, this.follow] : [this.follow, this.whole];
    this.aim(this.mainCamera, main, width / height);
    this.aim(this.insetCamera, small, 1);
    this.renderer.setScissorTest(false);
    this.renderer.setViewport(0, 0, width, height);
    this.paint(this.mainCamera, main, height);
    this.renderer.setScissorTest(true);
    this.renderer.setScissor(left, height - top - size, size, size);
    this.renderer.setViewport(left, height - top - size, size, size);
    this.paint(this.insetCamera, small, size);
  }

  private paint(camera: PerspectiveCamera, view: View, height: number): void {
    this.tube.radius = this.drawnRadius(view, height);
    this.renderer.setClearColor(background);
    this.renderer.clear();
    this.renderer.render(this.scene, camera);
  }

  private drawnRadius(view: View, height: number): number {
    const life = this.instrument.radius_mm;
    if (this.settings.trueSize) return life;
    return Math.min(mostThickening * life, Math.max(life, wantedRadius_px * mmPerPixel(view, height)));
  }

  private aim(camera: PerspectiveCamera, view: View, aspect: number): void {
    const {up} = basisOf(view);
    camera.layers.set(0);  // the instrument
    camera.layers.enable(view === this.whole ? wholeLayer : closeLayer);
    camera.aspect = aspect;
    camera.near = Math.max(1, view.distance * 0.05);
    camera.far = view.distance * 4 + 2000;
    camera.up.set(...up);
    camera.position.set(...eyeOf(view));
    camera.lookAt(...view.target);
    camera.updateProjectionMatrix();
    camera.updateMatrixWorld();
  }

  private mark(now_ms: number): void {
    const main = this.settings.mode === 'whole' ? this.whole : this.follow;
    const {height} = this.size;
    this.marks.showAxes(basisOf(main));
    this.marks.showScale(mmPerPixel(main, height));
    const tip = this.between.count > 0;
    this.marks.showTip(tip ? this.spotInMain(this.tip) : null, tip ? this.spotInInset(this.tip) : null);
    for (let i = 0; i < mostRings; ++i) this.markRing(i, now_ms);
    const factor = this.drawnRadius(main, height) / this.instrument.radius_mm;
    if (Math.abs(factor - this.thickness) < 0.05) return;
    this.thickness = factor;
    this.thickened(factor);
  }

  private markRing(index: number, now_ms: number): void {
    const place = this.contacts.places[index];
    const shown = place !== undefined && index < this.contacts.placeCount;
    if (shown) this.locate(place.node, this.point);
    const strongest = index === 0;
    // the strongest carries the number that the server computed
    const force_n = !shown ? 0 : strongest ? (this.latest?.contact_force_n ?? 0) : place.force_n;
    const part = force_n / this.instrument.fullForce_n;
    const inset = shown ? this.spotInInset(this.point) : null;
    const main = shown ? this.spotInMain(this.point) : null;
    this.marks.showRing(index, main, inset, part);
    if (strongest) this.marks.showForce(main, force_n, part, now_ms);
  }

  private locate(node: number, out: Vector3): void {
    const start = node * nodeStride;
    const {nodes} = this.between;
    out.set(nodes[start] ?? 0, nodes[start + 1] ?? 0, nodes[start + 2] ?? 0);
  }

  // null outside the picture and under the inset
  private spotInMain(place: Vector3): Spot | null {
    const spot = this.project(place, this.mainCamera, 0, 0, this.size.width, this.size.height);
    return spot && !this.isOnInset(spot.x, spot.y) ? spot : null;
  }

  private spotInInset(place: Vector3): Spot | null {
    const {left, top, size} = this.inset;
    return this.project(place, this.insetCamera, left, top, size, size);
  }

  private project(place: Vector3, camera: PerspectiveCamera, left: number, top: number, width: number, height: number): Spot | null {
    const {x, y, z} = this.projected.copy(place).project(camera);
    if (Math.abs(x) > 1 || Math.abs(y) > 1 || z > 1) return null;
    return {x: left + ((x + 1) / 2) * width, y: top + ((1 - y) / 2) * height};
  }
  private readonly projected = new Vector3();

  private aspectOf(view: ViewMode): number {
    return this.settings.mode === view ? this.size.width / this.size.height : 1;
  }

  private resize(): void {
    const width = Math.max(1, this.host.clientWidth);
    const height = Math.max(1, this.host.clientHeight);
    this.size = {width, height};
    const size = Math.round(Math.max(140, Math.min(320, 0.4 * Math.min(width, height))));
    this.inset = {left: width - size - 12, top: height - size - 12, size};
    this.renderer.setPixelRatio(this.ratio);
    this.renderer.setSize(width, height, false);
    this.marks.resize(width, height, this.inset);
    if (this.vessel) {
      this.whole = fit(this.vessel.outline, this.whole, this.aspectOf('whole'));
    }
    this.dirty = true;
  }

  // Fewer pixels where the machine cannot keep up; the number of frames matters more.
  private watchSpeed(now_ms: number): void {
    const gap = this.drawn_ms > 0 ? Math.min(100, now_ms - this.drawn_ms) : 0;
    this.drawn_ms = now_ms;
    this.slowness_ms += 0.04 * (gap - this.slowness_ms);
    const fewer = pixelRatios.find((ratio) => ratio < this.ratio);
    if (this.slowness_ms < slowFrame_ms || fewer === undefined) return;
    this.ratio = fewer;
    this.slowness_ms = 0;
    this.renderer.setPixelRatio(fewer);
  }
}

function mmPerPixel(view: View, height_px: number): number {
  return (2 * view.distance * Math.tan((fieldOfView_deg * Math.PI) / 360)) / height_px;
}

function distanceFor(height_mm: number): number {
  return height_mm / 2 / Math.tan((fieldOfView_deg * Math.PI) / 360);
}

function drawsInSoftware(): boolean {
  const context = document.createElement('canvas').getContext('webgl2');
  if (!context) return false;
  const names = context.getExtension('WEBGL_debug_renderer_info');
  const renderer: unknown = names ? context.getParameter(names.UNMASKED_RENDERER_WEBGL) : '';
  context.getExtension('WEBGL_lose_context')?.loseContext();
  return typeof renderer === 'string' && /swiftshader|llvmpipe|software/i.test(renderer);
}
