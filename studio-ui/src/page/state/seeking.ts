// The nearest singular poses of the pose on show.
import type { ReadonlySignal } from "@preact/signals";
import type { Nearest } from "../../protocol";
import type { Client } from "../net/client";
import type { Editing } from "./editing";
import { createRunner, type Running } from "./running";

export type Seeking = Running<"nearest">;

export interface Seeker {
  seeking: ReadonlySignal<Seeking>;
  start(): Promise<Nearest | null>;
  stop(): void;
}

export function createSeeker(client: Client, editing: Editing): Seeker {
  const runner = createRunner(client, editing, "nearest", "Searching");

  async function start(): Promise<Nearest | null> {
    const { source, pose, threshold } = editing.doc.peek();
    return source && runner.start({ source, pose, threshold });
  }

  return { seeking: runner.now, start, stop: runner.stop };
}
