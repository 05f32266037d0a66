// The camera in the user's hands: orbit and zoom by pointer or keys, standard views, and the flight from one to another.
import { MathUtils, Spherical, Vector3 } from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { between, clip, directionOf, newCamera, stand } from "./camera";
import type { Model } from "./drawing";
import { framed, holds, tips, type Pane } from "./framing";
import type { Extent } from "./gizmo";
import { sightOf, type Sight } from "./sight";
import type { Options, Stand, Vec3, View } from "./types";
import { along, distance, sub, unit } from "./vectors";

const FLIGHT = 280; // milliseconds from one view to another
const ROUNDS = 8; // until handles, which are as large from any distance, have their room

/** Whether the user wants nothing to move by itself. */
export const calm = (): boolean => matchMedia("(prefers-reduced-motion: reduce)").matches;

export class Rig {
  readonly camera = newCamera();
  width = 1;
  height = 1;
  /** What handles the platform has, which are to be in sight; those of grips have no room of their own. */
  handles: () => Extent | null = () => null;
  private readonly orbit: OrbitControls;
  private flight: { from: Stand; to: Stand; start: number } | null = null;
  private size = 1;
  /** From where robots are looked at; null for the most telling direction. */
  private from: Vec3 | null = null;
  private turned: Vec3 = [0, 0, 0];
  /** Whether the drawing is to be fitted when it is next made, and whether parts of it are still to come. */
  private due = false;
  private resized = false;
  private awaiting = false;
  private met = new Set<string>();
  private wider = false;
  /** Whether someone has chosen the view since another robot came. */
  private chosen = false;

  constructor(
    surface: HTMLElement,
    private readonly changed: () => void,
    private readonly options: Options,
  ) {
    this.orbit = new OrbitControls(this.camera, surface);
    this.orbit.enableDamping = !calm();
    this.orbit.dampingFactor = 0.14;
    this.orbit.addEventListener("change", changed);
    this.orbit.addEventListener("start", () => (this.chosen = true));
    if (options.wheel !== "focused") return;
    this.orbit.enableZoom = false;
    surface.addEventListener("focus", () => (this.orbit.enableZoom = true));
    surface.addEventListener("blur", () => (this.orbit.enableZoom = false));
  }

  /** Whether dragging turns the view. */
  set enabled(on: boolean) {
    this.orbit.enabled = on;
  }

  get sight(): Sight {
    return sightOf(this.camera, this.width, this.height);
  }
  get stand(): Stand {
    return { eye: this.camera.position.toArray() as Vec3, target: this.orbit.target.toArray() as Vec3 };
  }

  /** Where more is covered than leaves most of the picture, the rest of it is drawn upon. */
  private get pane(): Pane {
    const { width, height, camera } = this;
    const most = (side: number): number => Math.min(side, 0.3 * height);
    const [above, below] = this.options.covered?.() ?? [0, 0];
    const covered = [most(above), most(below)] as const;
    return { width, height, covered, fov: camera.fov, letter: this.sight.letter };
  }

  private fitted(model: Model, direction: Vec3): Stand {
    const [pane, handles] = [this.pane, this.handles()];
    let found = framed(model.frame, direction, pane);
    for (let k = 0; handles && k < ROUNDS; k++) found = framed([...model.frame, ...tips(handles, found, pane.fov)], direction, pane);
    return found;
  }

  /** Handles have come: they are to be in sight. */
  reveal(model: Model): void {
    const handles = this.handles();
    if (handles && !holds(tips(handles, this.stand, this.camera.fov), this.stand, this.pane)) this.view("fit", model);
  }

  /** Until someone chooses a view, the drawing is fitted to each size that the picture gets, from where it is looked at. */
  resize(width: number, height: number): void {
    this.resized ||= !this.chosen && (width !== this.width || height !== this.height);
    [this.width, this.height] = [width, height];
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
  }

  /** Another robot: it is fitted when it is first drawn. */
  expect(entities: readonly string[]): void {
    this.due = this.awaiting = true;
    this.chosen = false;
    this.met = new Set(entities);
  }

  /** All of it has come: it is fitted once more, unless the view was chosen meanwhile. */
  whole(): void {
    this.due ||= this.awaiting && !this.chosen;
    this.awaiting = false;
  }

  /** Entities are drawn: those that were not before are to be seen, unless someone has chosen the view. */
  widen(entities: readonly string[]): void {
    this.wider ||= !this.chosen && entities.some((id) => !this.met.has(id));
    entities.forEach((id) => this.met.add(id));
  }

  /** At once to where the whole drawing is seen, if that is due; in a flight, if more is drawn and is not all in sight. */
  fit(model: Model): void {
    const { due, resized, wider } = this;
    this.due = this.resized = this.wider = false;
    if (due || resized) {
      const { eye, target } = this.stand;
      this.flight = null;
      this.size = model.radius;
      this.go(this.fitted(model, due ? (this.from ?? directionOf("iso", model)) : sub(eye, target)));
    } else if (wider && !this.flight && !holds(model.frame, this.stand, this.pane)) this.view("fit", model);
  }

  /** At once to where one stood before. */
  take(to: Stand, model: Model): void {
    this.flight = null;
    this.due = this.resized = false;
    this.chosen = true;
    this.size = model.radius;
    this.go(to);
  }

  lookFrom(direction: Vec3): void {
    this.flight = null;
    this.from = direction;
    const { eye, target } = this.stand;
    if (!this.due) this.go({ eye: along(target, direction, distance(eye, target)), target });
    this.changed();
  }

  view(name: View, model: Model): void {
    const { eye, target } = this.stand;
    this.chosen ||= name !== "fit";
    const to = this.fitted(model, name === "fit" ? sub(eye, target) : directionOf(name, model));
    if (calm()) this.go(to);
    else this.flight = { from: this.stand, to, start: performance.now() };
    this.changed();
  }

  /** The camera at a time; true while it is under way. */
  advance(now: number, size: number): boolean {
    this.size = size;
    let moving = false;
    if (this.flight) {
      const t = MathUtils.clamp((now - this.flight.start) / FLIGHT, 0, 1);
      this.go(between(this.flight.from, this.flight.to, t));
      if (t === 1) this.flight = null;
      moving = true;
    } else if (this.orbit.enableDamping) moving = this.orbit.update();
    clip(this.camera, this.orbit.target, size);
    this.tellTurn();
    return moving;
  }

  /** The user takes over. */
  halt(): void {
    this.flight = null;
  }

  /** What is moved by hand in this view is not to jump. */
  keep(): void {
    this.chosen = true;
  }

  turn(azimuth: number, polar: number): void {
    const arm = new Vector3().subVectors(this.camera.position, this.orbit.target);
    // three's spherical coordinates have y up
    const ball = new Spherical().setFromCartesianCoords(arm.y, arm.z, arm.x);
    ball.theta += azimuth;
    ball.phi = MathUtils.clamp(ball.phi + polar, 0.01, Math.PI - 0.01);
    const [y, z, x] = new Vector3().setFromSpherical(ball).toArray();
    this.camera.position.copy(this.orbit.target).add(new Vector3(x, y, z));
    this.moved();
  }

  zoom(factor: number): void {
    this.camera.position.sub(this.orbit.target).multiplyScalar(factor).add(this.orbit.target);
    this.moved();
  }

  dispose(): void {
    this.orbit.dispose();
  }

  private tellTurn(): void {
    const { eye, target } = this.stand;
    const direction = unit(sub(eye, target));
    if (distance(direction, this.turned) < 1e-9) return;
    this.turned = direction;
    this.options.onTurn?.(direction);
  }

  private moved(): void {
    this.chosen = true;
    this.orbit.update();
    this.changed();
  }

  private go(to: Stand): void {
    this.orbit.minDistance = 0.3 * this.size;
    this.orbit.maxDistance = 40 * this.size;
    stand(this.camera, this.orbit.target, to, this.size);
    this.orbit.update();
  }
}
