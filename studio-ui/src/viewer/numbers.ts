// The numbers of a pose without a server, in floating-point numbers: value, margin, softest motion, constructions.
// What they mean is said in docs/pose.md; a test compares them with those of the engine.
import { common, constructed, lineOf } from "./extensors";
import { backwards, cholesky, determinant, forwards, singular } from "./linear";
import type { Constructed, Recipe, Scene, Thresholds, Vec3, Verdict } from "./types";
import { centre, cross, length, scale, sub, unit } from "./vectors";

export interface PoseNumbers {
  /** The superbracket of the legs, in the ninth power of the unit of length. */
  superbracket: number;
  /** The singularity margin σ: 0 (singular) to 1. */
  margin: number;
  verdict: Verdict;
  constructed: Constructed[];
  motion: NonNullable<Scene["motion"]> | null;
}

/** Those of a scene whose platform moves; thresholds come with its recipe. */
export function numbersAt(scene: Scene & { recipe: Recipe }): PoseNumbers {
  const { recipe } = scene;
  const { margin, floor, motion } = softest(scene, recipe);
  const verdict = margin <= floor ? "singular" : margin < recipe.thresholds.close ? "close" : "regular";
  return {
    superbracket: recipe.sign * superbracket(scene),
    margin,
    verdict,
    constructed: constructions(scene, recipe),
    motion: verdict === "regular" ? null : motion,
  };
}

/** −det of the rows (direction, moment) of the legs, which does not depend on the origin. */
function superbracket(scene: Scene): number {
  const middle = centre(Object.values(scene.points));
  const rows = scene.legs.map(([a, b]) => {
    const [p, q] = [sub(scene.points[a]!, middle), sub(scene.points[b]!, middle)];
    return [...sub(q, p), ...cross(p, q)];
  });
  return -determinant(rows);
}

interface Softest {
  margin: number;
  /** What rounding may do to the margin. */
  floor: number;
  motion: PoseNumbers["motion"];
}

/** The twist that the legs notice least among those that move the platform's joints equally far. */
function softest(scene: Scene, { thresholds }: Recipe): Softest {
  const none = { margin: 0, floor: 0, motion: null };
  const ends = scene.legs.map(([, b]) => scene.points[b]!);
  const middle = centre(ends);
  const arms = ends.map((p) => sub(p, middle));
  const radius = Math.sqrt(arms.reduce((sum, a) => sum + length(a) ** 2, 0) / arms.length);
  const directions = scene.legs.map(([a, b]) => sub(scene.points[b]!, scene.points[a]!));
  if (!(radius > 0) || directions.some((d) => length(d) < 1e-12 * radius)) return none;
  const lever = arms.map((a) => scale(a, 1 / radius));
  const total = lever.reduce((sum, a) => sum + length(a) ** 2, 0);
  const inertia = [0, 1, 2].map((i) =>
    [0, 1, 2].map((j) => (i === j ? total : 0) - lever.reduce((sum, a) => sum + a[i]! * a[j]!, 0)),
  );
  const lower = cholesky(inertia);
  if (!lower) return none;
  const six = Math.sqrt(6);
  const rows = directions.map((d, k) => {
    const u = unit(d);
    return [...scale(u, 1 / six), ...forwards(lower, cross(lever[k]!, u))];
  });
  const { values, vectors } = singular(rows);
  const soft = vectors[5]!;
  const velocity = soft.slice(0, 3).map((c) => c / six) as Vec3;
  const turn = scale(backwards(lower, soft.slice(3)) as Vec3, 1 / radius);
  const floor = noise(scene, directions.map(length), radius * Math.hypot(...singular(lever).values.slice(1)), thresholds);
  return { margin: Math.min(values[5]!, 1), floor, motion: twist(velocity, turn, middle, radius, scene.unit) };
}

/** How much rounding can change the margin, as `noise` of the engine has it; `spread` is that of the legs' ends about the
 * line that is nearest to them. */
function noise(scene: Scene, lengths: number[], spread: number, { rounding, digits }: Thresholds): number {
  const all = Object.values(scene.points);
  const middle = centre(all);
  const size = Math.sqrt(all.reduce((sum, p) => sum + length(sub(p, middle)) ** 2, 0) / all.length);
  const blur = (ends: string[]) =>
    Math.max(rounding * size, digits * Math.max(...ends.flatMap((n) => scene.points[n]!.map(Math.abs))));
  const leg = Math.min((2 * blur(scene.legs.flat())) / Math.min(...lengths), 1);
  const eta = Math.min((Math.sqrt(6) * blur(scene.legs.map(([, end]) => end))) / spread, 0.5);
  if (leg >= 1 || eta >= 0.5) return 1;
  return Math.min((2 * Math.sin(Math.asin(leg) / 2) + 2 * eta) / (1 - eta), 1);
}

/** A twist as an axis with a pitch, or as a direction of shifts, in words. */
export function twist(velocity: Vec3, turn: Vec3, middle: Vec3, radius: number, unitName: string): PoseNumbers["motion"] {
  const size = length(turn);
  if (size * radius <= 1e-9 * length(velocity))
    return { axis: unit(velocity), through: middle, pitch: null, text: "the platform can shift" };
  const axis = scale(turn, 1 / size);
  const raw = (axis[0] * velocity[0] + axis[1] * velocity[1] + axis[2] * velocity[2]) / size;
  const pitch = Math.abs(raw) > 1e-9 * radius ? raw : 0;
  const foot = cross(turn, velocity).map((c, i) => middle[i]! + c / size ** 2) as Vec3;
  const advance = `${Number(pitch.toPrecision(3))}${unitName ? ` ${unitName}` : ""}/rad`.replace("-", "−");
  return { axis, through: foot, pitch, text: pitch ? `the platform can screw, with pitch ${advance}` : "the platform can turn" };
}

/** The named lines, and the points in which planes and lines meet or nearly do so. */
function constructions(scene: Scene, recipe: Recipe): Constructed[] {
  const { near, met } = recipe.thresholds;
  const middle = centre(Object.values(scene.points));
  const found: Constructed[] = [];
  for (const line of recipe.lines) {
    const at = lineOf(constructed(line.of, scene.points), middle);
    if (at) found.push({ kind: "line", label: line.label, ...at, entities: [], colour: line.colour });
  }
  const small = Object.fromEntries(
    Object.entries(scene.points).map(([n, p]) => [n, scale(sub(p, middle), 1 / recipe.size)]),
  );
  for (const one of recipe.points) {
    const place = common(one.of.map((part) => constructed(part, small)), met);
    if (!place || place.miss > near) continue;
    const at = place.at.map((c, i) => c * recipe.size + middle[i]!) as Vec3;
    found.push({ kind: "point", label: place.miss <= met ? one.label : `≈ ${one.label}`, at, entities: one.entities });
  }
  return found;
}

const plainName = (label: string): string => label.replace(/^≈ /, "");

/** What a scene shows as constructed, with its points elsewhere: what does not follow from these stays, and what is not there any
 * more is left out. */
export function constructedAt(scene: Scene, recipe: Recipe, points: Record<string, Vec3>): Constructed[] {
  const found = constructions({ ...scene, points }, recipe);
  const known = new Set([...recipe.lines, ...recipe.points].map(({ label }) => label));
  return (scene.constructed ?? []).flatMap((one) => {
    if (!known.has(plainName(one.label))) return [one];
    return found.filter(({ kind, label }) => kind === one.kind && plainName(label) === plainName(one.label));
  });
}
