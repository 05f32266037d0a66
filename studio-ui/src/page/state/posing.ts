// Numbers at the pose: asked for at every move, latest first; with the way that the margin has gone.
import { batch, computed, effect, signal, type ReadonlySignal } from "@preact/signals";
import type { Along, Fault, Headline, Numbers, Pose, Source } from "../../protocol";
import type { Client } from "../net/client";
import { latest } from "../net/latest";
import { samePose, sameSource } from "./doc";
import type { Editing } from "./editing";
import { faultOf, type Studying } from "./studying";
import { extended, LONGEST, passedOf, type Passed } from "./trail";

export interface Posing {
  numbers: ReadonlySignal<Numbers | null>;
  /** Value, margin and verdict, which come before all the other numbers where these take long. */
  headline: ReadonlySignal<Headline | null>;
  fault: ReadonlySignal<Fault | null>;
  /** Whether the answer for the pose on show is still to come. */
  awaited: ReadonlySignal<boolean>;
  /** The margin below which a pose is close; null where no margin says it (the threshold is a length). */
  close: ReadonlySignal<number | null>;
  /** The last moves; refreshed at most ten times a second. */
  trail: ReadonlySignal<readonly Passed[]>;
  forget(): void;
  /** A way that is gone now: evenly sampled by the server. The function that is returned puts it into the trail. */
  walk(way: Pose[]): () => void;
}

interface Asked {
  source: Source;
  pose: Pose;
  threshold: string;
}

const THROTTLE = 100; // milliseconds between two pictures of the way

export function createPosing(client: Client, editing: Editing, studying: Studying): Posing {
  const numbers = signal<Numbers | null>(null);
  const headline = signal<Headline | null>(null);
  const fault = signal<Fault | null>(null);
  const open = signal<Asked | null>(null); // what was asked last, until it is answered
  const awaited = computed(() => open.value !== null);
  const close = computed(() => headline.value?.close ?? null);
  const trail = signal<readonly Passed[]>([]);
  let passed: readonly Passed[] = [];
  let timer = 0;

  const current = (asked: Asked) => sameSource(asked.source, editing.doc.peek().source) && studying.study.peek() !== null;

  function note(found: Numbers): void {
    show(extended(passed, found));
  }

  function show(way: readonly Passed[]): void {
    passed = way;
    timer ||= window.setTimeout(() => {
      timer = 0;
      trail.value = passed;
    }, THROTTLE);
  }

  const request = latest(
    (asked: Asked) => client.ask("pose", { ...asked }, { channel: "pose", part: (first) => begun(asked, first) }),
    (found, asked) =>
      batch(() => {
        answered(asked);
        if (!current(asked)) return;
        numbers.value = headline.value = found;
        fault.value = null;
        note(found);
      }),
    (error, asked) =>
      batch(() => {
        answered(asked);
        const said = faultOf(error);
        if (current(asked) && said.kind !== "superseded") fault.value = said;
      }),
  );

  function begun(asked: Asked, first: Headline): void {
    if (!current(asked)) return;
    batch(() => {
      headline.value = first;
      fault.value = null;
    });
  }

  function answered(asked: Asked): void {
    if (asked === open.peek()) open.value = null;
  }

  function forget(): void {
    passed = [];
    trail.value = passed;
  }

  function walk(way: Pose[]): () => void {
    const before = passed;
    const { source, threshold } = editing.doc.peek();
    let sampled: readonly Passed[] = [];
    let gone = false;
    const goal = way.at(-1);
    const put = () => void (sampled.length > 0 && show([...before, ...sampled].slice(-LONGEST)));
    const asked = source ? client.ask("along", { source, poses: way, threshold }, { channel: "along" }) : null;
    const take = (found: Along): void => {
      sampled = passedOf(found, way);
      // an answer that comes late counts as long as the platform has not left
      if (gone && goal && samePose(editing.doc.peek().pose, goal)) put();
    };
    asked?.then(take, () => undefined); // without an answer the poses seen on the way stay
    return () => {
      gone = true;
      put();
    };
  }

  effect(() => {
    if (studying.study.value !== null) return;
    numbers.value = headline.value = null;
    fault.value = null;
    open.value = null;
    forget();
  });

  const { source$, pose$, threshold$ } = editing;
  effect(() => {
    const [pose, threshold, source] = [pose$.value, threshold$.value, source$.peek()];
    if (!studying.study.value || !source) return;
    const asked = { source, pose, threshold };
    open.value = asked;
    request(asked);
  });

  return { numbers, headline, fault, awaited, close, trail, forget, walk };
}
