// The platform on show with other dimensions. The robot changes when the new one is analysed, so that all that is on show stays
// until then; what is dragged meanwhile comes with the next one.
import { batch, signal, type ReadonlySignal, type Signal } from "@preact/signals";
import type { Fault, Source, Study } from "../../protocol";
import type { Client } from "../net/client";
import { latest } from "../net/latest";
import { sameSource } from "./doc";
import type { Editing } from "./editing";
import { faultOf, type Studying } from "./studying";

/** A coordinate as it is written; null keeps it. */
export type Written = readonly [string | null, string | null, string | null];

export interface Resizing {
  fault: ReadonlySignal<Fault | null>;
  /** Where points are wanted, until the platform is so. */
  wanted: ReadonlySignal<Readonly<Record<string, Written>>>;
  /** The joint in hand, in the plan, in the table and in the picture. */
  selected: Signal<string | null>;
  /** The last study that came of it: the same robot with other dimensions. */
  made: ReadonlySignal<Study | null>;
  move(name: string, to: Written): void;
  limit(limits: string): void;
  /** What follows is a step of its own to undo. */
  done(): void;
}

interface Asked {
  source: Source;
  points: Record<string, Written>;
  limits?: string;
}

export function createResizing(client: Client, { doc, source$, way$, driven$, edit, settle }: Editing, studying: Studying): Resizing {
  const fault = signal<Fault | null>(null);
  const wanted = signal<Record<string, Written>>({});
  const selected = signal<string | null>(null);
  const made = signal<Study | null>(null);
  let limits: string | undefined;
  let busy = false;
  let ending = false;

  async function resized({ source, points, limits }: Asked): Promise<{ source: Source; study: Study }> {
    const texts = Object.fromEntries(Object.entries(points).map(([name, c]) => [name, c.map((text) => text ?? "") as [string, string, string]]));
    const args = { source, points: texts, ...(limits !== undefined && { limits }) };
    const next = (await client.ask("resize", args)).source;
    return { source: next, study: await client.ask("open", { source: next }) };
  }

  const request = latest(
    () => {
      const source = source$.peek();
      if (!source) throw new Error("nothing is open");
      const asked: Asked = { source, points: wanted.peek(), ...(limits !== undefined && { limits }) };
      limits = undefined;
      return resized(asked).then((found) => ({ ...found, asked }));
    },
    ({ source, study, asked }) => {
      if (!sameSource(asked.source, doc.peek().source)) return void (wanted.value = {});
      batch(() => {
        fault.value = null;
        made.value = study;
        wanted.value = without(wanted.peek(), asked.points);
        studying.swap(source, study, () => edit({ source, way: way$.peek(), driven: driven$.peek() }, "dimensions"));
      });
      finish();
    },
    (error) => {
      fault.value = faultOf(error);
      wanted.value = {};
      finish();
    },
  );

  function finish(): void {
    if (Object.keys(wanted.peek()).length > 0 || limits !== undefined) return request(undefined);
    busy = false;
    if (ending) settle();
    ending = false;
  }

  function begin(): void {
    busy = true;
    ending = false;
    request(undefined);
  }

  return {
    fault,
    wanted,
    selected,
    made,
    move(name, to) {
      const before = wanted.peek()[name] ?? [null, null, null];
      wanted.value = { ...wanted.peek(), [name]: [to[0] ?? before[0], to[1] ?? before[1], to[2] ?? before[2]] };
      begin();
    },
    limit(text) {
      limits = text;
      begin();
    },
    done() {
      if (busy) ending = true;
      else settle();
    },
  };
}

/** Those that are wanted elsewhere by now. */
function without(wanted: Record<string, Written>, there: Record<string, Written>): Record<string, Written> {
  return Object.fromEntries(Object.entries(wanted).filter(([name, at]) => at !== there[name]));
}
