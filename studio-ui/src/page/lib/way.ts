// A way that is driven, as the fewest poses that it leads straight through; a way that is proved, by its parameter.
import type { PathAnswer, PathPlace, Pose } from "../../protocol";
import { between } from "./rotation";
import { samePose } from "../state/doc";

/** What counts as much as a radian: a length for shifts, and one for each coordinate of a robot with limbs. */
export interface Scales {
  length: number;
  coordinates: readonly number[];
}

const NEAR = 1e-3; // of these scales, and radians: a hand is not steadier

export function apart(a: Pose, b: Pose, { length, coordinates }: Scales): number {
  const shift = Math.hypot(...a.translation.map((c, i) => c - (b.translation[i] ?? 0))) / length;
  const turn = 2 * Math.acos(Math.min(1, Math.abs(a.quaternion.reduce((sum, c, i) => sum + c * (b.quaternion[i] ?? 0), 0))));
  const of = (p: Pose, i: number) => p.coordinates?.[i] ?? 0;
  return Math.hypot(shift, turn, ...coordinates.map((scale, i) => (of(a, i) - of(b, i)) / (scale || 1)));
}

/** Whether a pose lies on the straight way between two others. */
export function liesBetween(from: Pose, to: Pose, pose: Pose, scales: Scales): boolean {
  const [before, after] = [apart(from, pose, scales), apart(pose, to, scales)];
  const t = before / (before + after || 1);
  return apart(between(from, to, t), pose, scales) <= NEAR;
}

export interface Driven {
  stops: readonly Pose[];
  /** The poses since the stop before the last. */
  passed: readonly Pose[];
}

const MOST_PASSED = 400;

/** The way with a pose at its end; where it goes straight on, the last stop moves along. */
export function driven({ stops, passed }: Driven, pose: Pose, scales: Scales, most: number): Driven {
  const [before, last] = [stops.at(-2), stops.at(-1)];
  if (last && samePose(last, pose)) return { stops, passed };
  const all = last ? [...passed, last] : [];
  if (before && all.length <= MOST_PASSED && all.every((p) => liesBetween(before, pose, p, scales)))
    return { stops: [...stops.slice(0, -1), pose], passed: all };
  return { stops: [...stops, pose].slice(-most), passed: [] };
}

/** The pose at a parameter, between the samples whose poses are known; null where they are not. */
export function poseAt({ samples }: Pick<PathAnswer, "samples">, parameter: number): Pose | null {
  const after = samples.findIndex((s) => s.parameter >= parameter);
  const [b, a] = [samples[after < 0 ? samples.length - 1 : after], samples[Math.max((after < 0 ? samples.length : after) - 1, 0)]];
  if (!a?.pose || !b?.pose) return null;
  const span = b.parameter - a.parameter;
  return span > 0 ? between(a.pose, b.pose, Math.min(Math.max((parameter - a.parameter) / span, 0), 1)) : b.pose;
}

/** The last singular pose on the way from a parameter to another one, forth or back. */
export function lastPassed(places: readonly PathPlace[], from: number, to: number): PathPlace | null {
  const [low, high] = [Math.min(from, to), Math.max(from, to)];
  const between = places.filter(({ parameter }) => low <= parameter && parameter <= high);
  return (to < from ? between[0] : between.at(-1)) ?? null;
}
