// The nearest singular poses of the pose on show: asked for by the user, with progress and a way to stop.
import { effect, signal, type ReadonlySignal } from "@preact/signals";
import type { Fault, Nearest, Pose } from "../../protocol";
import type { Client } from "../net/client";
import type { Editing } from "./editing";
import { faultOf } from "./studying";

export type Seeking =
  | { state: "idle" }
  | { state: "busy"; words: string }
  | { state: "found"; from: Pose; nearest: Nearest }
  | { state: "failed"; fault: Fault };

export interface Seeker {
  seeking: ReadonlySignal<Seeking>;
  start(): Promise<Nearest | null>;
  stop(): void;
}

export function createSeeker(client: Client, { doc, source$ }: Editing): Seeker {
  const seeking = signal<Seeking>({ state: "idle" });
  let stop: AbortController | null = null;
  let of = source$.peek();

  effect(() => {
    if (source$.value === of) return;
    of = source$.value;
    stop?.abort();
    stop = null;
    seeking.value = { state: "idle" };
  });

  async function start(): Promise<Nearest | null> {
    const { source, pose, threshold } = doc.peek();
    if (!source) return null;
    stop?.abort();
    const mine = new AbortController();
    stop = mine;
    const words = (text: string) => void (seeking.value = { state: "busy", words: text });
    words("Searching");
    try {
      const options = { channel: "nearest", progress: words, signal: mine.signal };
      const nearest = await client.ask("nearest", { source, pose, threshold }, options);
      if (stop !== mine) return null;
      seeking.value = { state: "found", from: pose, nearest };
      return nearest;
    } catch (error) {
      if (stop !== mine) return null;
      const fault = faultOf(error);
      const quiet = fault.kind === "cancelled" || fault.kind === "superseded";
      seeking.value = quiet ? { state: "idle" } : { state: "failed", fault };
      return null;
    }
  }

  return { seeking, start, stop: () => stop?.abort() };
}
