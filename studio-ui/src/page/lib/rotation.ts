// Turns: unit quaternions (scalar first), rotation vectors and Euler angles, all angles in degrees.
import type { Pose, Quaternion, Vec3 } from "../../protocol";
import { conjugate, multiply, rotationVector as toVector, turnAbout } from "../../viewer/pose";
import { length, scale } from "../../viewer/vectors";

const DEGREE = Math.PI / 180;

const fromVector = (v: Vec3): Quaternion => turnAbout(scale(v, 1 / (length(v) || 1)), length(v) * DEGREE);

/** How the three angles of the sliders make a turn: a rotation vector, or turns about axes one after another. */
export type Angles = "vector" | "XYZ" | "ZYX" | "ZXZ" | "ZYZ";
export const ANGLES: readonly Angles[] = ["vector", "XYZ", "ZYX", "ZXZ", "ZYZ"];

const AXES: Record<string, Vec3> = { X: [1, 0, 0], Y: [0, 1, 0], Z: [0, 0, 1] };
const axis = (name: string): Vec3 => AXES[name] ?? [0, 0, 1];

/** Euler sequences turn about the axes that turn along. */
export function fromAngles(kind: Angles, a: Vec3): Quaternion {
  if (kind === "vector") return fromVector(a);
  return [...kind].map((name, i) => turnAbout(axis(name), (a[i] ?? 0) * DEGREE)).reduce(multiply);
}

export function toAngles(kind: Angles, q: Quaternion): Vec3 {
  if (kind === "vector") return toVector(q);
  const m = matrix(q);
  const [i, j, k] = [...kind].map((name) => "XYZ".indexOf(name)) as Vec3;
  const at = (r: number, c: number) => m[r]?.[c] ?? 0;
  const even = (j - i + 3) % 3 === 1 ? 1 : -1;
  if (i === k) {
    const other = 3 - i - j;
    const middle = Math.atan2(Math.hypot(at(j, i), at(other, i)), at(i, i));
    if (Math.sin(middle) < 1e-9) return [Math.atan2(even * at(other, j), at(j, j)) / DEGREE, middle / DEGREE, 0];
    return [
      Math.atan2(at(j, i), -even * at(other, i)) / DEGREE,
      middle / DEGREE,
      Math.atan2(at(i, j), even * at(i, other)) / DEGREE,
    ];
  }
  const middle = Math.atan2(even * at(i, k), Math.hypot(at(i, i), at(i, j)));
  if (Math.cos(middle) < 1e-9) return [Math.atan2(even * at(k, j), at(j, j)) / DEGREE, middle / DEGREE, 0];
  return [
    Math.atan2(-even * at(j, k), at(k, k)) / DEGREE,
    middle / DEGREE,
    Math.atan2(-even * at(i, j), at(i, i)) / DEGREE,
  ];
}

function matrix([w, x, y, z]: Quaternion): [Vec3, Vec3, Vec3] {
  return [
    [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
    [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
    [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
  ];
}

export function sameTurn(p: Quaternion, q: Quaternion): boolean {
  return Math.abs(p.reduce((sum, c, i) => sum + c * (q[i] ?? 0), 0)) > 1 - 1e-12;
}

/** The pose at the fraction t of the way: straight shift, steady turn (the shorter way round). */
export function between(from: Pose, to: Pose, t: number): Pose {
  const mix = (a: number, b: number) => a + (b - a) * t;
  const translation = from.translation.map((a, i) => mix(a, to.translation[i] ?? a)) as Vec3;
  const rest = toVector(multiply(conjugate(from.quaternion), to.quaternion));
  const part = rest.map((c) => c * t) as Vec3;
  const quaternion = t === 1 ? to.quaternion : multiply(from.quaternion, fromVector(part));
  const goal = to.coordinates;
  if (!goal) return { translation, quaternion };
  return { translation, quaternion, coordinates: goal.map((b, i) => mix(from.coordinates?.[i] ?? 0, b)) };
}
