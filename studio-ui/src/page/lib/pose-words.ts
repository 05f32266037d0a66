// Poses in words: by all their coordinates, or by those in which some poses differ.
import type { Pose, Study } from "../../protocol";
import { rotationVector } from "../../viewer/pose";
import { short } from "./format";
import { sameTurn } from "./rotation";

type Robot = Pick<Study, "kind" | "axes" | "unit" | "size">;

interface Coordinate {
  name: string;
  unit: string;
  of(pose: Pose): number;
  differs(a: Pose, b: Pose): boolean;
}

/** The actuators of a robot of joints; of a platform its shifts, and how far it is turned. */
function coordinatesOf({ kind, axes, unit, size }: Robot): Coordinate[] {
  if (kind === "robot")
    return axes.map(({ name, unit, low, high }, i) => number(name.split(",")[0] ?? name, unit, 1e-6 * (high - low), (pose) => pose.coordinates?.[i] ?? 0));
  const shifts = ["x", "y", "z"].map((name, i) => number(name, unit, 1e-9 * size, ({ translation }) => translation[i] ?? 0));
  const turn = ({ quaternion }: Pose) => Math.hypot(...rotationVector(quaternion));
  return [...shifts, { name: TURN, unit: "deg", of: turn, differs: (a, b) => !sameTurn(a.quaternion, b.quaternion) }];
}

/** One that differs by more than the least. */
const number = (name: string, unit: string, least: number, of: Coordinate["of"]): Coordinate => ({
  name,
  unit,
  of,
  differs: (a, b) => Math.abs(of(a) - of(b)) > least,
});

const TURN = "turned by";

export const measured = (number: string, unit: string): string => number + (unit === "deg" ? "°" : unit && ` ${unit}`);

/** "z = −350 mm, turned by 12°": the coordinates of a pose that are not the same in all of `among`. */
export function differing(pose: Pose, among: readonly Pose[], robot: Robot): string {
  const moved = coordinatesOf(robot).filter(({ differs }) => among.some((other) => differs(other, among[0]!)));
  return moved.map((c) => `${c.name}${c.name === TURN ? " " : " = "}${measured(short(c.of(pose), 5), c.unit)}`).join(", ");
}

/** Between which of two poses, in one or two coordinates; "" where more of them differ, or a turn. */
export function spanned(from: Pose, to: Pose, robot: Robot): string {
  const moved = coordinatesOf(robot).filter(({ differs }) => differs(from, to));
  if (moved.length > 2 || moved.some(({ name }) => name === TURN)) return "";
  return moved.map((c) => `${c.name} = ${short(c.of(from), 4)} and ${measured(short(c.of(to), 4), c.unit)}`).join(", ");
}

/** A pose by all its coordinates, in short. */
export function inWords(pose: Pose, robot: Robot): string {
  const all = coordinatesOf(robot);
  if (robot.kind === "robot") return all.map(({ name, of }) => `${name} ${short(of(pose), 4)}`).join(", ");
  const shift = measured(pose.translation.map((c) => short(c, 4)).join(", "), robot.unit);
  const turn = all.at(-1)!.of(pose);
  return turn > 1e-3 ? `${shift}; turned by ${short(turn, 3)}°` : shift;
}
