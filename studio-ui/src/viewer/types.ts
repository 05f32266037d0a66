// What the viewer is told and what it offers. It knows nothing of the page, the report or the notebook that hold it.
import type { Entity, LegEnds, Pose, Quaternion, SceneData, Vec3 } from "../protocol";

export type { Constructed, Construction, Limb, Pose, Quaternion, Recipe, Thresholds, Vec3, Verdict } from "../protocol";

export type Leg = LegEnds;
export type SceneEntity = Entity;

/** A curved surface: x, y, z of its corners in turn, and three corners a triangle, by number. */
export interface TriangleMesh {
  vertices: readonly number[];
  faces: readonly number[];
  /** Which corners are within the robot's limits; the others are pale. */
  reached: readonly boolean[];
  /** It is that of another pose: all of it is pale. */
  stale: boolean;
}

/** Where something is, and how it is turned. */
export interface Place {
  at: Vec3;
  turn: Quaternion;
}

/** What can be dragged by itself. */
export interface Grip {
  id: string;
  at: Vec3;
  /** How it is turned, if it can be. */
  turn?: Quaternion;
  /** A short name beside it, and one that is said aloud. */
  label: string;
  name: string;
  look: "stop" | "between" | "joint";
  /** How far an arrow key takes it; a hundredth of the size where it is not given. */
  step?: number;
}

/** What the engine tells of a robot in a pose, and what the host adds. */
export interface Scene extends SceneData {
  /** The pose at which `points` are given; the identity if missing (in `update`: the viewer's own pose). */
  pose?: Pose;
  /** Where the platform is, of a robot whose points all come from the host: the hand asks for a pose, and moves nothing. */
  handles?: Pose;
  /** Of a robot moved by its actuators: bars without names, and the limbs' ends, corners of the platform. */
  bars?: [Vec3, Vec3][];
  plate?: Vec3[];
  /** Another pose of the platform, drawn pale. */
  ghost?: Record<string, Vec3>;
  /** The way of the platform's centre, and where it is singular. */
  way?: { line: Vec3[]; singular: Vec3[] } | null;
  grips?: Grip[];
  /** The grip that the handles and keys take; the platform where it is null. */
  chosen?: string | null;
  /** Places of the platform's centre where the robot is singular. */
  surface?: TriangleMesh | null;
}

export type Mode = "orbit" | "translate" | "rotate" | "pick";
export type View = "iso" | "front" | "side" | "top" | "fit";
/** Where the camera is, and what it looks at. */
export interface Stand {
  eye: Vec3;
  target: Vec3;
}
export type Theme = "light" | "dark";
export type Layer = "entities" | "labels" | "legs" | "wrenches" | "grid" | "motion" | "surface" | "way";

export interface Highlight {
  points?: string[];
  entities?: string[];
  legs?: Leg[];
}

export interface Viewer {
  /** Another structure; the camera is fitted to it. */
  show(scene: Scene): void;
  /** All of what was shown has come by updates: the camera is fitted to it once, unless someone has chosen a view meanwhile. */
  whole(): void;
  /** New places of points, constructions or motion; the camera is kept. Cheap enough for the events of a slider. */
  update(part: Partial<Scene>): void;
  readonly pose: Pose;
  /** Where the points are, with the platform where it was moved to. */
  points(): Record<string, Vec3>;
  /** Moves the platform rigidly at once; `update` later brings what is computed for this pose. */
  setPose(pose: Pose): void;
  setMode(mode: Mode): void;
  highlight(what: Highlight | null): void;
  setView(name: View): void;
  /** Looks from a direction, from as far as before, and at robots that are shown later from there, too. */
  lookFrom(direction: Vec3): void;
  readonly stand: Stand;
  setStand(to: Stand): void;
  setTheme(theme: Theme): void;
  setVisible(layer: Layer, on: boolean): void;
  /** Swings a pale platform to and fro along the gained motion. */
  animateMotion(on: boolean): void;
  /** Where a point is seen, in CSS pixels from the element's upper left corner; null if it is not in front. */
  toScreen(name: string): [number, number] | null;
  /** The same of what can be dragged. */
  gripAt(id: string): [number, number] | null;
  /** The text of an SVG picture. */
  svg(): string;
  /** A data URL of a PNG picture, or the text of an SVG one. */
  snapshot(kind: "png" | "svg"): Promise<string>;
  /** Paints the view into a canvas, twice as fine as on the screen; with the gained motion swung so far, from −1 to 1. False where there are no pixels. */
  film(canvas: HTMLCanvasElement, swing: number | null): boolean;
  readonly renderer: "webgl" | "svg";
  dispose(): void;
}

export interface Options {
  /** The platform was moved by hand, or is to be; `done` at the end of a drag. At most once for each frame. */
  onPose?(pose: Pose, done: boolean): void;
  /** A grip was dragged; `done` at the end of a drag. */
  onGrip?(id: string, place: Place, done: boolean): void;
  /** A grip was pressed, or all were let go. */
  onChoose?(id: string | null): void;
  /** The chosen grip is to go, or one is to come after it. */
  onRemove?(id: string): void;
  onInsert?(id: string): void;
  onPick?(name: string): void;
  /** The view was turned: it is looked at from this direction, a unit vector. */
  onTurn?(direction: Vec3): void;
  onHover?(what: { point?: string; entity?: string } | null): void;
  /** Where the points are seen in which planes meet, with their labels or the arrows towards them: boxes as left, top, right, bottom. */
  onMarks?(boxes: readonly (readonly [number, number, number, number])[]): void;
  renderer?: "auto" | "svg";
  theme?: Theme;
  /** How many CSS pixels the host covers now from above and from below; standard views and fits leave them free. */
  covered?(): readonly [above: number, below: number];
  /** Whether the wheel zooms at any time, or only once the view was clicked, so that the page around it scrolls. */
  wheel?: "always" | "focused";
  /** Handles and keys that move the platform; on unless false. */
  gizmo?: boolean;
}
