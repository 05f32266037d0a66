// Evaluates the text a moment after it has changed, and again at other poses; the newest question wins. What takes long
// says how far it is; what was stopped, or has reached a limit, is not begun anew by itself.
import { effect, signal, type ReadonlySignal } from "@preact/signals";
import type { Bench, Fault } from "../../../protocol";
import type { Store } from "../../state/store";
import { faultOf } from "../../state/studying";

export interface Evaluation {
  bench: ReadonlySignal<Bench | null>;
  /** A fault of the question as a whole, such as a limit of time. */
  fault: ReadonlySignal<Fault | null>;
  busy: ReadonlySignal<boolean>;
  /** How far it is, once it takes long; "" before. */
  words: ReadonlySignal<string>;
  stopped: ReadonlySignal<boolean>;
  run(): void;
  stop(): void;
  dispose(): void;
}

const PAUSE = 350; // milliseconds of rest after a key
const LONG = 600; // milliseconds after which it is said how far it is

export function createEvaluation({ client, bench$, rules$, source$, pose$, study }: Store): Evaluation {
  const bench = signal<Bench | null>(null);
  const fault = signal<Fault | null>(null);
  const busy = signal(false);
  const words = signal("");
  const stopped = signal(false);
  let timer = 0;
  let running: AbortController | null = null;
  let answered = { text: "", rules: rules$.peek() }; // what `bench` is of
  let ended: string | null = null; // what is not begun anew by itself

  const asked = (): string => JSON.stringify([bench$.peek(), rules$.peek(), study.peek() && source$.peek()]);

  /** Answers to what has changed since are put away. */
  function keep(): void {
    const now = bench.peek();
    if (!now) return;
    const text = bench$.peek();
    const results = rules$.peek() === answered.rules ? now.results.filter(({ end }) => text.slice(0, end) === answered.text.slice(0, end)) : [];
    if (results.length < now.results.length || now.fault) bench.value = { results, fault: null };
  }

  async function run(): Promise<void> {
    window.clearTimeout(timer);
    const before = running;
    const mine = new AbortController();
    running = mine;
    before?.abort();
    const [text, rules, key] = [bench$.peek(), rules$.peek(), asked()];
    const source = study.peek() ? source$.peek() : null;
    let heard = "";
    let long = false;
    const late = window.setTimeout(() => {
      if (running !== mine) return;
      long = true;
      keep();
      words.value = heard || "working";
    }, LONG);
    busy.value = true;
    words.value = "";
    stopped.value = false;
    ended = null;
    try {
      const args = { text, ...(rules.length > 0 && { rules: [...rules] }), ...(source && { source, pose: pose$.peek() }) };
      const progress = (now: string): void => {
        heard = now;
        if (long && running === mine) words.value = now;
      };
      const found = await client.ask("bench", args, { channel: "bench", progress, signal: mine.signal });
      if (running !== mine) return;
      answered = { text, rules };
      bench.value = found;
      fault.value = null;
      if (found.fault?.kind === "limit") ended = key;
    } catch (error) {
      const said = faultOf(error);
      if (running === mine && said.kind !== "cancelled" && said.kind !== "superseded") {
        keep();
        fault.value = said;
        ended = key;
      }
    } finally {
      window.clearTimeout(late);
      if (running === mine) {
        running = null;
        busy.value = false;
        words.value = "";
      }
    }
  }

  const stopEffect = effect(() => {
    const text = bench$.value;
    void [pose$.value, study.value, rules$.value];
    window.clearTimeout(timer);
    if (!text.trim()) {
      end();
      bench.value = null;
      fault.value = null;
      stopped.value = false;
    } else if (ended !== asked()) timer = window.setTimeout(() => void run(), PAUSE);
  });

  /** Ends the work under way, if there is any. */
  function end(): boolean {
    const before = running;
    running = null;
    before?.abort();
    busy.value = false;
    words.value = "";
    return before !== null;
  }

  function stop(): void {
    if (!end()) return;
    ended = asked();
    stopped.value = true;
    fault.value = null;
    keep();
  }

  return {
    bench,
    fault,
    busy,
    words,
    stopped,
    run: () => void run(),
    stop,
    dispose() {
      window.clearTimeout(timer);
      stopEffect();
      end();
    },
  };
}
