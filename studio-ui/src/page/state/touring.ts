// A path and a map of what is open, and what they are asked with.
import { computed, effect, signal, type ReadonlySignal } from "@preact/signals";
import type { Axis, HereAnswer, MapArgs, Pose, Study } from "../../protocol";
import type { Client } from "../net/client";
import { latest } from "../net/latest";
import { MARGIN, samePose, type Range, type Tour } from "./doc";
import type { Editing } from "./editing";
import { createRefining, type Refining } from "./refining";
import { createRunner, type Runner } from "./running";

export interface Touring {
  path: Runner<"path">;
  map: Refining<"map">;
  surface: Refining<"surface">;
  place: Runner<"place">;
  /** Where the robot is in the map that is drawn; null while that is not known. */
  here: ReadonlySignal<HereAnswer | null>;
  locus: Runner<"locus">;
  /** Changes what is asked; changes of the same field in a row are undone as one. */
  change(part: Partial<Tour>): void;
}

export function createTouring(client: Client, editing: Editing): Touring {
  const { doc, edit } = editing;
  const map = createRefining(client, editing, "map", "Mapping");
  return {
    path: createRunner(client, editing, "path", "Going along the path"),
    map,
    here: createHere(client, editing, map),
    surface: createRefining(client, editing, "surface", "Looking for singular poses"),
    place: createRunner(client, editing, "place", "Going there"),
    locus: createRunner(client, editing, "locus", "Working out the polynomial"),
    change: (part) => edit({ tour: { ...doc.peek().tour, ...part } }, `tour ${Object.keys(part).join(" ")}`),
  };
}

function createHere(client: Client, { pose$ }: Editing, map: Refining<"map">): ReadonlySignal<HereAnswer | null> {
  const told = signal<{ of: MapArgs; pose: Pose; answer: HereAnswer } | null>(null);
  const ask = latest(
    ({ of: { source, over }, pose }: { of: MapArgs; pose: Pose }) => client.ask("here", { source, over, pose }, { channel: "here" }),
    (answer, asked) => (told.value = { ...asked, answer }),
    () => (told.value = null), // the robot does not assemble there, which is told elsewhere
  );
  effect(() => {
    const [shown, pose] = [map.shown.value, pose$.value];
    if (shown) ask({ of: shown.asked, pose });
  });
  return computed(() => {
    const [now, shown] = [told.value, map.shown.value];
    return now && shown && now.of === shown.asked && samePose(now.pose, pose$.value) ? now.answer : null;
  });
}

/** The ranges that were chosen, else the first two; null where there are none, or none of these names any more. */
export function rangesOf({ ranges }: Study, { over }: Tour): [Range, Range] | null {
  const known = (range: Range) => ranges.some(({ name }) => name === range.name);
  if (over?.every(known)) return over;
  const [a, b] = ranges;
  return a && b ? [rangeOf(a), rangeOf(b)] : null;
}

/** What the bands of the map are: what was chosen, if the robot has it. */
export const measureOf = ({ measures }: Study, { measure }: Tour): string =>
  measures.some(({ name }) => name === measure) ? measure : MARGIN;

/** The name of a measure as a word. */
export const spoken = (measure: string): string => measure.replace("_", " ");

const rounded = (value: number): number => Number(value.toPrecision(2));

export const rangeOf = ({ name, low, high }: Axis): Range => ({ name, low: rounded(low), high: rounded(high) });

/** As `gcrules map --over` takes it. */
export const inWords = ({ name, low, high }: Range, unit: string, nodes: number): string =>
  `${name} ${low}:${high}:${nodes}${unit === "deg" ? " deg" : ""}`;

/** The ranges with one of them changed; where it takes the coordinate of the other, they change places. */
export function changed([a, b]: [Range, Range], index: 0 | 1, range: Range): [Range, Range] {
  if (index === 0) return range.name === b.name ? [b, a] : [range, b];
  return range.name === a.name ? [b, a] : [a, range];
}
