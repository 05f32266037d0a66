// The robot that is built: its file is the document; the server reads it as a table and makes every change in it.
import { batch, computed, effect, signal, type ReadonlySignal } from "@preact/signals";
import type { Fault, LimbsAnswer, Numbers, SheetEdit, Source, Study } from "../../../protocol";
import { HOME } from "../../state/doc";
import { faultOf } from "../../state/studying";
import type { Store } from "../../state/store";

export interface Known {
  text: string;
  study: Study;
  /** At home; null until they are there. */
  numbers: Numbers | null;
}

export interface Building {
  /** The file: as it was changed or typed last, or what it begins with. */
  text: ReadonlySignal<string>;
  /** What is known of the text on show, or of the last one that was read. */
  answer: ReadonlySignal<LimbsAnswer | null>;
  /** Why a change was refused, and which. */
  refused: ReadonlySignal<{ fault: Fault; edit: SheetEdit | null } | null>;
  /** The analysis of the last sound text. */
  known: ReadonlySignal<Known | null>;
  analysing: ReadonlySignal<boolean>;
  /** Changes in a row with the same key are undone as one. */
  change(edit: SheetEdit, key?: string): Promise<void>;
  /** Takes a text over, be it at fault. */
  write(text: string, key?: string): void;
  /** Begins with a robot, or with a single limb, in space or in the plane. */
  begin(start: Source | "space" | "plane"): Promise<void>;
  source(): Source;
  dispose(): void;
}

const REST = 180; // milliseconds without a change before a typed text is read
const PAUSE = 350; // … and before a sound one is analysed
const KEPT = 60;
const ANALYSED = 12;

export function createBuilding({ client, edit: record, limbs$, built }: Store): Building {
  const answer = signal<LimbsAnswer | null>(null);
  const refused = signal<{ fault: Fault; edit: SheetEdit | null } | null>(null);
  const known = signal<Known | null>(null);
  const analysing = signal(false);
  const text = computed(() => limbs$.value ?? answer.value?.text ?? "");
  const read = new Map<string, LimbsAnswer>(); // so that undo is there at once
  let chain: Promise<void> = Promise.resolve();
  let timer = 0;

  function keep(found: LimbsAnswer): LimbsAnswer {
    read.set(found.text, found);
    if (read.size > KEPT) read.delete(read.keys().next().value ?? "");
    return found;
  }

  /** Changes one after the other, each of what the one before has made. */
  function inTurn(work: () => Promise<void>): Promise<void> {
    chain = chain.then(work);
    return chain;
  }

  function take(found: LimbsAnswer, key?: string): void {
    keep(found);
    batch(() => {
      answer.value = found;
      refused.value = null;
      if (found.text !== limbs$.peek()) record({ limbs: found.text }, key);
    });
  }

  const change = (edit: SheetEdit, key?: string): Promise<void> =>
    inTurn(async () => {
      const text = limbs$.peek(); // none yet: the server begins with the same limb
      try {
        take(await client.ask("limbs", { ...(text !== null && { text }), edit }), key);
      } catch (error) {
        refused.value = { fault: faultOf(error), edit };
      }
    });

  const begin = (start: Source | "space" | "plane"): Promise<void> =>
    inTurn(async () => {
      try {
        take(await client.ask("limbs", typeof start === "string" ? { plane: start === "plane" } : { start }));
      } catch (error) {
        refused.value = { fault: faultOf(error), edit: null };
      }
    });

  const follow = effect(() => {
    const text = limbs$.value;
    window.clearTimeout(timer);
    if (text === null) {
      void client.ask("limbs", {}).then((found) => {
        if (limbs$.peek() === null) answer.value = keep(found);
      });
      return;
    }
    const there = read.get(text);
    if (there) return void (answer.value = there);
    timer = window.setTimeout(async () => {
      try {
        const found = keep(await client.ask("limbs", { text }, { channel: "limbs" }));
        if (limbs$.peek() === text) answer.value = found;
      } catch (error) {
        const fault = faultOf(error);
        if (limbs$.peek() === text && fault.kind !== "superseded") refused.value = { fault, edit: null };
      }
    }, answer.peek() === null ? 0 : REST);
  });

  const studies = new Map<string, Known>();
  let stop: AbortController | null = null;
  const study = effect(() => {
    const found = answer.value;
    stop?.abort();
    stop = null;
    analysing.value = false;
    if (!found?.sheet || found.every !== null) return undefined;
    const { text } = found;
    const there = studies.get(text);
    if (there) return void (known.value = there);
    const mine = new AbortController();
    stop = mine;
    analysing.value = true;
    const wait = window.setTimeout(async () => {
      try {
        const source = sourceOf(text);
        const study = await client.ask("open", { source }, { signal: mine.signal });
        known.value = { text, study, numbers: null };
        const numbers = await client.ask("pose", { source, pose: HOME }, { signal: mine.signal }).catch(() => null); // without a home
        if (stop !== mine) return;
        known.value = { text, study, numbers };
        studies.set(text, known.value);
        if (studies.size > ANALYSED) studies.delete(studies.keys().next().value ?? "");
      } catch (error) {
        const fault = faultOf(error);
        if (stop === mine && fault.kind !== "cancelled") refused.value = { fault, edit: null };
      } finally {
        if (stop === mine) analysing.value = false;
      }
    }, PAUSE);
    return () => window.clearTimeout(wait);
  });

  const titled = effect(() => void (built.value = answer.value?.sheet?.title ?? "Robot without a title"));

  return {
    text,
    answer,
    refused,
    known,
    analysing,
    change,
    begin,
    write: (typed, key) => void (typed !== text.peek() && record({ limbs: typed }, key)),
    source: () => sourceOf(text.peek()),
    dispose() {
      window.clearTimeout(timer);
      [follow, study, titled].forEach((end) => end());
      stop?.abort();
      built.value = null;
    },
  };
}

/** The file as it is opened and saved. */
export const fileName = (title: string): string =>
  `${title.toLowerCase().normalize("NFKD").replace(/[^a-z0-9]+/g, "-").replace(/^-+|-+$/g, "").slice(0, 40) || "robot"}.yaml`;

const TITLE = /^title:\s*"?([^"\n#]*)/m;

const sourceOf = (text: string): Source => ({ kind: "file", text, name: fileName(TITLE.exec(text)?.[1]?.trim() ?? "") });
