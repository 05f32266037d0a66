// The singularity margin of a robot of joints, as gcrules/mechanisms/kinematics/margin.py defines it.
import type { Linkage } from "../protocol";
import { singular } from "./linear";
import { atPlace, twists, type Configuration } from "./linkage";
import { twist, type PoseNumbers } from "./numbers";
import { applied } from "./rigid";
import type { Vec3, Verdict } from "./types";
import { add, centre, cross, scale, sub } from "./vectors";

export interface LimbNumbers {
  margin: number;
  verdict: Verdict;
  motion: PoseNumbers["motion"];
}

const ROUNDING = 1e-12;

export function limbNumbers(m: Linkage, at: Configuration, unit: string): LimbNumbers {
  const platform = at.links[0]!.at(-1)!;
  const ends = m.chains.map((c) => applied(platform, c.end));
  const middle = centre(ends);
  const keep = m.plane ? [0, 1, 5] : [0, 1, 2, 3, 4, 5];
  const rows: number[][] = [];
  let lost = false; // whether a limb is singular by itself
  const metric = keep.map(() => keep.map(() => 0));
  ends.forEach((end, i) => {
    const arm = scale(sub(end, middle), 1 / m.size);
    const { every, free } = limbTwists(m, at, i, end);
    const { rank, passive, applied: dimension } = m.chains[i]!;
    lost ||= least(every, rank) <= m.floor || least(free, passive) <= m.floor;
    for (const [f, moment] of wrenches(free, passive, dimension)) rows.push([...f, ...add(moment, cross(arm, f))]);
    // rows of the velocity of the end by (v; ω), and of the turn itself unless the limb ends in a ball joint
    for (const e of AXES) addSquare(metric, keep, [...e, ...cross(arm, e)]);
    if (!m.chains[i]!.ball) for (const e of AXES) addSquare(metric, keep, [0, 0, 0, ...e]);
  });
  const balance = unitScale(metric);
  const own = singular(rows.map((row) => balance.map((b) => b.reduce((sum, c, j) => sum + c * row[keep[j]!]!, 0))));
  const bodies = m.spans.length ? ofAllBodies(m, at, ends, middle, keep) : null;
  const alone = rows.length < keep.length ? 0 : own.values.at(-1)!;
  const margin = Math.min(alone, bodies?.least ?? 1, 1);
  const verdict = lost || margin <= m.floor ? "singular" : margin < m.close ? "close" : "regular";
  const soft = [0, 0, 0, 0, 0, 0];
  if (bodies && bodies.least < alone && Math.hypot(...bodies.motion) > ROUNDING)
    bodies.motion.forEach((c, j) => (soft[keep[j]!] = c));
  else own.vectors.at(-1)!.forEach((c, k) => balance[k]!.forEach((b, j) => (soft[keep[j]!]! += c * b)));
  const turn = scale(soft.slice(3) as Vec3, 1 / m.size);
  const motion = verdict === "regular" || margin >= m.close ? null : twist(soft.slice(0, 3) as Vec3, turn, middle, m.size, unit);
  return { margin, verdict, motion };
}

/** The least singular value for the twists of all bodies, and the platform's part of those that take it. */
function ofAllBodies(m: Linkage, at: Configuration, ends: Vec3[], middle: Vec3, keep: readonly number[]) {
  const width = keep.length;
  const size = width * (1 + Math.max(...m.spans.flatMap((s) => [s.start, s.end])));
  const every = [...Array(size).keys()];
  const metric = every.map(() => every.map(() => 0));
  const rows: number[][] = [];
  for (const span of m.spans) {
    const arm = scale(sub(ends[span.limb]!, middle), 1 / m.size);
    const { turns } = m.chains[span.limb]!;
    const twist = twists(m, at, span.limb).map((t, k) => scaled(atPlace(t, ends[span.limb]!, m.size), turns[k] ? 1 : m.size));
    const bodies = [[span.end, 1], [span.start, -1]].filter(([body]) => body! >= 0);
    const spread = (row: readonly number[]): number[] => {
      const found = new Array<number>(size).fill(0);
      for (const [body, sign] of bodies) keep.forEach((c, j) => (found[body! * width + j] = sign! * row[c]!));
      return found;
    };
    for (const [f, moment] of wrenches(span.free.map((k: number) => twist[k]!), span.rank, 6)) rows.push(spread([...f, ...add(moment, cross(arm, f))]));
    for (const e of AXES) {
      addSquare(metric, every, spread([...e, ...cross(arm, e)]));
      addSquare(metric, every, spread([0, 0, 0, ...e]));
    }
  }
  const balance = unitScale(metric);
  const { values, vectors } = singular(rows.map((row) => balance.map((b) => b.reduce((sum, c, j) => sum + c * row[j]!, 0))));
  const motion = keep.map((_, j) => vectors.at(-1)!.reduce((sum, c, k) => sum + c * balance[k]![j]!, 0));
  return { least: rows.length < size ? 0 : values.at(-1)!, motion };
}

/** Rows that are orthonormal in a metric. */
function unitScale(metric: number[][]): number[][] {
  const { values, vectors } = singular(metric);
  return vectors.map((v, k) => scaled(v, 1 / Math.sqrt(values[k]! > ROUNDING * values[0]! ? values[k]! : 1)));
}

const AXES: Vec3[] = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
const scaled = (v: readonly number[], s: number): number[] => v.map((c) => c * s);

function addSquare(metric: number[][], keep: readonly number[], row: readonly number[]): void {
  keep.forEach((i, a) => keep.forEach((j, b) => (metric[a]![b]! += row[i]! * row[j]!)));
}

/** A limb's twists at its end for a turn by 1 rad or a slide by ρ in each coordinate, for the platform and for each loop
 * of the limb's own side by side, and those that are not driven. */
function limbTwists(m: Linkage, at: Configuration, limb: number, end: Vec3): { every: number[][]; free: number[][] } {
  const actuators = [...m.drives.map((d) => [d.limb, d.coordinate]), ...m.follows];
  const still = actuators.flatMap(([own, coordinate]) => (own === limb ? [coordinate] : []));
  const { turns, shares } = m.chains[limb]!;
  const every = twists(m, at, limb).map((t, k) => {
    const own = scaled(atPlace(t, end, m.size), turns[k] ? 1 : m.size);
    return shares[k]!.flatMap((share) => scaled(own, share));
  });
  return { every, free: every.filter((_, k) => !still.includes(k)) };
}

const least = (rows: number[][], rank: number): number => (rows.length ? singular(rows).values[rank - 1]! : 1);

/** An orthonormal basis of the wrenches (force, moment by ρ) on the platform that do no work on twists of this rank. */
function wrenches(free: number[][], rank: number, dimension: number): [Vec3, Vec3][] {
  const every = singular(free.length ? free : [[0, 0, 0, 0, 0, 0]]).vectors.slice(free.length ? rank : 0);
  const looped = every.some((v) => v.length > 6);
  const basis = looped ? singular(every.map((v) => v.slice(0, 6))).vectors.slice(0, dimension) : every;
  return basis.map((v) => [v.slice(3) as Vec3, v.slice(0, 3) as Vec3]);
}
