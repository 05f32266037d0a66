// The way that was driven, or that is given by waypoints: proved as soon as the hand rests, and led along.
import { computed, effect, signal, untracked, type ReadonlySignal, type Signal } from "@preact/signals";
import { MOST_WAYPOINTS, type Fault, type Numbers, type PathAnswer, type Pose, type Sign } from "../../protocol";
import { driven, type Driven, type Scales } from "../lib/way";
import { between } from "../lib/rotation";
import type { Client } from "../net/client";
import { samePose } from "./doc";
import type { Editing } from "./editing";
import type { Posing } from "./posing";
import { createRunner, type Running } from "./running";
import { faultOf, type Studying } from "./studying";

/** Factors that changed their sign between two poses: every way between these is singular somewhere. */
export interface Crossing {
  signs: readonly Sign[];
  from: Pose;
  to: Pose;
}

export interface Timeline {
  stops: ReadonlySignal<readonly Pose[]>;
  /** The stops were named or read, and are not drawn on by driving. */
  given: ReadonlySignal<boolean>;
  check: ReadonlySignal<Running<"path">>;
  /** The proof of the way as it is; null while there is none. */
  proof: ReadonlySignal<PathAnswer | null>;
  /** The last crossing that was seen while driving; the proof tells all. */
  crossing: Signal<Crossing | null>;
  /** The crossings that were told have been read. */
  known: ReadonlySignal<boolean>;
  acknowledge(): void;
  /** Where the robot was led to, as a parameter of the way: a whole number at each stop. */
  at: ReadonlySignal<number>;
  playing: ReadonlySignal<boolean>;
  loop: Signal<boolean>;
  speed: Signal<number>;
  fault: ReadonlySignal<Fault | null>;
  lead(parameter: number): void;
  play(): void;
  pause(): void;
  add(): void;
  remove(index: number): void;
  /** Puts a stop before another one. */
  shift(index: number, to: number): void;
  /** The pose on show takes the place of a stop. */
  put(index: number): void;
  clear(): void;
  /** A way of somewhere else, as of a plan. */
  take(stops: readonly Pose[]): void;
  read(table: string): Promise<void>;
  table(): Promise<string | null>;
  stop(): void;
}

export const SPEEDS: readonly number[] = [0.25, 0.5, 1, 2, 4];

const REST = 150; // milliseconds without a move before the way is proved, if the hand has not let go before
const LASTS = 5000; // milliseconds of a way that is played
const NONE: Driven = { stops: [], passed: [] };

export function createTimeline(client: Client, editing: Editing, studying: Studying, posing: Posing): Timeline {
  const { source$, pose$, threshold$, edit } = editing;
  const way = signal<Driven>(NONE);
  const given = signal(false);
  const crossing = signal<Crossing | null>(null);
  const known = signal(false);
  const at = signal(0);
  const playing = signal(false);
  const loop = signal(false);
  const speed = signal(1);
  const fault = signal<Fault | null>(null);
  const runner = createRunner(client, editing, "path", "Proving the way", "timeline");
  const stops = computed(() => way.value.stops);
  const proof = computed(() => {
    const now = runner.now.value;
    if (now.state !== "found") return null;
    const { start, through = [], goal } = now.asked;
    const asked = [...(start ? [start] : []), ...through, goal];
    const list = stops.value;
    return asked.length === list.length && asked.every((p, i) => samePose(p, list[i]!)) ? now.result : null;
  });
  let leads = false; // the pose changes because the way is led along
  let led: Pose | null = null; // where the robot was led to, away from the end of the way
  let frame = 0;
  let seen: Numbers | null = null;

  const scales = (): Scales => {
    const study = studying.study.peek();
    const reach = study?.kind === "robot" ? study.axes.map(({ low, high }) => high - low) : [];
    return { length: study?.size ?? 1, coordinates: reach };
  };

  function name(list: readonly Pose[]): void {
    given.value = true;
    crossing.value = null;
    way.value = { stops: list.slice(0, MOST_WAYPOINTS), passed: [] };
    at.value = Math.min(at.peek(), Math.max(list.length - 1, 0));
  }

  function begin(pose: Pose | null): void {
    pause();
    given.value = false;
    led = null;
    crossing.value = null;
    fault.value = null;
    at.value = 0;
    way.value = pose ? { stops: [pose], passed: [] } : NONE;
  }

  // another robot, another way
  effect(() => {
    void source$.value;
    untracked(() => {
      seen = null;
      begin(null);
    });
  });

  // where the robot is driven to
  effect(() => {
    const [pose, study] = [pose$.value, studying.study.value];
    untracked(() => {
      if (!study || study.axes.length === 0 || leads) return;
      pause();
      if (given.peek()) return;
      if (led) begin(led);
      way.value = driven(way.peek(), pose, scales(), MOST_WAYPOINTS);
      at.value = Math.max(way.peek().stops.length - 1, 0);
    });
  });

  // a change of sign is told at once
  effect(() => {
    const now = posing.numbers.value;
    if (!now) return void (seen = null);
    untracked(() => {
      if (now.verdict === "singular") return;
      const before = seen;
      seen = now;
      if (!before || leads || led || playing.peek()) return;
      const signs = now.signs.filter(({ sign }, i) => sign * (before.signs[i]?.sign ?? 0) < 0);
      if (signs.length > 0) crossing.value = { signs, from: before.pose, to: now.pose };
    });
  });

  // the proof, once the hand rests or lets go
  let timer = 0;
  let waiting: (() => void) | null = null; // what the timer starts
  effect(() => {
    const [list, threshold] = [stops.value, threshold$.value];
    known.value = false;
    window.clearTimeout(timer);
    waiting = null;
    const source = source$.peek();
    const [start, goal] = [list[0], list.at(-1)];
    if (!source || !start || !goal || list.length < 2) return untracked(runner.stop);
    waiting = () => {
      window.clearTimeout(timer);
      waiting = null;
      void runner.start({ source, start, through: list.slice(1, -1), goal, threshold });
    };
    timer = window.setTimeout(waiting, REST);
  });
  effect(() => {
    void editing.settled.value;
    untracked(() => waiting?.());
  });

  function lead(parameter: number): void {
    const found = proof.peek();
    const pose = found && poseAt(found, parameter);
    if (!pose) return;
    at.value = parameter;
    led = !given.peek() && parameter < found.end ? pose : null;
    leads = true;
    edit({ pose }, "way");
    leads = false;
  }

  function pause(): void {
    cancelAnimationFrame(frame);
    if (playing.peek()) editing.settle();
    playing.value = false;
  }

  function play(): void {
    const found = proof.peek();
    if (!found) return;
    pause();
    playing.value = true;
    if (at.peek() >= found.end - 1e-9) at.value = 0;
    let last = performance.now();
    const step = (now: number): void => {
      const { end } = found;
      if (proof.peek() !== found) return pause();
      const next = at.peek() + (Math.max(now - last, 0) * speed.peek() * end) / LASTS;
      last = now;
      lead(next < end ? next : loop.peek() ? next % end : end);
      if (next >= end && !loop.peek()) return pause();
      frame = requestAnimationFrame(step);
    };
    frame = requestAnimationFrame(step);
  }

  async function asked(args: { poses: Pose[] } | { table: string }) {
    const source = source$.peek();
    fault.value = null;
    if (!source) return null;
    try {
      const found = await client.ask("waypoints", { source, ...args }, { channel: "waypoints" });
      return source === source$.peek() ? found : null;
    } catch (error) {
      const said = faultOf(error);
      if (said.kind !== "superseded") fault.value = said;
      return null;
    }
  }

  return {
    stops,
    given,
    check: runner.now,
    proof,
    crossing,
    known,
    acknowledge() {
      known.value = true;
      crossing.value = null;
    },
    at,
    playing,
    loop,
    speed,
    fault,
    lead,
    play,
    pause,
    add: () => name([...stops.peek(), pose$.peek()]),
    remove: (index) => name(stops.peek().filter((_, i) => i !== index)),
    shift: (index, to) => name(moved(stops.peek(), index, to)),
    put: (index) => name(stops.peek().map((stop, i) => (i === index ? pose$.peek() : stop))),
    clear: () => begin(pose$.peek()),
    take: name,
    async read(table) {
      const found = await asked({ table });
      if (found) name(found.poses);
    },
    async table() {
      const list = stops.peek();
      return list.length > 0 ? ((await asked({ poses: [...list] }))?.table ?? null) : null;
    },
    stop: runner.stop,
  };
}

export function moved<T>(list: readonly T[], index: number, to: number): T[] {
  const rest = list.filter((_, i) => i !== index);
  return [...rest.slice(0, to), ...list.slice(index, index + 1), ...rest.slice(to)];
}

/** The pose at a parameter, between the samples whose poses are known; null where they are not. */
export function poseAt({ samples }: Pick<PathAnswer, "samples">, parameter: number): Pose | null {
  const after = samples.findIndex((s) => s.parameter >= parameter);
  const [b, a] = [samples[after < 0 ? samples.length - 1 : after], samples[Math.max((after < 0 ? samples.length : after) - 1, 0)]];
  if (!a?.pose || !b?.pose) return null;
  const span = b.parameter - a.parameter;
  return span > 0 ? between(a.pose, b.pose, Math.min(Math.max((parameter - a.parameter) / span, 0), 1)) : b.pose;
}
