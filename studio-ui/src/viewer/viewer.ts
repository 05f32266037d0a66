// The viewer: puts scene, camera, handles and painter together. It draws only when something has changed.
import { compassBox } from "./compass";
import type { Model } from "./drawing";
import { newEasel, type Easel } from "./easel";
import { Gizmo } from "./gizmo";
import { Grasp } from "./grasp";
import { gripAt, placeOf, poseOf } from "./grips";
import { Hand, type Pointed, type Reach } from "./hand";
import { poseInWords } from "./keys";
import { boxesOf, pointersOf, takenBy } from "./marks";
import { modelOf } from "./model";
import { placeTags } from "./overlay";
import { entityAt, pointAt } from "./picking";
import { paintPixels, pngPicture, svgPicture, type Shot } from "./picture";
import { IDENTITY, sceneAt } from "./pose";
import { calm, Rig } from "./rig";
import type { Sight } from "./sight";
import { Surface, titleOf } from "./surface";
import { splitDrawing } from "./svg";
import type { Grip, Highlight, Layer, Mode, Options, Place, Pose, Scene, Stand, Theme, Vec3, View, Viewer } from "./types";
import { add } from "./vectors";

const SWING = 2400; // milliseconds for a swing to and fro
const EMPTY: Scene = { points: {}, base: [], platform: [], legs: [], about: [0, 0, 0], size: 1, unit: "", entities: [] };

export function createViewer(host: HTMLElement, options: Options = {}): Viewer {
  return new Stage(host, options);
}

class Stage implements Viewer, Reach {
  scene = EMPTY;
  mode: Mode = "orbit";
  readonly surface: Surface;
  readonly rig: Rig;
  /** Where the points of the scene were given, and where the platform is. */
  private given = IDENTITY;
  private current = IDENTITY;
  private asked: Pose | null = null;
  private moving: { id: string; place: Place } | null = null;
  private theme: Theme;
  private wish: Highlight | null = null;
  private pointed: Pointed | null = null;
  private readonly hidden = new Set<Layer>();
  private animated = false;
  /** How far the gained motion has swung, from −1 to 1, while it is filmed. */
  private filmed: number | null = null;

  private readonly easel: Easel;
  private readonly gizmo: Gizmo | null = null;
  private readonly hand: Hand;
  private readonly resizing: ResizeObserver;
  private readonly stop = new AbortController();

  private model: Model | null = null;
  private split: ReturnType<typeof splitDrawing> = null;
  private stale = true;
  private frame = 0;
  private pending = false;

  constructor(host: HTMLElement, private readonly options: Options) {
    this.theme = options.theme ?? "light";
    this.surface = new Surface(host, options.gizmo !== false);
    const { root } = this.surface;
    this.easel = newEasel(root, options.renderer ?? "auto", () => this.changed());
    this.rig = new Rig(root, () => this.request(), options);
    if (options.gizmo !== false) {
      this.gizmo = new Gizmo(this.rig.camera, root, {
        moved: (pose) => (this.held ? this.gripMoved(this.held.id, placeOf(pose, this.scene.about)) : this.moved(pose)),
        done: () => (this.held ? this.gripDone() : this.done()),
        dragging: (on) => (this.rig.enabled = !on),
        changed: () => this.request(),
      });
      this.easel.hold(this.gizmo);
      this.rig.handles = () => (this.held ? null : (this.gizmo?.extent ?? null));
    }
    new Grasp(this, this.stop.signal);
    this.hand = new Hand(this, this.stop.signal);
    this.resizing = new ResizeObserver(() => host.clientWidth && this.resize()); // hidden, as on paper, it keeps its size
    this.resizing.observe(host);
    this.setTheme(this.theme);
    this.resize();
  }

  // --- what the host may ask -----------------------------------------------------------------------------------

  get renderer(): "webgl" | "svg" {
    return this.easel.kind;
  }

  show(scene: Scene): void {
    this.scene = scene;
    this.given = this.current = scene.pose ?? IDENTITY;
    this.asked = null;
    this.pointed = null;
    this.hand.forget();
    this.rig.expect(scene.entities.map(({ id }) => id));
    this.surface.describe(scene);
    this.changed();
  }

  update(part: Partial<Scene>): void {
    this.rig.widen([...(part.entities ?? []).map(({ id }) => id), ...(part.planes ?? []).map(({ label }) => `plane ${label}`)]);
    this.scene = { ...this.scene, ...part };
    if (part.surface !== undefined || part.grips !== undefined) this.surface.describe(this.scene);
    if (part.pose) this.given = part.pose;
    else if (part.points) this.given = this.current;
    this.changed();
  }

  whole(): void {
    this.rig.whole();
    this.changed();
  }

  get pose(): Pose {
    return this.current;
  }

  points(): Record<string, Vec3> {
    return this.posed().points;
  }

  setPose(pose: Pose): void {
    this.current = pose;
    this.changed();
  }

  setMode(mode: Mode): void {
    this.mode = mode;
    this.gizmo?.setMode(mode);
    if (this.rig.handles()) this.rig.reveal(this.fresh());
    this.surface.cursor = mode === "pick" ? "crosshair" : "grab";
    this.request();
  }

  highlight(what: Highlight | null): void {
    this.wish = what;
    this.changed();
  }

  setView(name: View): void {
    this.rig.view(name, this.fresh());
  }

  lookFrom(direction: Vec3): void {
    this.rig.lookFrom(direction);
  }
  get stand(): Stand {
    return this.rig.stand;
  }
  setStand(to: Stand): void {
    this.rig.take(to, this.fresh());
  }

  setTheme(theme: Theme): void {
    this.theme = theme;
    this.surface.paint(theme);
    this.changed();
  }

  setVisible(layer: Layer, on: boolean): void {
    if (on) this.hidden.delete(layer);
    else this.hidden.add(layer);
    this.surface.measure(!this.hidden.has("grid"));
    this.changed();
  }

  animateMotion(on: boolean): void {
    this.animated = on;
    this.changed();
  }

  toScreen(name: string): [number, number] | null {
    return this.onScreen(this.posed().points[name]);
  }

  gripAt(id: string): [number, number] | null {
    return this.onScreen(this.scene.grips?.find((grip) => grip.id === id)?.at);
  }

  private onScreen(at: Vec3 | undefined): [number, number] | null {
    if (!at) return null;
    this.fresh();
    const [x, y, depth] = this.rig.sight.place(at);
    return depth > this.rig.camera.near ? [x, y] : null;
  }

  svg(): string {
    return svgPicture(this.shot());
  }

  async snapshot(kind: "png" | "svg"): Promise<string> {
    if (kind === "svg") return this.svg();
    const shot = this.shot();
    this.paintAlone();
    return pngPicture(shot, this.easel.canvas);
  }

  film(canvas: HTMLCanvasElement, swing: number | null): boolean {
    const drawn = this.easel.canvas;
    if (!drawn) return false;
    this.filmed = swing;
    this.stale = true;
    const shot = this.shot();
    this.paintAlone();
    paintPixels(canvas, shot, drawn, shot.labels);
    this.filmed = null;
    this.changed();
    return true;
  }

  private shot(): Shot {
    const model = this.fresh();
    const { sight } = this.rig;
    const pointers = pointersOf(model, sight);
    const corner = this.hidden.has("grid") ? [] : [compassBox(sight.height)];
    const labels = [...placeTags(model, sight, [...takenBy(pointers), ...corner]), ...pointers.map(({ label }) => label)];
    return { model, split: this.split, sight, labels, pointers, theme: this.theme, title: titleOf(this.scene) };
  }

  /** Paints the drawing without the handles of the platform. */
  private paintAlone(): void {
    const handles = this.gizmo?.helper;
    const shown = handles?.visible ?? false;
    if (handles) handles.visible = false;
    this.easel.paint(this.rig.camera, this.rig.sight);
    if (handles) handles.visible = shown;
    this.request();
  }

  dispose(): void {
    cancelAnimationFrame(this.frame);
    this.frame = -1;
    this.stop.abort();
    this.resizing.disconnect();
    this.gizmo?.dispose();
    this.rig.dispose();
    this.easel.dispose();
    this.surface.root.remove();
  }

  // --- drawing -------------------------------------------------------------------------------------------------

  /** The scene is to be drawn anew. */
  private changed(): void {
    this.stale = true;
    this.request();
  }

  /** A frame is wanted, the drawing may be the same. */
  private request(): void {
    if (this.frame === 0) this.frame = requestAnimationFrame((now) => this.draw(now));
  }

  private draw(now: number): void {
    this.frame = 0;
    if (this.pending) this.tell(false);
    if (this.swings) this.changed();
    const { about } = this.scene;
    const model = this.fresh(now);
    if (this.rig.advance(now, model.radius)) this.request();
    this.gizmo?.place(this.held ? poseOf(this.held, about) : this.platform, about);
    const { sight, labels, pointers } = this.shot();
    this.easel.paint(this.rig.camera, sight);
    this.surface.show(model, labels, pointers, this.rig.camera, this.theme);
    this.options.onMarks?.(boxesOf(model, sight, labels, pointers));
  }

  private get swings(): boolean {
    return this.animated && Boolean(this.scene.motion) && !this.hidden.has("motion") && !calm();
  }

  /** The scene with the platform where it was moved to. */
  private posed(): Scene {
    return sceneAt(this.scene, this.given, this.current);
  }

  /** The drawing of the scene as it is now. */
  private fresh(now = performance.now()): Model {
    if (!this.stale && this.model) return this.model;
    this.stale = false;
    const points = [...(this.wish?.points ?? []), ...(this.pointed?.point ? [this.pointed.point] : [])];
    const entities = [...(this.wish?.entities ?? []), ...(this.pointed?.entity ? [this.pointed.entity] : [])];
    const swing = this.filmed ?? (this.animated ? (calm() ? 1 : Math.sin((2 * Math.PI * now) / SWING)) : null);
    const highlight = { points, entities, legs: this.wish?.legs ?? [] };
    const centre = add(this.scene.about, this.platform.translation as Vec3);
    this.model = modelOf(this.posed(), { theme: this.theme, highlight, hidden: this.hidden, swing, centre });
    this.split = splitDrawing(this.model);
    this.easel.load(this.model, this.split, this.theme);
    this.rig.fit(this.model);
    return this.model;
  }

  private resize(): void {
    const { root } = this.surface;
    const [width, height] = [Math.max(root.clientWidth, 1), Math.max(root.clientHeight, 1)];
    this.rig.resize(width, height);
    this.easel.resize(width, height);
    this.gizmo?.resize(height);
    if (!this.model) return this.request();
    this.rig.fit(this.model);
    cancelAnimationFrame(this.frame);
    this.draw(performance.now()); // at once: the canvas was emptied, and would be seen so for a frame
  }

  // --- hands ---------------------------------------------------------------------------------------------------

  get movable(): boolean {
    return this.gizmo !== null;
  }
  get grabbed(): boolean {
    return this.gizmo?.grabbed ?? false;
  }

  get sight(): Sight {
    return this.rig.sight;
  }
  get chosen(): Grip | null {
    return this.scene.grips?.find(({ id }) => id === this.scene.chosen) ?? null;
  }
  /** The grip that has the handles, if it can do what they do. */
  private get held(): Grip | null {
    return this.mode === "rotate" && !this.chosen?.turn ? null : this.chosen;
  }

  gripUnder(x: number, y: number, reach: number): Grip | null {
    return gripAt(this.scene.grips ?? [], this.chosen, this.sight, x, y, reach);
  }

  chose(id: string | null): void {
    this.options.onChoose?.(id);
  }

  removed(id: string): void {
    this.options.onRemove?.(id);
  }

  inserted(id: string): void {
    this.options.onInsert?.(id);
  }

  gripMoved(id: string, place: Place): void {
    this.rig.keep();
    this.moving = { id, place };
    this.options.onGrip?.(id, place, false);
  }

  gripDone(): void {
    if (this.moving) this.options.onGrip?.(this.moving.id, this.moving.place, true);
    this.moving = null;
  }

  under(x: number, y: number, reach: number): Pointed {
    const { sight } = this.rig;
    const point = pointAt(this.posed(), sight, x, y, reach);
    if (point) return { point };
    const entity = !this.hidden.has("entities") && entityAt(this.fresh(), this.split, sight, x, y);
    return entity ? { entity } : {};
  }

  hovered(found: Pointed | null): void {
    this.pointed = found;
    this.options.onHover?.(found);
    this.changed();
  }

  picked(name: string): void {
    this.options.onPick?.(name);
  }

  /** Where the hand has the platform. */
  get platform(): Pose {
    return this.asked ?? this.scene.handles ?? this.current;
  }

  /** The host hears of moves at most once a frame, of the end of a move at once. */
  moved(pose: Pose): void {
    if (this.scene.handles) this.asked = pose;
    else this.current = pose;
    this.pending = true;
    this.changed();
  }

  done(): void {
    if (this.pending) this.tell(false);
    this.tell(true);
    this.surface.say(poseInWords(this.platform, this.scene.unit));
    this.asked = null;
  }

  fit(): void {
    this.setView("fit");
  }

  private tell(done: boolean): void {
    this.pending = false;
    this.options.onPose?.(this.platform, done);
  }
}
