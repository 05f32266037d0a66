// A robot with limbs led by its platform: where it is to be is asked of the server, which answers with what the actuators do.
import { computed, effect, signal, type ReadonlySignal } from "@preact/signals";
import type { Fault, Pose, Source } from "../../protocol";
import type { Client } from "../net/client";
import { latest } from "../net/latest";
import { samePose, sameSource } from "./doc";
import type { Editing } from "./editing";
import type { Posing } from "./posing";
import { faultOf } from "./studying";

export interface Leading {
  /** The freedoms of the study: as wanted while the platform is led, else as they are. */
  values: ReadonlySignal<readonly number[]>;
  /** Why the platform does not get to where it was wanted last; it stays where it was. */
  fault: ReadonlySignal<Fault | null>;
  /** Whether the answer to what was wanted last is still to come. */
  awaited: ReadonlySignal<boolean>;
  /** Sets one of the freedoms, the others kept. */
  set(index: number, value: number): void;
  /** Leads the platform to a pose as far as its freedoms go. */
  to(platform: Pose): void;
  /** The hand has let go: what comes until the last answer is one step to undo. */
  done(): void;
}

interface Asked {
  hands: number;
  source: Source;
  pose: Pose;
  at?: number[];
  to?: Pose;
}

export function createLeading(client: Client, { doc, source$, pose$, edit, settle }: Editing, posing: Posing): Leading {
  const wanted = signal<readonly number[] | null>(null);
  const fault = signal<Fault | null>(null);
  let answered: Pose | null = null;
  const last = signal<Asked | null>(null); // the request whose answer is awaited
  let ending = false;
  let moving = false; // whether the pose changes by an answer
  let hands = 0; // how often anything else has moved the robot, undo for one

  const request = latest(
    ({ hands: _, ...asked }: Asked) => client.ask("move", asked, { channel: "move" }),
    ({ pose }, asked) => {
      if (!current(asked)) return;
      fault.value = null;
      answered = pose;
      moving = true;
      edit({ pose }, "platform");
      moving = false;
      ended(asked);
    },
    (error, asked) => {
      const why = faultOf(error);
      if (!current(asked) || why.kind === "superseded") return;
      fault.value = why;
      wanted.value = null;
      ended(asked);
    },
  );
  const current = (asked: Asked): boolean => asked.hands === hands && sameSource(asked.source, doc.peek().source);

  function ask(what: Pick<Asked, "at" | "to">): void {
    const { source, pose } = doc.peek();
    if (!source) return;
    const asked = { hands, source, pose, ...what };
    last.value = asked;
    request(asked);
  }

  function ended(asked: Asked): void {
    if (asked !== last.peek()) return;
    last.value = null;
    if (ending) settle();
    ending = false;
  }

  // an answer that comes after another hand has moved the robot is not wanted any more
  effect(() => {
    void pose$.value;
    if (moving) return;
    hands += 1;
    last.value = null;
    ending = false;
    wanted.value = null;
  });
  // what was wanted is there when the numbers of its pose are; another hand at the actuators, or undo, ends it too
  effect(() => {
    const pose = pose$.value;
    const numbers = posing.numbers.value;
    if (answered === null || !samePose(pose, answered)) fault.value = null;
    if (answered === null ? false : !samePose(pose, answered) || (numbers !== null && samePose(numbers.pose, pose))) {
      answered = null;
      wanted.value = null;
    }
  });
  effect(() => {
    void source$.value;
    answered = last.value = null;
    ending = false;
    wanted.value = null;
    fault.value = null;
  });

  return {
    values: computed(() => wanted.value ?? posing.numbers.value?.freedoms ?? []),
    fault,
    awaited: computed(() => last.value !== null),
    set(index, value) {
      const now = wanted.peek() ?? posing.numbers.peek()?.freedoms ?? [];
      wanted.value = now.map((c, i) => (i === index ? value : c));
      ask({ at: [...wanted.value] });
    },
    to(platform) {
      ask({ to: platform });
    },
    done() {
      if (last.peek()) ending = true;
      else settle();
    },
  };
}
