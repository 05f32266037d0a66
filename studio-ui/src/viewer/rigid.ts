// Rigid motions: a rotation matrix by rows and a shift; twists and screws are (ω; v).
import type { Vec3 } from "./types";
import { add, cross, dot, length, scale, sub } from "./vectors";

export interface Motion {
  turn: [Vec3, Vec3, Vec3];
  shift: Vec3;
}

export const STILL: Motion = { turn: [[1, 0, 0], [0, 1, 0], [0, 0, 1]], shift: [0, 0, 0] };

export const turned = (m: Motion, v: Vec3): Vec3 => [dot(m.turn[0], v), dot(m.turn[1], v), dot(m.turn[2], v)];
export const applied = (m: Motion, p: Vec3): Vec3 => add(turned(m, p), m.shift);

const column = (m: Motion, j: number): Vec3 => [m.turn[0][j]!, m.turn[1][j]!, m.turn[2][j]!];
const ofColumns = (c: Vec3[]): Motion["turn"] => [0, 1, 2].map((i) => c.map((v) => v[i]!)) as Motion["turn"];

/** First b, then a. */
export const product = (a: Motion, b: Motion): Motion => ({
  turn: ofColumns([0, 1, 2].map((j) => turned(a, column(b, j)))),
  shift: applied(a, b.shift),
});

/** The motion that takes what went with a to where it would have gone with b: b·a⁻¹. */
export function between(a: Motion, b: Motion): Motion {
  const back: Motion = { turn: ofColumns(a.turn), shift: [0, 0, 0] };
  return product(b, { turn: back.turn, shift: scale(turned(back, a.shift), -1) });
}

/** A screw where the motion takes it. */
export function twistAfter(m: Motion, screw: readonly number[]): number[] {
  const w = turned(m, screw.slice(0, 3) as Vec3);
  return [...w, ...add(turned(m, screw.slice(3) as Vec3), cross(m.shift, w))];
}

export function exponential(screw: readonly number[], amount: number): Motion {
  const w = scale(screw.slice(0, 3) as Vec3, amount);
  const v = scale(screw.slice(3) as Vec3, amount);
  const a = length(w);
  const small = a < 1e-4;
  const sine = small ? 1 - a ** 2 / 6 : Math.sin(a) / a;
  const cosine = small ? 0.5 - a ** 2 / 24 : (1 - Math.cos(a)) / a ** 2;
  const rest = small ? 1 / 6 - a ** 2 / 120 : (a - Math.sin(a)) / a ** 3;
  const sum = (u: Vec3, first: number, second: number): Vec3 =>
    add(u, add(scale(cross(w, u), first), scale(cross(w, cross(w, u)), second)));
  return { turn: ofColumns(STILL.turn.map((u) => sum(u, sine, cosine))), shift: sum(v, cosine, rest) };
}

/** The twist whose exponential a motion is; for turns by less than half a turn. */
export function logarithm(m: Motion): number[] {
  const [x, y, z] = m.turn;
  const odd = scale([z[1] - y[2], x[2] - z[0], y[0] - x[1]], 0.5);
  const sine = length(odd);
  const w = scale(odd, sine < 1e-4 ? 1 + sine ** 2 / 6 : Math.atan2(sine, (x[0] + y[1] + z[2] - 1) / 2) / sine);
  const a = length(w);
  const back = a < 1e-4 ? 1 / 12 : (1 - a / 2 / Math.tan(a / 2)) / a ** 2;
  const v = add(sub(m.shift, scale(cross(w, m.shift), 0.5)), scale(cross(w, cross(w, m.shift)), back));
  return [...w, ...v];
}
