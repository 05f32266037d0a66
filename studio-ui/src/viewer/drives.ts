// Sliders for the actuators of a robot of joints, and the scene that follows them.
import type { CarriedPlace, Limb, Linkage, Plane, Skeleton, Terms } from "../protocol";
import { button, make, named as name } from "./elements";
import { limbNumbers, type LimbNumbers } from "./limb-margin";
import { driven, driveTo, home, named, unitOf, type Configuration } from "./linkage";
import { applied } from "./rigid";
import type { Scene, Vec3, Viewer } from "./types";
import { add, along, cross, dot, flatNormal, mix, scale, sub, unit } from "./vectors";

export interface Drives {
  root: HTMLElement;
  /** Shows the robot where it is. */
  start(): void;
  /** The actuators as far towards these amounts from home as the robot assembles; the margin there. */
  to(amounts: number[]): Driven;
}

export interface Driven {
  reached: boolean;
  margin: number;
}

type Places = Record<string, Vec3>;
const DEGREE = Math.PI / 180;

export function drivesOf(viewer: Viewer, scene: Scene & { linkage: Linkage }, tell: (found: LimbNumbers) => void): Drives {
  const m = scene.linkage;
  let at: Configuration = home(m);
  const note = make("p", { class: "gcx-note", role: "status" });
  const rows = m.drives.map((_, i) => row(i));
  const back = button("Home", "The configuration of the file", () => {
    at = home(m);
    note.textContent = "";
    settle();
  });
  const root = make("div", { class: "gcx-drives", role: "group", "aria-label": "Actuators, from home" });
  root.append(make("p", { class: "gcx-unit" }, "Actuators, from home"), ...rows.map((r) => r.row), note, back);

  function settle(): number {
    driven(m, at).forEach((value, i) => rows[i]!.set(value));
    const found = limbNumbers(m, at, scene.unit);
    viewer.update({ ...moved(scene, m, at), motion: found.motion });
    tell(found);
    return found.margin;
  }

  /** An actuator as far towards an amount as the robot assembles, the others where they are. */
  function drive(i: number, amount: number): void {
    const wanted = driven(m, at);
    wanted[i] = amount;
    to(wanted, () => `${m.drives[i]!.name} stops at ${rows[i]!.words()}`);
  }

  function to(amounts: number[], stopped = () => "it stops here"): Driven {
    const found = driveTo(m, at, amounts);
    at = found.at;
    const margin = settle();
    note.textContent = found.reached ? "" : `The robot was followed no further: ${stopped()}.`;
    return { reached: found.reached, margin };
  }

  function row(i: number) {
    const { name: label, text, limb, coordinate } = m.drives[i]!;
    const angle = m.chains[limb]!.turns[coordinate]!;
    const factor = angle ? DEGREE : 1;
    const measure = angle ? "°" : scene.unit;
    const far = angle ? 120 : 1.2 * unitOf(m, i);
    const told = `${label}, ${text}, ${angle ? "degrees" : scene.unit || "length"} from home`;
    const range = make("input", { type: "range", "aria-label": told, min: String(-far), max: String(far), step: String(far / 240) });
    const box = make("input", { type: "number", "aria-label": told, step: "any" });
    for (const input of [range, box])
      input.addEventListener(input === range ? "input" : "change", () => {
        const number = Number(input.value);
        if (input.value !== "" && Number.isFinite(number)) drive(i, number * factor);
      });
    range.addEventListener("change", settle);
    const set = (value: number) => {
      const shown = value / factor;
      range.value = String(shown);
      box.value = String(Math.abs(shown) < 1e-9 * far ? 0 : Number(shown.toPrecision(5)));
    };
    const words = () => `${box.value.replace("-", "−")}${angle ? "°" : measure && ` ${measure}`}`;
    return { row: make("label", { class: "gcx-row", title: text }, name(label), range, box, make("span", { class: "gcx-unit" }, measure)), set, words };
  }

  return { root, start: settle, to: (amounts) => to(amounts) };
}

/** What of a scene follows the links. */
export function moved(scene: Scene, m: Linkage, at: Configuration): Partial<Scene> {
  const all = named(m, at);
  for (const d of m.derived) all[d.name] = derived(d.args, all);
  const points = Object.fromEntries(Object.keys(scene.points).map((n) => [n, all[n] ?? scene.points[n]!]));
  const finite = new Set(m.derived.filter((d) => d.args.length > 2).map((d) => d.name));
  const free = (n: string) => !(n in m.points || finite.has(n)); // a direction
  const limbs = (scene.limbs ?? []).map((limb, i) => movedLimb(limb, m, i, all, free));
  const planes = (scene.planes ?? []).map((p) => movedPlane(p, all, free, scene.size));
  const skeleton = movedSkeleton(m, at);
  if (skeleton) return { points, limbs, skeleton, planes };
  const platform = at.links[0]!.at(-1)!;
  const plate = m.chains.map((c) => applied(platform, c.end));
  const between = ([a, b]: Terms[]): [Vec3, Vec3] => [sum(a!, all), sum(b!, all)];
  const bars = limbs.flatMap((limb, i): [Vec3, Vec3][] => {
    const own = m.bars[i]?.map(between) ?? [];
    const end = plate[m.ends[i] ?? -1];
    const last = limb.joints.filter((j) => j.point).at(-1)?.point;
    const near = own[0] && limb.joints.find((j) => j.point)?.point; // from the arm to the middle of its bars
    if (own.length > 2) return near ? [...own, [near, mix(own[2]![0], own[2]![1], 0.5)]] : own;
    return last && end && !own.length ? [[last, end]] : own;
  });
  bars.push(...m.rods.map(between));
  return { points, limbs, bars, plate, skeleton, planes };
}

/** Links, joints and bodies where the links carry them; null where they are not carried. */
function movedSkeleton({ skeleton }: Linkage, at: Configuration): Skeleton | null {
  const place = ({ links, shares, at: homes }: CarriedPlace) =>
    links.reduce<Vec3>((found, [limb, link], k) => along(found, applied(at.links[limb!]!.at(link!)!, homes[k]!), shares[k]!), [0, 0, 0]);
  return skeleton && {
    strokes: skeleton.strokes.map(({ ends, look }) => ({ ends: ends.map(place), look })),
    signs: skeleton.signs.map((sign) => ({ ...sign, at: place(sign.at), axes: sign.axes.map((axis) => unit(place(axis))) })),
    platform: skeleton.platform.map(place),
    base: skeleton.base.map(place),
  };
}

const sum = (terms: Terms, all: Places): Vec3 =>
  Object.entries(terms).reduce<Vec3>((found, [n, c]) => along(found, all[n]!, c), [0, 0, 0]);

/** u × v, or where the line through p along u meets the plane through q with the normal n. */
function derived(args: Terms[], all: Places): Vec3 {
  const [p, u, q, n] = args.map((terms) => sum(terms, all));
  return q && n ? along(p!, u!, dot(n, sub(q, p!)) / dot(n, u!)) : cross(p!, u!);
}

function movedLimb(limb: Limb, m: Linkage, i: number, all: Places, free: (n: string) => boolean): Limb {
  const joints = limb.joints.map((joint, k) => {
    const made = m.joints[i]![k]!;
    return { ...joint, point: joint.point && sum(made.point, all), axes: made.axes.map((axis) => unit(sum(axis, all))) };
  });
  const lines = limb.lines.map((line, k) => {
    const [p, q] = m.lines[i]![k]!;
    const [a, b] = [all[p]!, all[q]!];
    const point = free(p) ? (free(q) ? null : b) : a;
    const direction = point === null ? cross(a, b) : free(p) ? a : free(q) ? b : sub(b, a);
    return { ...line, point, direction: unit(direction) };
  });
  return { ...limb, joints, lines };
}

/** A plane through points along directions. */
function movedPlane(plane: Plane, all: Places, free: (n: string) => boolean, size: number): Plane {
  if (!plane.points) return plane;
  const finite = plane.points.filter((n) => !free(n)).map((n) => all[n]!);
  const ways = plane.points.filter(free).map((n) => unit(all[n]!));
  const through = [...finite, ...ways.flatMap((u) => finite.flatMap((p) => [-0.35, 0.35].map((s) => add(p, scale(u, s * size)))))];
  const normal = flatNormal(through);
  return normal ? { ...plane, normal, offset: dot(normal, finite[0]!), through } : plane;
}
