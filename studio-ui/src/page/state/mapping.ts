// A map, coarse at first and refined level by level while one looks; what is there stays when the rest is stopped.
import { effect, signal, type ReadonlySignal } from "@preact/signals";
import type { MapAnswer, MapArgs } from "../../protocol";
import type { Client } from "../net/client";
import type { Editing } from "./editing";
import { createRunner, type Running } from "./running";

export interface Mapped {
  asked: MapArgs;
  result: MapAnswer;
}

export interface Mapping {
  /** The level under way. */
  now: ReadonlySignal<Running<"map">>;
  /** The finest level that is there. */
  shown: ReadonlySignal<Mapped | null>;
  /** Asks for the levels up to so many poses along each axis. */
  start(args: (nodes: number) => MapArgs, nodes: number): Promise<void>;
  stop(): void;
}

const COARSE = 7;

/** Poses along each axis of each level: a few, half as many as at the end, all. */
export const levels = (nodes: number): number[] =>
  [COARSE, Math.ceil(nodes / 2)].filter((n, i, all) => n < nodes && n > (all[i - 1] ?? 0)).concat(nodes);

export function createMapping(client: Client, editing: Editing): Mapping {
  const runner = createRunner(client, editing, "map", "Mapping");
  const shown = signal<Mapped | null>(null);
  let turn = 0;

  effect(() => {
    void editing.source$.value;
    turn += 1;
    shown.value = null;
  });

  async function start(args: (nodes: number) => MapArgs, nodes: number): Promise<void> {
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
