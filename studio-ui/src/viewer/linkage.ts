// A robot of joints moved by its actuators without a server: products of exponentials, loops closed in small steps from
// where it is, and the names that ride on its links. The equations are those of gcrules/mechanisms/kinematics/loops.py;
// a test compares places and margins with those of the engine.
import type { Linkage } from "../protocol";
import { singular } from "./linear";
import { applied, between, exponential, logarithm, product, STILL, turned, twistAfter, type Motion } from "./rigid";
import type { Vec3 } from "./types";
import { add, cross, distance, length, scale } from "./vectors";

/** The amounts of all coordinates of each limb from home, and where its links go, first the base, last the platform; of a
 * limb with bodies of its own those of all its runs. */
export interface Configuration {
  amounts: number[][];
  links: Motion[][];
}

type Chain = Linkage["chains"][number];

const ACCURACY = 1e-11;
const ITERATIONS = 20;
const STEP = 0.1; // of an actuator at once: rad, or parts of the robot's size
const FARTHEST = 0.5; // of a joint in one step
const SHORTEST = 1 / 4096;
const APART = 1e-6; // how far links may disagree where a name is

export const home = (m: Linkage): Configuration => placed(m, m.chains.map((c) => c.turns.map(() => 0)));

/** The amounts of the actuators. */
export const driven = (m: Linkage, at: Configuration): number[] => m.drives.map((d) => at.amounts[d.limb]![d.coordinate]!);

/** What counts as much of an actuator's amount: 1 rad, or the robot's size. */
export const unitOf = (m: Linkage, drive: number): number => {
  const d = m.drives[drive]!;
  return m.chains[d.limb]!.turns[d.coordinate] ? 1 : m.size;
};

/** As far towards wanted amounts of the actuators as the robot assembles; `reached` where that is all the way. */
export function driveTo(m: Linkage, from: Configuration, wanted: readonly number[]): { at: Configuration; reached: boolean } {
  const start = driven(m, from);
  const far = Math.max(...wanted.map((w, i) => Math.abs(w - start[i]!) / unitOf(m, i)), 0);
  if (!far) return { at: from, reached: true };
  let [at, done, step] = [from, 0, Math.min(1, STEP / far)];
  while (done < 1) {
    const part = Math.min(1, done + step);
    const goal = wanted.map((w, i) => start[i]! + part * (w - start[i]!));
    const next = closed(m, at, goal);
    if (next) {
      [at, done] = [next, part];
      step = Math.min(2 * step, STEP / far);
    } else if ((step /= 2) * Math.max(far, 1e-3) < SHORTEST * STEP) return { at, reached: false };
  }
  return { at, reached: true };
}

/** The configuration near this one with these amounts of the actuators; null where there is none. */
function closed(m: Linkage, near: Configuration, goal: readonly number[]): Configuration | null {
  const units = m.chains.flatMap((c) => c.turns.map((angle) => (angle ? 1 : m.size)));
  const start = near.amounts.flat();
  let all = [...start];
  let best = Infinity;
  for (let k = 0; k < ITERATIONS; k++) {
    const at = placed(m, split(m, all));
    const { gaps, rows } = equations(m, at, goal);
    const size = Math.hypot(...gaps);
    if (size <= 1e-13 || (size <= ACCURACY && size >= best / 4)) return holds(m, at) ? at : null;
    if (!(size <= 4 * best)) return null;
    best = Math.min(best, size);
    const change = step(rows.map((row) => row.map((c, j) => c * units[j]!)), gaps, size);
    const reach = Math.max(...change.map(Math.abs));
    const short = Math.min(1, FARTHEST / 2 / (reach || 1));
    all = all.map((a, j) => a + change[j]! * units[j]! * short);
    if (all.some((a, j) => Math.abs(a - start[j]!) > FARTHEST * units[j]!)) return null;
  }
  return null;
}

/** Levenberg and Marquardt's step towards gaps = 0, with the damping |gaps|². */
function step(rows: number[][], gaps: readonly number[], size: number): number[] {
  const { values, vectors } = singular(rows);
  const found = vectors.map(() => 0);
  vectors.forEach((v, k) => {
    const s = values[k]!;
    if (!(s > 1e-11 * values[0]!)) return;
    const along = rows.reduce((sum, row, i) => sum + gaps[i]! * row.reduce((x, c, j) => x + c * v[j]!, 0), 0) / (s * s + size * size);
    v.forEach((c, j) => (found[j]! -= along * c));
  });
  return found;
}

/** How far the limbs' platforms are from that of the first one and the actuators from what is wanted, with derivatives. */
function equations(m: Linkage, at: Configuration, goal: readonly number[]): { gaps: number[]; rows: number[][] } {
  const platform = at.links[0]!.at(-1)!;
  const middle = applied(platform, m.centre);
  const starts = m.chains.map((_, i) => m.chains.slice(0, i).reduce((n, c) => n + c.turns.length, 0));
  const width = starts.at(-1)! + m.chains.at(-1)!.turns.length;
  const local = m.chains.map((_, i) => twists(m, at, i).map((t) => atPlace(t, middle, m.size)));
  const [gaps, rows]: [number[], number[][]] = [[], []];
  const loop = (from: Motion, to: Motion, parts: [number, number, number][]) => {
    const twist = atPlace(logarithm(between(from, to)), middle, m.size);
    for (let k = 0; k < 6; k++) {
      const row = new Array<number>(width).fill(0);
      for (const [i, share, sign] of parts)
        local[i]!.forEach((t, j) => (row[starts[i]! + j] = sign * m.chains[i]!.shares[j]![share]! * t[k]!));
      gaps.push(twist[k]!);
      rows.push(row);
    }
  };
  for (let i = 1; i < m.chains.length; i++) loop(platform, at.links[i]!.at(-1)!, [[i, 0, 1], [0, 0, -1]]);
  m.chains.forEach((c, i) =>
    loops(c).forEach(([closing, reached], n) => loop(at.links[i]![reached]!, at.links[i]![closing]!, [[i, n + 1, 1]])),
  );
  m.drives.forEach((d, i) => {
    const row = new Array<number>(width).fill(0);
    row[starts[d.limb]! + d.coordinate] = 1 / unitOf(m, i);
    rows.push(row);
    gaps.push((at.amounts[d.limb]![d.coordinate]! - goal[i]!) / unitOf(m, i));
  });
  return { gaps, rows };
}

/** The links that are one in each loop of a limb's own. */
const loops = (c: Chain): [number, number][] =>
  c.runs.flatMap(([, stop, , reached], n): [number, number][] => (reached! >= 0 ? [[stop! + n, reached!]] : []));

/** The twist of each coordinate of a limb; its shares tell what it counts in. */
export function twists(m: Linkage, at: Configuration, limb: number): number[][] {
  const c = m.chains[limb]!;
  const found = c.turns.map(() => [0, 0, 0, 0, 0, 0]);
  const before = (k: number) => k + Math.max(0, c.runs.findIndex(([, stop]) => k < stop!));
  c.screws.forEach((screw, k) =>
    twistAfter(at.links[limb]![before(k)]!, screw).forEach((x, i) => (found[c.uses[k]!]![i]! += c.signs[k]! * x)),
  );
  return found;
}

/** A twist as (ω; v/ρ), v at a place. */
export function atPlace(twist: readonly number[], place: Vec3, size: number): number[] {
  const w = twist.slice(0, 3) as Vec3;
  return [...w, ...scale(add(twist.slice(3) as Vec3, cross(w, place)), 1 / size)];
}

function placed(m: Linkage, amounts: number[][]): Configuration {
  const links = m.chains.map((c, i) => {
    const found: Motion[] = [];
    for (const [first, stop, base] of c.runs.length ? c.runs : [[0, c.screws.length, 0]]) {
      found.push(found[base!] ?? STILL);
      for (let k = first!; k < stop!; k++)
        found.push(product(found.at(-1)!, exponential(c.screws[k]!, c.signs[k]! * amounts[i]![c.uses[k]!]!)));
    }
    return c.runs.length ? [...found, found[c.platform]!] : found;
  });
  return { amounts, links };
}

function split(m: Linkage, all: readonly number[]): number[][] {
  let start = 0;
  return m.chains.map((c) => all.slice(start, (start += c.turns.length)));
}

/** Whether the links that carry a name agree where it is, and what has to stay still does. */
function holds(m: Linkage, at: Configuration): boolean {
  if (m.locked.some(([limb, coordinate]) => Math.abs(at.amounts[limb!]![coordinate!]!) > 1e-7)) return false;
  const places = m.points;
  return Object.entries(m.rides).every(([name, rides]) => {
    const motions = rides.map(([limb, link]) => at.links[limb!]!.at(link!)!);
    const [point, direction] = [places[name], m.directions[name]];
    if (point) return motions.every((k) => distance(applied(k, point), applied(motions[0]!, point)) <= APART * m.size);
    if (!direction) return true;
    const first = turned(motions[0]!, direction);
    return motions.every((k) => length(cross(first, turned(k, direction))) <= APART * length(direction) ** 2);
  });
}

/** Where all points and directions are. */
export function named(m: Linkage, at: Configuration): Record<string, Vec3> {
  const found: Record<string, Vec3> = {};
  const link = (name: string) => m.rides[name]?.[0] && at.links[m.rides[name][0][0]!]!.at(m.rides[name][0][1]!);
  for (const [name, p] of Object.entries(m.points)) found[name] = link(name) ? applied(link(name)!, p) : p;
  for (const [name, u] of Object.entries(m.directions)) found[name] = link(name) ? turned(link(name)!, u) : u;
  return found;
}
