// Joints as they are seen in a pose, and where they are in the file for one that is seen elsewhere. Those of a robot of joints are
// seen at home.
import type { Pose, ShapeRow, Study, Vec3 } from "../../protocol";
import { readNumber } from "../parts/number-field";
import { carried, IDENTITY, turned } from "../../viewer/pose";
import { add, centre, scale, sub } from "../../viewer/vectors";
import type { Written } from "./resizing";

/** All points that the dimensions are made of. */
export const pointsOf = ({ shape }: Study): ShapeRow[] => shape.groups.flatMap(({ sort, rows }) => (sort === "point" ? rows : []));

/** What a joint is called aloud. */
export const jointWords = ({ base, platform }: Study, name: string): string =>
  base.includes(name) ? `Joint ${name} of the base` : platform.includes(name) ? `Joint ${name} of the platform` : `Joint ${name}`;

/** Where a joint or a direction is to be in the file: as wanted while the robot is not so yet. */
export function placeOf(study: Study, wanted: Readonly<Record<string, Written>>, name: string): Vec3 {
  const at = study.points[name] ?? study.shape.groups.flatMap(({ rows }) => rows).find((row) => row.name === name)?.at ?? [0, 0, 0];
  const to = wanted[name] ?? [null, null, null];
  return at.map((c, i) => (to[i] == null ? c : (readNumber(to[i]!) ?? c))) as Vec3;
}

/** All joints in the file, and the point that the platform turns about: the centroid of its joints. */
export function shapeOf(study: Study, wanted: Readonly<Record<string, Written>>): { points: Record<string, Vec3>; about: Vec3 } {
  const points = Object.fromEntries(Object.keys(study.points).map((name) => [name, placeOf(study, wanted, name)]));
  if (study.kind === "robot") return { points, about: study.about };
  return { points, about: centre(study.platform.flatMap((name) => (points[name] ? [points[name]] : []))) };
}

/** Whether a joint goes along with the platform on six legs. */
const moves = (study: Study, name: string): boolean => study.kind === "platform" && study.platform.includes(name);

/** Where a joint is seen. */
export function seenAt(study: Study, wanted: Readonly<Record<string, Written>>, pose: Pose, name: string): Vec3 {
  const { points, about } = shapeOf(study, wanted);
  const at = points[name] ?? [0, 0, 0];
  return moves(study, name) ? carried(at, IDENTITY, pose, about) : at;
}

/** Where a joint is in the file that is seen there. The platform turns about the centroid of its joints, which goes along with it:
 * w = R (p − m) + m + t with m = m₀ + (p − p₀) / n, solved for p. */
export function fileAt(study: Study, wanted: Readonly<Record<string, Written>>, pose: Pose, name: string, seen: Vec3): Vec3 {
  if (!moves(study, name)) return seen;
  const { points, about } = shapeOf(study, wanted);
  const share = 1 / study.platform.length;
  const turn = (v: Vec3): Vec3 => turned(v, pose.quaternion);
  const rest = (v: Vec3): Vec3 => sub(v, turn(v)); // (1 − R) v
  const right = sub(sub(seen, pose.translation), rest(sub(about, scale(points[name] ?? about, share))));
  const column = (v: Vec3): Vec3 => add(turn(v), scale(rest(v), share));
  return solved([column([1, 0, 0]), column([0, 1, 0]), column([0, 0, 1])], right) ?? points[name] ?? seen;
}

/** x of x₀ a + x₁ b + x₂ c = right, by Cramer's rule; null where there is none. */
function solved([a, b, c]: [Vec3, Vec3, Vec3], right: Vec3): Vec3 | null {
  const det = (p: Vec3, q: Vec3, r: Vec3): number =>
    p[0] * (q[1] * r[2] - q[2] * r[1]) - p[1] * (q[0] * r[2] - q[2] * r[0]) + p[2] * (q[0] * r[1] - q[1] * r[0]);
  const size = det(a, b, c);
  return Math.abs(size) < 1e-9 ? null : [det(right, b, c) / size, det(a, right, c) / size, det(a, b, right) / size];
}

/** 1, 2 or 5 times a power of ten, near a hundredth of the robot's size. */
export function stepOf({ size }: Study): number {
  const rough = size / 100;
  const power = 10 ** Math.floor(Math.log10(rough));
  return [1, 2, 5, 10].reduce((a, b) => (Math.abs(Math.log(b * power / rough)) < Math.abs(Math.log(a * power / rough)) ? b : a)) * power;
}

/** A number on the grid of steps. */
export const onGrid = (value: number, step: number): number => Number((Math.round(value / step) * step).toPrecision(9));

/** A place on the grid; a coordinate that is less than half a step from where it began is left there. */
export const snapped = (to: Vec3, from: Vec3, step: number): Vec3 =>
  to.map((c, i) => (Math.abs(c - from[i]!) < step / 2 ? from[i]! : onGrid(c, step))) as Vec3;

/** One coordinate elsewhere, the others kept. */
export function written(axis: 0 | 1 | 2, value: number): Written {
  const text = String(Number(value.toPrecision(12)));
  return [axis === 0 ? text : null, axis === 1 ? text : null, axis === 2 ? text : null];
}

/** All coordinates that differ. */
export function writtenAt(to: Vec3, now: Vec3): Written {
  return to.map((c, i) => (c === now[i] ? null : String(Number(c.toPrecision(12))))) as unknown as Written;
}
