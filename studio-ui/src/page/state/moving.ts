// Smooth motion to a pose. It stops when the user takes hold of the platform, and when something else is opened.
import { effect, signal, type ReadonlySignal } from "@preact/signals";
import type { Pose } from "../../protocol";
import { between } from "../lib/rotation";
import type { Editing } from "./editing";
import type { Posing } from "./posing";

export interface Moving {
  active: ReadonlySignal<boolean>;
  to(goal: Pose): void;
  stop(): void;
}

const DURATION = 1400;
const eased = (t: number): number => (t < 0.5 ? 4 * t ** 3 : 1 - (2 - 2 * t) ** 3 / 2);

/** How many poses of the way are looked at, whatever the machine manages to show. */
const SAMPLES = 60;

export function createMoving({ doc, source$, edit, settle }: Editing, posing: Posing): Moving {
  const active = signal(false);
  let frame = 0;

  function stop(): void {
    cancelAnimationFrame(frame);
    if (!active.peek()) return;
    active.value = false;
    settle();
  }

  function to(goal: Pose): void {
    stop();
    settle();
    const from = doc.peek().pose;
    const still = matchMedia("(prefers-reduced-motion: reduce)").matches;
    const start = performance.now();
    const arrive = posing.walk(Array.from({ length: SAMPLES }, (_, i) => between(from, goal, (i + 1) / SAMPLES)));
    active.value = true;
    const step = (now: number): void => {
      const t = still ? 1 : Math.min(Math.max(now - start, 0) / DURATION, 1);
      edit({ pose: t === 1 ? goal : between(from, goal, eased(t)) }, "motion");
      if (t < 1) frame = requestAnimationFrame(step);
      else {
        stop();
        arrive();
      }
    };
    frame = requestAnimationFrame(step);
  }

  // what is opened stands at its own home, whatever was under way
  effect(() => {
    void source$.value;
    stop();
  });

  return { active, to, stop };
}
