// Evaluates the text a moment after it has changed, and again at other poses; the newest question wins. What takes long
// says how far it is, and shows each answer as soon as it is there; what was stopped, or has reached a limit, is not begun
// anew by itself.
import { effect, signal, type ReadonlySignal } from "@preact/signals";
import type { Bench, BenchResult, Fault, Pose } from "../../../protocol";
import { samePose } from "../../state/doc";
import type { Store } from "../../state/store";
import { faultOf } from "../../state/studying";
import { holds } from "./holding";

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
const SOON = 150; // milliseconds after which answers are shown one by one: before, all of them may come at once
const LONG = 600; // milliseconds after which it is said how far it is

/** A text, and all that its answers depend on but the pose. */
interface Question {
  text: string;
  about: string;
}

interface Run {
  question: Question;
  pose: Pose;
  abort: AbortController;
  /** The answers that are there already. */
  come: readonly BenchResult[];
  heard: string;
}

const same = (a: Question | null, b: Question): boolean => a?.text === b.text && a.about === b.about;

/** Those of the answers to one question that are answers to another one as well. */
const holding = (results: readonly BenchResult[], of: Question, to: Question): BenchResult[] =>
  of.about === to.about ? results.filter(({ end }) => holds(end, of.text, to.text)) : [];

export function createEvaluation({ client, bench$, rules$, source$, pose$, study }: Store): Evaluation {
  const bench = signal<Bench | null>(null);
  const fault = signal<Fault | null>(null);
  const busy = signal(false);
  const words = signal("");
  const stopped = signal(false);
  let timer = 0;
  let running: Run | null = null;
  let answered: Question = { text: "", about: "" }; // what `bench` is of
  let drawnAt = pose$.peek(); // where what it draws is
  let ended: Question | null = null; // what is not begun anew by itself

  const asked = (): Question => ({ text: bench$.peek(), about: JSON.stringify([rules$.peek(), study.peek() && source$.peek()]) });

  /** Shows what is there so far, with answers from before that still hold; others are put away. */
  function showSoFar(run: Run): void {
    const now = asked();
    const before = bench.peek();
    const come = holding(run.come, run.question, now);
    const kept = holding(before?.results ?? [], answered, now).slice(come.length);
    answered = now;
    if (come.length > 0 && !samePose(drawnAt, run.pose)) {
      drawnAt = run.pose;
      kept.forEach((one, i) => (kept[i] = { ...one, drawn: null }));
    }
    if (come.length > 0 || (before && (before.fault || kept.length < before.results.length))) bench.value = { results: [...come, ...kept], fault: null };
  }

  async function ask(mine: Run): Promise<void> {
    const { text } = mine.question;
    const [rules, source] = [rules$.peek(), study.peek() ? source$.peek() : null];
    const args = { text, ...(rules.length > 0 && { rules: [...rules] }), ...(source && { source, pose: mine.pose }) };
    let [soon, long] = [false, false];
    const show = (): void => void (running === mine && mine.come.length > 0 && showSoFar(mine));
    const timers = [
      window.setTimeout(() => {
        soon = true;
        show();
      }, SOON),
      window.setTimeout(() => {
        if (running !== mine) return;
        long = true;
        showSoFar(mine);
        words.value = mine.heard || "working";
      }, LONG),
    ];
    try {
      const found = await client.ask("bench", args, {
        channel: "bench",
        signal: mine.abort.signal,
        progress(now) {
          mine.heard = now;
          if (long && running === mine) words.value = now;
        },
        part({ index, result }) {
          mine.come = [...mine.come.slice(0, index), result];
          if (soon) show();
        },
      });
      if (running !== mine) return;
      mine.come = found.results;
      fault.value = null;
      if (same(mine.question, asked())) {
        [answered, drawnAt] = [mine.question, mine.pose];
        bench.value = found;
      } else showSoFar(mine);
      if (found.fault?.kind === "limit") ended = mine.question;
    } catch (error) {
      const said = faultOf(error);
      if (running !== mine || said.kind === "cancelled" || said.kind === "superseded") return;
      showSoFar(mine);
      fault.value = said;
      ended = mine.question;
      if (same(ended, asked())) erase(pose$.peek());
    } finally {
      timers.forEach((one) => window.clearTimeout(one));
      if (running === mine) {
        running = null;
        busy.value = false;
        words.value = "";
      }
    }
  }

  function run(): void {
    window.clearTimeout(timer);
    const before = running;
    running = { question: asked(), pose: pose$.peek(), abort: new AbortController(), come: [], heard: "" };
    before?.abort.abort();
    busy.value = true;
    words.value = "";
    stopped.value = false;
    ended = null;
    void ask(running);
  }

  const stopEffect = effect(() => {
    const text = bench$.value;
    const pose = pose$.value;
    void [study.value, rules$.value];
    window.clearTimeout(timer);
    if (!text.trim()) {
      end();
      bench.value = null;
      fault.value = null;
      stopped.value = false;
    } else if (!same(ended, asked())) {
      fault.value = null;
      timer = window.setTimeout(() => same(ended, asked()) || run(), PAUSE);
    } else erase(pose);
  });

  /** Where nothing is worked out again, nothing is drawn at a pose that is not on show any more. */
  function erase(pose: Pose): void {
    const now = bench.peek();
    if (!samePose(pose, drawnAt) && now?.results.some(({ drawn }) => drawn)) bench.value = { ...now, results: now.results.map((one) => ({ ...one, drawn: null })) };
  }

  /** Ends the work under way; what there was of it. */
  function end(): Run | null {
    const before = running;
    running = null;
    before?.abort.abort();
    busy.value = false;
    words.value = "";
    return before;
  }

  function stop(): void {
    const before = end();
    if (!before) return;
    ended = asked();
    stopped.value = true;
    fault.value = null;
    showSoFar(before);
    erase(pose$.peek());
  }

  return {
    bench,
    fault,
    busy,
    words,
    stopped,
    run,
    stop,
    dispose() {
      window.clearTimeout(timer);
      stopEffect();
      end();
    },
  };
}
