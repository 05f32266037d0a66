// Evaluates the text a moment after it has changed, and again at other poses; the newest question wins.
import { effect, signal, type ReadonlySignal } from "@preact/signals";
import type { Bench, Fault } from "../../../protocol";
import type { Store } from "../../state/store";
import { faultOf } from "../../state/studying";

export interface Evaluation {
  bench: ReadonlySignal<Bench | null>;
  /** A fault of the question as a whole, such as a limit of time. */
  fault: ReadonlySignal<Fault | null>;
  busy: ReadonlySignal<boolean>;
  run(): void;
  stop(): void;
  dispose(): void;
}

const PAUSE = 350; // milliseconds of rest after a key

export function createEvaluation({ client, bench$, source$, pose$, study }: Store): Evaluation {
  const bench = signal<Bench | null>(null);
  const fault = signal<Fault | null>(null);
  const busy = signal(false);
  let timer = 0;
  let running: AbortController | null = null;

  async function run(): Promise<void> {
    window.clearTimeout(timer);
    const before = running;
    const mine = new AbortController();
    running = mine;
    before?.abort();
    const text = bench$.peek();
    const source = study.peek() ? source$.peek() : null;
    busy.value = true;
    try {
      const args = { text, ...(source && { source, pose: pose$.peek() }) };
      const found = await client.ask("bench", args, { channel: "bench", signal: mine.signal });
      if (running !== mine) return;
      bench.value = found;
      fault.value = null;
    } catch (error) {
      const said = faultOf(error);
      if (running === mine && said.kind !== "cancelled" && said.kind !== "superseded") fault.value = said;
    } finally {
      if (running === mine) {
        running = null;
        busy.value = false;
      }
    }
  }

  const stopEffect = effect(() => {
    const text = bench$.value;
    void [pose$.value, study.value];
    window.clearTimeout(timer);
    if (text.trim()) timer = window.setTimeout(() => void run(), PAUSE);
    else {
      bench.value = null;
      fault.value = null;
    }
  });

  function stop(): void {
    const before = running;
    running = null;
    before?.abort();
    busy.value = false;
  }

  return {
    bench,
    fault,
    busy,
    run: () => void run(),
    stop,
    dispose() {
      window.clearTimeout(timer);
      stopEffect();
      stop();
    },
  };
}
