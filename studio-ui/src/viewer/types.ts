// What the viewer is told and what it offers. It knows nothing of the page, the report or the notebook that hold it.
import type { Constructed, LimbView, Numbers, Pose, Vec3 } from "../protocol";

export type { Constructed, LimbView, Pose, Quaternion, Vec3 } from "../protocol";

export interface Recipe {
  lines: { label: string; colour: number; of: Construction }[];
  points: { label: string; of: Construction[]; entities: string[] }[];
  /** Below this share of the size a point is shown in which planes nearly meet. */
  near: number;
  /** Below this closeness a pose counts as close to singular. */
  close: number;
  /** 1, or −1 where the legs of the scene are turned round with respect to those that the user wrote. */
  sign: number;
}
/** A joint, or the join or the meet of constructions. */
export type Construction = string | ["join" | "meet", ...Construction[]];

export type Leg = [string, string];

export interface SceneEntity {
  id: string;
  kind: "tetrahedron" | "plane" | "line" | "point";
  points: string[];
  /** With stars: A*bd. */
  label: string;
  /** Number of its colour, counted from 0; six colours repeat. */
  colour: number;
}

/** A robot in a pose and what is to be seen of its condition: plain data. Lengths in one unit, z is up. */
export interface Scene {
  points: Record<string, Vec3>;
  base: string[];
  platform: string[];
  legs: Leg[];
  /** Centre of the platform's turns. */
  about: Vec3;
  /** A length that the camera, the balls and the handles are scaled by. */
  size: number;
  unit: string;
  /** The pose at which `points` are given; the identity if missing (in `update`: the viewer's own pose). */
  pose?: Pose;
  entities: SceneEntity[];
  constructed?: Constructed[];
  motion?: Numbers["motion"];
  limbs?: LimbView[];
  /** Planes normal · p = offset that are no entities; a part around places of theirs, if some are given. */
  planes?: { label: string; normal: Vec3; offset: number; through?: Vec3[]; colour?: number }[];
  /** Another pose of the platform, drawn pale. */
  ghost?: Record<string, Vec3>;
  /** How what is constructed follows from the joints, for pages that have no server (`numbersAt`). */
  recipe?: Recipe;
}

export type Mode = "orbit" | "translate" | "rotate" | "pick";
export type View = "iso" | "front" | "side" | "top" | "fit";
export type Theme = "light" | "dark";
export type Layer = "entities" | "labels" | "legs" | "wrenches" | "grid" | "motion";

export interface Highlight {
  points?: string[];
  entities?: string[];
  legs?: Leg[];
}

export interface Viewer {
  /** Another structure; the camera is fitted to it. */
  show(scene: Scene): void;
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
  setTheme(theme: Theme): void;
  setVisible(layer: Layer, on: boolean): void;
  /** Swings a pale platform to and fro along the gained motion. */
  animateMotion(on: boolean): void;
  /** Where a point is seen, in CSS pixels from the element's upper left corner; null if it is not in front. */
  toScreen(name: string): [number, number] | null;
  /** A data URL of a PNG picture, or the text of an SVG one. */
  snapshot(kind: "png" | "svg"): Promise<string>;
  readonly renderer: "webgl" | "svg";
  dispose(): void;
}

export interface Options {
  /** The platform was moved by hand; `done` at the end of a drag. At most once for each frame. */
  onPose?(pose: Pose, done: boolean): void;
  onPick?(name: string): void;
  onHover?(what: { point?: string; entity?: string } | null): void;
  renderer?: "auto" | "svg";
  theme?: Theme;
  /** How many CSS pixels of the upper edge the host covers now; standard views and fits leave them free. */
  covered?(): number;
  /** Whether the wheel zooms at any time, or only once the view was clicked, so that the page around it scrolls. */
  wheel?: "always" | "focused";
  /** Handles and keys that move the platform; on unless false. */
  gizmo?: boolean;
}
