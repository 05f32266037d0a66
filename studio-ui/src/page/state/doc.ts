// What the user has made: everything that undo brings back and that the link in the address bar restores.
import { THRESHOLD, type Pose, type RuleFile, type Sketch, type Source, type StageId, type Vec3 } from "../../protocol";

export type PanelId = "start" | "guided" | "manual" | "motion" | "where" | "dimensions" | "bench" | "draw" | "take-away" | "project";

/** What is made in the panel "Draw": a platform on six legs, or a robot of limbs and joints. */
export type Making = "legs" | "limbs";

/** A coordinate of a map with its range, in the unit of that coordinate. */
export interface Range {
  name: string;
  low: number;
  high: number;
}

export type Box = [Range, Range, Range];

/** What a path, a map and a surface are asked with. */
export interface Tour {
  /** Where the path begins; null for home. */
  start: Pose | null;
  /** Where it ends, in words; "" for the pose on show. */
  to: string;
  /** The coordinates of the map; null for the first ones of the robot. */
  over: [Range, Range] | null;
  /** Poses along each of them. */
  nodes: number;
  /** What the bands of the map are. */
  measure: string;
  /** The ranges of the surface over x, y and z; null for those to begin with. */
  box: Box | null;
  /** Poses along each of them; null for so many as are soon there. */
  fineness: number | null;
}

export interface Doc {
  source: Source | null;
  pose: Pose;
  panel: PanelId;
  /** null: the first one of the structure. */
  stage: StageId | null;
  /** Closer than this is close: an angle ("0.5 deg") or a length ("20 mm"). */
  threshold: string;
  /** Commands of manual mode. */
  commands: string[];
  /** Text of the expression bench. */
  bench: string;
  /** Files of rules that hold on the bench. */
  rules: readonly RuleFile[];
  tour: Tour;
  making: Making;
  /** What is being drawn, if anything. */
  sketch: Sketch | null;
  /** The file of the robot that is being built limb by limb, if there is one. */
  limbs: string | null;
}

export const HOME: Pose = { translation: [0, 0, 0], quaternion: [1, 0, 0, 0] };

/** Poses along each coordinate of a map, to choose from. */
export const NODES: readonly number[] = [11, 17, 25, 41, 61, 81];

/** Poses along each coordinate of a surface, to choose from. */
export const FINENESS: readonly number[] = [9, 13, 25, 41];

export const MARGIN = "margin";

export const TOUR: Tour = { start: null, to: "", over: null, nodes: 25, measure: MARGIN, box: null, fineness: null };

export const EMPTY: Doc = {
  source: null,
  pose: HOME,
  panel: "start",
  stage: null,
  threshold: THRESHOLD,
  commands: [],
  bench: "",
  rules: [],
  tour: TOUR,
  making: "legs",
  sketch: null,
  limbs: null,
};

/** The fields that say where the user is rather than what was made: changing them is no step to undo. */
export const NAVIGATION = ["panel", "stage", "making"] as const satisfies readonly (keyof Doc)[];

export function sameSource(a: Source | null, b: Source | null): boolean {
  return JSON.stringify(a) === JSON.stringify(b);
}

export function samePose(a: Pose, b: Pose): boolean {
  const flat = (p: Pose) => [...p.translation, ...p.quaternion, ...(p.coordinates ?? [])];
  const [x, y] = [flat(a), flat(b)];
  return x.length === y.length && x.every((value, i) => Math.abs(value - (y[i] ?? NaN)) < 1e-12);
}

/** Home, for a robot of the same number of actuators. */
export const atHome = ({ coordinates }: Pose): Pose => (coordinates ? { ...HOME, coordinates: coordinates.map(() => 0) } : HOME);

export const isHome = (pose: Pose): boolean => samePose(pose, atHome(pose));

export function shifted(pose: Pose, axis: 0 | 1 | 2, value: number): Pose {
  const translation: Vec3 = [...pose.translation];
  translation[axis] = value;
  return { ...pose, translation };
}
