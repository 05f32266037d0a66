// A path and a map of what is open, and what they are asked with.
import { effect, signal, type Signal } from "@preact/signals";
import type { Axis, Pose, Study } from "../../protocol";
import type { Client } from "../net/client";
import type { Editing } from "./editing";
import { createRunner, type Runner } from "./running";
import type { Studying } from "./studying";

/** A coordinate of a map with its range. */
export interface Range {
  name: string;
  low: number;
  high: number;
}

export interface Touring {
  path: Runner<"path">;
  map: Runner<"map">;
  place: Runner<"place">;
  /** Where the path begins; null for home. */
  start: Signal<Pose | null>;
  /** Where it ends, in words; "" for the pose on show. */
  to: Signal<string>;
  over: Signal<[Range, Range] | null>;
  nodes: Signal<number>;
}

export function createTouring(client: Client, editing: Editing, { study }: Studying): Touring {
  const start = signal<Pose | null>(null);
  const to = signal("");
  const over = signal<[Range, Range] | null>(null);
  effect(() => {
    const shown = study.value;
    start.value = null;
    to.value = "";
    over.value = shown && first(shown);
  });
  return {
    path: createRunner(client, editing, "path", "Going along the path"),
    map: createRunner(client, editing, "map", "Mapping"),
    place: createRunner(client, editing, "place", "Going there"),
    start,
    to,
    over,
    nodes: signal(25),
  };
}

function first({ ranges: [a, b] }: Study): [Range, Range] | null {
  return a && b ? [rangeOf(a), rangeOf(b)] : null;
}

const rounded = (value: number): number => Number(value.toPrecision(2));

export const rangeOf = ({ name, low, high }: Axis): Range => ({ name, low: rounded(low), high: rounded(high) });

/** As `gcrules map --over` takes it. */
export const inWords = ({ name, low, high }: Range, unit: string, nodes: number): string =>
  `${name} ${low}:${high}:${nodes}${unit === "deg" ? " deg" : ""}`;
