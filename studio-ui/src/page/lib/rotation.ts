// Turns: unit quaternions (scalar first), rotation vectors and Euler angles, all angles in degrees.
import type { Pose, Quaternion, Vec3 } from "../../protocol";

const DEGREE = Math.PI / 180;

export function product(p: Quaternion, q: Quaternion): Quaternion {
  const [a, b, c, d] = p;
  const [w, x, y, z] = q;
  return [
    a * w - b * x - c * y - d * z,
    a * x + b * w + c * z - d * y,
    a * y - b * z + c * w + d * x,
    a * z + b * y - c * x + d * w,
  ];
}

export function turn(axis: Vec3, degrees: number): Quaternion {
  const size = Math.hypot(...axis) || 1;
  const s = Math.sin((degrees * DEGREE) / 2) / size;
  return [Math.cos((degrees * DEGREE) / 2), axis[0] * s, axis[1] * s, axis[2] * s];
}

export const fromVector = (v: Vec3): Quaternion => turn(v, Math.hypot(...v));

export function toVector(q: Quaternion): Vec3 {
  const [w, x, y, z] = q[0] < 0 ? (q.map((c) => -c) as Quaternion) : q;
  const s = Math.hypot(x, y, z);
  const k = s < 1e-12 ? 2 / DEGREE : (2 * Math.atan2(s, w)) / (s * DEGREE);
  return [x * k, y * k, z * k];
}

/** How the three angles of the sliders make a turn: a rotation vector, or turns about axes one after another. */
export type Angles = "vector" | "XYZ" | "ZYX" | "ZXZ" | "ZYZ";
export const ANGLES: readonly Angles[] = ["vector", "XYZ", "ZYX", "ZXZ", "ZYZ"];

const AXES: Record<string, Vec3> = { X: [1, 0, 0], Y: [0, 1, 0], Z: [0, 0, 1] };
const axis = (name: string): Vec3 => AXES[name] ?? [0, 0, 1];

/** Euler sequences turn about the axes that turn along. */
export function fromAngles(kind: Angles, a: Vec3): Quaternion {
  if (kind === "vector") return fromVector(a);
  return [...kind].map((name, i) => turn(axis(name), a[i] ?? 0)).reduce(product);
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

export function matrix([w, x, y, z]: Quaternion): [Vec3, Vec3, Vec3] {
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
  const [w, x, y, z] = from.quaternion;
  const rest = toVector(product([w, -x, -y, -z], to.quaternion));
  const part = rest.map((c) => c * t) as Vec3;
  const quaternion = t === 1 ? to.quaternion : product(from.quaternion, fromVector(part));
  const goal = to.coordinates;
  if (!goal) return { translation, quaternion };
  return { translation, quaternion, coordinates: goal.map((b, i) => mix(from.coordinates?.[i] ?? 0, b)) };
}
