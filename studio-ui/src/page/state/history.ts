// Undo and redo as a pure value. Changes with the same key, such as those of one drag of a slider, make one step.
import { NAVIGATION, sameSource, type Doc } from "./doc";

export interface History {
  past: readonly Doc[];
  present: Doc;
  future: readonly Doc[];
  /** Key of the last change: another change with it joins that step. */
  open: string | null;
}

const MOST = 200;

export const begin = (present: Doc): History => ({ past: [], present, future: [], open: null });

export function record(history: History, change: Partial<Doc>, key: string | null): History {
  const present = { ...history.present, ...change };
  if (key !== null && key === history.open) return { ...history, present };
  return { past: [...history.past, history.present].slice(-MOST), present, future: [], open: key };
}

/** Moves about without leaving a step behind. */
export function moved(history: History, change: Partial<Pick<Doc, (typeof NAVIGATION)[number]>>): History {
  return { ...history, present: { ...history.present, ...change } };
}

export const closed = (history: History): History => ({ ...history, open: null });

export function undone(history: History): History {
  const target = history.past.at(-1);
  if (!target) return history;
  return {
    past: history.past.slice(0, -1),
    present: arrived(history.present, target),
    future: [history.present, ...history.future],
    open: null,
  };
}

export function redone(history: History): History {
  const [target, ...future] = history.future;
  if (!target) return history;
  return { past: [...history.past, history.present], present: arrived(history.present, target), future, open: null };
}

/** Stays where the user is, unless another structure comes back. */
function arrived(from: Doc, to: Doc): Doc {
  return sameSource(from.source, to.source) ? { ...to, panel: from.panel, stage: from.stage, making: from.making, driven: from.driven } : to;
}
