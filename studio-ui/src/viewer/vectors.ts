// Vectors in space as triples of numbers.
import type { Vec3 } from "./types";

export const add = (a: Vec3, b: Vec3): Vec3 => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const sub = (a: Vec3, b: Vec3): Vec3 => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const scale = (a: Vec3, s: number): Vec3 => [a[0] * s, a[1] * s, a[2] * s];
/** p + s·u */
export const along = (p: Vec3, u: Vec3, s: number): Vec3 => [p[0] + s * u[0], p[1] + s * u[1], p[2] + s * u[2]];
export const dot = (a: Vec3, b: Vec3): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a: Vec3, b: Vec3): Vec3 => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];
export const length = (a: Vec3): number => Math.hypot(a[0], a[1], a[2]);
export const distance = (a: Vec3, b: Vec3): number => length(sub(a, b));
export const mix = (a: Vec3, b: Vec3, t: number): Vec3 => along(a, sub(b, a), t);
/** Of length 1; the zero vector stays. */
export const unit = (a: Vec3): Vec3 => scale(a, 1 / (length(a) || 1));

/** The mean of points; the origin for none. */
export function centre(points: readonly Vec3[]): Vec3 {
  return scale(points.reduce(add, [0, 0, 0]), 1 / (points.length || 1));
}

/** Two unit vectors normal to a unit vector and to each other; u × v is that vector. */
export function across(n: Vec3): [Vec3, Vec3] {
  const helper: Vec3 = Math.abs(n[2]) < 0.9 ? [0, 0, 1] : [1, 0, 0];
  const u = unit(cross(helper, n));
  return [u, cross(n, u)];
}

/** The unit normal of the largest triangle of the corners; null if they are all in one line. */
export function flatNormal(corners: readonly Vec3[]): Vec3 | null {
  let best: Vec3 = [0, 0, 0];
  let size = 0;
  for (let i = 0; i < corners.length; i++)
    for (let j = i + 1; j < corners.length; j++) {
      size = Math.max(size, distance(corners[i]!, corners[j]!));
      for (let k = j + 1; k < corners.length; k++) {
        const n = cross(sub(corners[j]!, corners[i]!), sub(corners[k]!, corners[i]!));
        if (length(n) > length(best) * (1 + 1e-9)) best = n;
      }
    }
  return length(best) <= 1e-6 * size * size ? null : unit(best);
}
