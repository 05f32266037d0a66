// A long answer: asked for by the user, with progress and a way to stop. It is forgotten when something else is opened.
import { effect, signal, type ReadonlySignal } from "@preact/signals";
import type { Fault, Method, Methods } from "../../protocol";
import type { Client } from "../net/client";
import type { Editing } from "./editing";
import { faultOf } from "./studying";

export type Running<M extends Method> =
  | { state: "idle" }
  | { state: "busy"; words: string }
  | { state: "found"; asked: Methods[M]["args"]; result: Methods[M]["result"] }
  | { state: "failed"; fault: Fault };

export interface Runner<M extends Method> {
  now: ReadonlySignal<Running<M>>;
  /** The answer, null where there is none or it is not wanted any more. */
  start(args: Methods[M]["args"]): Promise<Methods[M]["result"] | null>;
  stop(): void;
}

/** `channel`: those of one channel give way to each other. */
export function createRunner<M extends Method>(
  client: Client,
  { source$ }: Editing,
  method: M,
  begin: string,
  channel: string = method,
): Runner<M> {
  const now = signal<Running<M>>({ state: "idle" });
  let stop: AbortController | null = null;
  let of = source$.peek();

  effect(() => {
    if (source$.value === of) return;
    of = source$.value;
    stop?.abort();
    stop = null;
    now.value = { state: "idle" };
  });

  async function start(args: Methods[M]["args"]): Promise<Methods[M]["result"] | null> {
    stop?.abort();
    const mine = new AbortController();
    stop = mine;
    const words = (text: string) => void (stop === mine && (now.value = { state: "busy", words: text }));
    words(begin);
    try {
      const result = await client.ask(method, args, { channel, progress: words, signal: mine.signal });
      if (stop !== mine) return null;
      now.value = { state: "found", asked: args, result };
      return result;
    } catch (error) {
      if (stop !== mine) return null;
      const fault = faultOf(error);
      const quiet = fault.kind === "cancelled" || fault.kind === "superseded";
      now.value = quiet ? { state: "idle" } : { state: "failed", fault };
      return null;
    }
  }

  return { now, start, stop: () => stop?.abort() };
}
