// Opening what is to be studied: the answer to the document's source, with progress and a way to stop.
import { batch, effect, signal, type ReadonlySignal } from "@preact/signals";
import type { Fault, Source, Study } from "../../protocol";
import { Refused, type Client } from "../net/client";
import { sameSource } from "./doc";
import type { Editing } from "./editing";

export type Loaded =
  | { state: "none" }
  | { state: "loading"; source: Source; words: string; stop(): void }
  | { state: "ready"; source: Source; study: Study }
  | { state: "failed"; source: Source; fault: Fault };

export interface Studying {
  loaded: ReadonlySignal<Loaded>;
  study: ReadonlySignal<Study | null>;
  again(): void;
  /** Puts a robot in the place of the one on show that has been analysed already; `change` is that of the document. */
  swap(source: Source, study: Study, change: () => void): void;
}

export function createStudying(client: Client, { source$ }: Editing): Studying {
  const loaded = signal<Loaded>({ state: "none" });
  const study = signal<Study | null>(null);
  let wanted: Source | null = null;
  let stop: AbortController | null = null;

  async function load(source: Source): Promise<void> {
    const mine = new AbortController();
    stop = mine;
    const words = (text: string) =>
      void (loaded.value = { state: "loading", source, words: text, stop: () => mine.abort() });
    words("Analysing the structure");
    try {
      const found = await client.ask("open", { source }, { progress: words, signal: mine.signal });
      if (stop !== mine) return;
      study.value = found;
      loaded.value = { state: "ready", source, study: found };
    } catch (error) {
      if (stop !== mine) return;
      study.value = null;
      loaded.value = { state: "failed", source, fault: faultOf(error) };
    }
  }

  effect(() => {
    const source = source$.value;
    if (sameSource(source, wanted)) return;
    wanted = source;
    const before = stop;
    stop = null;
    before?.abort();
    study.value = null;
    if (source) void load(source);
    else loaded.value = { state: "none" };
  });

  function swap(source: Source, found: Study, change: () => void): void {
    stop?.abort();
    stop = null;
    wanted = source;
    batch(() => {
      study.value = found;
      loaded.value = { state: "ready", source, study: found };
      change();
    });
  }

  return { loaded, study, again: () => wanted && void load(wanted), swap };
}

export function faultOf(error: unknown): Fault {
  if (error instanceof Refused) return error.fault;
  return { kind: "fault", message: error instanceof Error ? error.message : String(error) };
}
