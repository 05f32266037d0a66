// The working modes of the robot that is open. They stay while one of them is taken for its home.
import { effect, signal, type ReadonlySignal } from "@preact/signals";
import type { Source } from "../../protocol";
import type { Client } from "../net/client";
import { sameSource } from "./doc";
import type { Editing } from "./editing";
import { createRunner, type Runner } from "./running";

export function createChoosing(client: Client, editing: Editing): Runner<"modes"> {
  return createRunner(client, { ...editing, source$: withoutMode(editing.source$) }, "modes", "Finding the ways of each limb");
}

/** The source whatever its mode: it changes only when something else is opened. */
export function withoutMode(source$: ReadonlySignal<Source | null>): ReadonlySignal<Source | null> {
  const plain = signal<Source | null>(null);
  effect(() => {
    const source = source$.value;
    const next = source && "mode" in source ? { ...source, mode: undefined } : source;
    if (!sameSource(next, plain.peek())) plain.value = next;
  });
  return plain;
}
