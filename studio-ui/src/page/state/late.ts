// Whether an answer is late: the numbers on show are then of an earlier pose than the one that is asked for.
import { effect, signal, type ReadonlySignal } from "@preact/signals";
import type { Leading } from "./leading";
import type { Posing } from "./posing";

const PATIENCE = 150; // milliseconds without an answer

export function createLate(posing: Posing, leading: Leading): ReadonlySignal<boolean> {
  const late = signal(false);
  let timer = 0;
  effect(() => {
    void posing.numbers.value; // time counts from the last answer
    window.clearTimeout(timer);
    if (!posing.awaited.value && !leading.awaited.value) late.value = false;
    else timer = window.setTimeout(() => (late.value = true), PATIENCE);
  });
  return late;
}
