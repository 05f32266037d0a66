// Another robot beside the one on show, in the same pose, or at its own home where it has other freedoms.
import { effect, signal, type ReadonlySignal } from "@preact/signals";
import type { Fault, Numbers, Pose, Source, Study } from "../../protocol";
import type { Client } from "../net/client";
import { latest } from "../net/latest";
import { atHome, sameSource } from "./doc";
import type { Editing } from "./editing";
import { faultOf, type Studying } from "./studying";

export interface Other {
  /** What it is called beside the one on show. */
  name: string;
  source: Source;
  study: Study;
}

export interface Comparing {
  other: ReadonlySignal<Other | null>;
  numbers: ReadonlySignal<Numbers | null>;
  /** Whether it stands in the pose of the one on show. */
  together: ReadonlySignal<boolean>;
  fault: ReadonlySignal<Fault | null>;
  choose(name: string, source: Source): void;
  /** The robot on show as it is now: what it is changed to is seen beside it. */
  keep(): void;
  /** Changes places with the one on show. */
  swap(): void;
  close(): void;
}

/** Poses mean the same for platforms, and for robots with the same actuators. */
const alike = (a: Study, b: Study): boolean => a.kind === b.kind && (a.kind === "platform" || actuators(a) === actuators(b));

const actuators = ({ axes }: Study): string => axes.map(({ name, unit }) => `${name} ${unit}`).join("; ");

export function createComparing(client: Client, editing: Editing, studying: Studying): Comparing {
  const { doc, source$, pose$, threshold$, edit } = editing;
  const other = signal<Other | null>(null);
  const numbers = signal<Numbers | null>(null);
  const together = signal(true);
  const fault = signal<Fault | null>(null);
  let choice = 0;

  const request = latest(
    (asked: { source: Source; pose: Pose; threshold: string }) => client.ask("pose", asked, { channel: "beside" }),
    (found, { source }) => {
      if (!sameSource(source, other.peek()?.source ?? null)) return;
      numbers.value = found;
      fault.value = null;
    },
    (error, { source }) => {
      if (!sameSource(source, other.peek()?.source ?? null)) return;
      numbers.value = null;
      fault.value = faultOf(error);
    },
  );

  effect(() => {
    const [robot, study, pose, threshold] = [other.value, studying.study.value, pose$.value, threshold$.value];
    if (!robot || !study) return;
    together.value = alike(robot.study, study);
    request({ source: robot.source, pose: together.peek() ? pose : atHome(pose), threshold });
  });

  function show(robot: Other | null): void {
    choice += 1;
    numbers.value = null;
    fault.value = null;
    other.value = robot;
  }

  return {
    other,
    numbers,
    together,
    fault,
    choose(name, source) {
      const mine = (choice += 1);
      client.ask("open", { source }).then(
        (study) => mine === choice && show({ name, source, study }),
        (error: unknown) => void (mine === choice && (fault.value = faultOf(error))),
      );
    },
    keep() {
      const [source, study] = [source$.peek(), studying.study.peek()];
      if (source && study) show({ name: `${study.title}, as it was`, source, study });
    },
    swap() {
      const [robot, source, study] = [other.peek(), source$.peek(), studying.study.peek()];
      if (!robot || !source || !study) return;
      const pose = alike(robot.study, study) ? doc.peek().pose : atHome(doc.peek().pose);
      studying.swap(robot.source, robot.study, () => edit({ source: robot.source, pose }));
      show({ name: study.title, source, study });
    },
    close: () => show(null),
  };
}
