// Where the robot can go: what is asked for when the user wants it, and stays until something else is opened.
import { effect, signal, type Signal } from "@preact/signals";
import type { Study } from "../../protocol";
import type { Client } from "../net/client";
import { withoutMode } from "./choosing";
import type { Range } from "./doc";
import type { Editing } from "./editing";
import { createRunner, type Runner } from "./running";
import { rangeOf } from "./touring";
export interface Roaming {
  /** They stay while one of them is taken for the home of a robot of joints. */
  assemblies: Runner<"assemblies">;
  aspects: Runner<"aspects">;
  free: Runner<"free">;
  boxes: Runner<"boxes">;
  certify: Runner<"certify">;
  /** What is asked of whole ranges; starts over when something else is opened. */
  whole$: Signal<Whole>;
}

/** Ranges by their names, null for one that is left out; null for those to begin with. What a certificate alone takes: cones of joints, a tilt. */
export interface Whole {
  kind: "map" | "certificate";
  ranges: Readonly<Record<string, Range | null>> | null;
  margin: number;
  limits: string;
  cone: string;
  tilt: string;
  boxes: number;
}

/** Boxes in all, to choose from. */
export const BOXES: readonly number[] = [4_000, 32_000, 250_000, 2_000_000];

const WHOLE: Whole = { kind: "map", ranges: null, margin: 0, limits: "", cone: "", tilt: "", boxes: 32_000 };

/** The ranges that are asked for: those that were chosen, else the first two. */
export const wholeOf = ({ wholes }: Pick<Study, "wholes">, { ranges }: Whole): (Range | null)[] =>
  wholes.map((axis, i) => (ranges ? (ranges[axis.name] ?? null) : i < 2 ? rangeOf(axis) : null));

/** As `gcrules map boxes --over` takes it. */
export const wholeInWords = ({ name, low, high }: Range, unit: string): string => `${name} ${low}:${high}${unit === "deg" ? " deg" : ""}`;

export function createRoaming(client: Client, editing: Editing): Roaming {
  const whatever = { ...editing, source$: withoutMode(editing.source$) };
  const whole$ = signal(WHOLE);
  let of = editing.source$.peek();
  effect(() => {
    if (editing.source$.value === of) return;
    of = editing.source$.value;
    whole$.value = WHOLE;
  });
  return {
    whole$,
    assemblies: createRunner(client, whatever, "assemblies", "Following all solutions"),
    aspects: createRunner(client, editing, "aspects", "Looking at poses"),
    free: createRunner(client, editing, "free", "Proving boxes"),
    boxes: createRunner(client, editing, "boxes", "Proving boxes"),
    certify: createRunner(client, editing, "certify", "Proving boxes"),
  };
}
