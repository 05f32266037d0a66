// A drawing as a value: every change gives a new one.
import type { Sketch, Study, Vec3 } from "../../../protocol";
import type { Scene } from "../../../viewer";

export type Body = "base" | "platform";

export const EMPTY: Sketch = { title: "Drawn robot", points: {}, base: [], platform: [], legs: [] };

const NAME = /^[A-Za-z](_?\d+)?'*$/;

export const bodyOf = (sketch: Sketch, name: string): Body | null =>
  sketch.base.includes(name) ? "base" : sketch.platform.includes(name) ? "platform" : null;

export const placeOf = (sketch: Sketch, name: string): Vec3 => sketch.points[name] ?? [0, 0, 0];

/** The base takes capitals, the platform small letters. */
function freeName(sketch: Sketch, body: Body): string {
  const letters = [..."ABCDEFGHIJKLMNOPQRSTUVWXYZ"].map((c) => (body === "base" ? c : c.toLowerCase()));
  const numbered = letters.map((c) => `${c}1`);
  return [...letters, ...numbered].find((name) => !(name in sketch.points)) ?? `${letters[0] ?? "A"}99`;
}

export function withPoint(sketch: Sketch, body: Body, at: Vec3): Sketch {
  const name = freeName(sketch, body);
  return { ...sketch, points: { ...sketch.points, [name]: at }, [body]: [...sketch[body], name] };
}

export const moved = (sketch: Sketch, name: string, at: Vec3): Sketch =>
  name in sketch.points ? { ...sketch, points: { ...sketch.points, [name]: at } } : sketch;

export function without(sketch: Sketch, name: string): Sketch {
  const { [name]: _, ...points } = sketch.points;
  const others = (names: string[]) => names.filter((n) => n !== name);
  const legs = sketch.legs.filter((leg) => !leg.includes(name));
  return { ...sketch, points, base: others(sketch.base), platform: others(sketch.platform), legs };
}

/** Joints that coincide are one point: the legs of the first go to the second. */
export function merged(sketch: Sketch, from: string, into: string): Sketch {
  const swap = (n: string) => (n === from ? into : n);
  const legs = unique(sketch.legs.map(([a, b]): [string, string] => [swap(a), swap(b)]));
  return without({ ...sketch, legs }, from);
}

export function renamed(sketch: Sketch, from: string, to: string): Sketch {
  const swap = (n: string) => (n === from ? to : n);
  return {
    ...sketch,
    points: Object.fromEntries(Object.entries(sketch.points).map(([n, at]) => [swap(n), at])),
    base: sketch.base.map(swap),
    platform: sketch.platform.map(swap),
    legs: sketch.legs.map(([a, b]) => [swap(a), swap(b)]),
  };
}

/** Why a name will not do; null if it will. */
export function nameFault(sketch: Sketch, from: string, to: string): string | null {
  if (!NAME.test(to)) return "A point is one letter, with digits and primes if you like: a, S1, A'.";
  return to !== from && to in sketch.points ? `There is a point ${to} already.` : null;
}

/** Why there can be no leg between two points; null if there can. */
export function legFault(sketch: Sketch, a: string, b: string): string | null {
  if (a === b) return "A leg joins two points.";
  if (bodyOf(sketch, a) === bodyOf(sketch, b)) return "A leg joins a point of the base to a point of the platform.";
  return hasLeg(sketch, a, b) ? `There is a leg between ${a} and ${b} already.` : null;
}

const hasLeg = (sketch: Sketch, a: string, b: string): boolean =>
  sketch.legs.some((leg) => leg.includes(a) && leg.includes(b));

/** Legs are written from the base to the platform. */
export function withLeg(sketch: Sketch, a: string, b: string): Sketch {
  if (legFault(sketch, a, b)) return sketch;
  const leg: [string, string] = bodyOf(sketch, a) === "base" ? [a, b] : [b, a];
  return { ...sketch, legs: [...sketch.legs, leg] };
}

export const withoutLeg = (sketch: Sketch, at: number): Sketch => ({ ...sketch, legs: sketch.legs.filter((_, i) => i !== at) });

function unique(legs: [string, string][]): [string, string][] {
  return legs.filter(([a, b], i) => legs.findIndex((leg) => leg.includes(a) && leg.includes(b)) === i);
}

export function heightOf({ platform, points }: Sketch, otherwise: number): number {
  if (platform.length === 0) return otherwise;
  const sum = platform.reduce((total, name) => total + (points[name]?.[2] ?? 0), 0);
  return Number((sum / platform.length).toPrecision(6));
}

export function atHeight(sketch: Sketch, height: number): Sketch {
  const by = height - heightOf(sketch, height);
  const lifted = sketch.platform.map((name) => {
    const [x, y, z] = placeOf(sketch, name);
    return [name, [x, y, Number((z + by).toPrecision(9))] as Vec3];
  });
  return { ...sketch, points: { ...sketch.points, ...Object.fromEntries(lifted) } };
}

const NUMBERS = ["no", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten", "eleven", "twelve"];
const word = (n: number): string => NUMBERS[n] ?? String(n);
const counted = (n: number): string => `${word(n)} ${n === 1 ? "leg" : "legs"}`;
const capital = (text: string): string => text.charAt(0).toUpperCase() + text.slice(1);

/** What is still missing, in words; [] where the drawing can be analysed. */
export function missing({ base, platform, legs }: Sketch): string[] {
  if (base.length + platform.length === 0) return ["Click on the sheet to place the points of the base."];
  if (base.length === 0) return ["Place the points of the base."];
  if (platform.length === 0) return ["Place the points of the platform."];
  if (legs.length === 0) return ["Drag legs from the base to the platform: six in all."];
  if (legs.length < 6) return [`${capital(counted(legs.length))} so far: ${word(6 - legs.length)} more to go.`];
  if (legs.length > 6) return [`${capital(counted(legs.length))}: take ${word(legs.length - 6)} away, a platform has six.`];
  return [];
}

export const idle = ({ base, platform, legs }: Sketch): string[] =>
  [...base, ...platform].filter((name) => !legs.some((leg) => leg.includes(name)));

export function fromStudy(study: Study, points: Record<string, Vec3>): Sketch {
  const round = (c: number) => Number(c.toPrecision(6));
  const places = [...study.base, ...study.platform].map((n) => [n, (points[n] ?? [0, 0, 0]).map(round) as Vec3]);
  const { title, base, platform, legs } = study;
  return { title, base, platform, legs, points: Object.fromEntries(places) };
}

export function sceneOfSketch(sketch: Sketch): Scene {
  const { points, base, platform, legs } = sketch;
  const all = Object.values(points);
  const mean = [0, 1, 2].map((i) => all.reduce((sum, p) => sum + (p[i] ?? 0), 0) / Math.max(all.length, 1)) as Vec3;
  const square = all.reduce((sum, p) => sum + p.reduce((s, c, i) => s + (c - (mean[i] ?? 0)) ** 2, 0), 0);
  const size = Math.sqrt(square / Math.max(all.length, 1)) || 1;
  return { points, base, platform, legs, about: mean, size, unit: "", entities: [] };
}

/** Half the height of a sheet that shows all of it. */
export function spanOf({ points }: Sketch): number {
  const far = Object.values(points).flatMap(([x, y]) => [Math.abs(x) / 1.2, Math.abs(y)]);
  return far.length > 1 && Math.max(...far) > 0 ? 1.25 * Math.max(...far) : 250;
}

/** 1, 2 or 5 times a power of ten, near an eighth of the span. */
export function gridOf(span: number): number {
  const rough = span / 10;
  const power = 10 ** Math.floor(Math.log10(rough));
  const lead = rough / power;
  return (lead < 1.5 ? 1 : lead < 3.5 ? 2 : lead < 7.5 ? 5 : 10) * power;
}

export const snapped = (value: number, step: number): number => Number((Math.round(value / step) * step).toPrecision(9));
