// A map or a surface, coarse at first and refined level by level while one looks; what is there stays when the rest is
// stopped.
import { effect, signal, type ReadonlySignal } from "@preact/signals";
import type { Methods } from "../../protocol";
import type { Client } from "../net/client";
import type { Editing } from "./editing";
import { createRunner, type Running } from "./running";

type Refinable = "map" | "surface";

export interface Refined<M extends Refinable> {
  asked: Methods[M]["args"];
  result: Methods[M]["result"];
}

export interface Refining<M extends Refinable> {
  /** The level under way. */
  now: ReadonlySignal<Running<M>>;
  /** The finest level that is there. */
  shown: ReadonlySignal<Refined<M> | null>;
  /** Asks for the levels up to so many poses along each axis. */
  start(args: (nodes: number) => Methods[M]["args"], nodes: number): Promise<void>;
  stop(): void;
}

const COARSE = 5; // poses along each axis of the first picture: even where joints are solved for it is soon there

/** Poses along each axis of each level: a few, half as many as at the end, all. */
export const levels = (nodes: number): number[] =>
  [COARSE, Math.ceil(nodes / 2)].filter((n, i, all) => n < nodes && n > 1.3 * (all[i - 1] ?? 0)).concat(nodes);

export function createRefining<M extends Refinable>(
  client: Client,
  editing: Editing,
  method: M,
  begin: string,
): Refining<M> {
  const runner = createRunner(client, editing, method, begin);
  const shown = signal<Refined<M> | null>(null);
  let turn = 0;

  effect(() => {
    void editing.source$.value;
    turn += 1;
    shown.value = null;
  });

  async function start(args: (nodes: number) => Methods[M]["args"], nodes: number): Promise<void> {
    const mine = (turn += 1);
    for (const level of levels(nodes)) {
      const asked = args(level);
      const result = await runner.start(asked);
      if (mine !== turn) return;
      if (!result) {
        if (runner.now.peek().state === "failed") shown.value = null;
        return;
      }
      shown.value = { asked, result };
    }
  }

  function stop(): void {
    turn += 1;
    runner.stop();
  }

  return { now: runner.now, shown, start, stop };
}
