// The way that was driven, or that is given by waypoints: proved as soon as the hand rests, and led along.
import { computed, effect, signal, untracked, type ReadonlySignal, type Signal } from "@preact/signals";
import { MOST_WAYPOINTS, type Fault, type Numbers, type PathAnswer, type PathPlace, type Pose, type Sign, type Source } from "../../protocol";
import { driven, lastPassed, poseAt, type Driven, type Scales } from "../lib/way";
import type { Client } from "../net/client";
import { latest } from "../net/latest";
import { samePose, sameSource } from "./doc";
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
  /** The singular pose of the way at which the robot is; null elsewhere. */
  place: ReadonlySignal<PathPlace | null>;
  /** The last crossing that was seen while driving; the proof tells all. */
  crossing: Signal<Crossing | null>;
  /** The singular pose over which the robot was led last along the way as it is; null once it is put away. */
  met: ReadonlySignal<PathPlace | null>;
  /** The crossings that were told have been read. */
  known: ReadonlySignal<boolean>;
  acknowledge(): void;
  /** Where the robot was led to, as a parameter of the way: a whole number at each stop. */
  at: ReadonlySignal<number>;
  playing: ReadonlySignal<boolean>;
  loop: Signal<boolean>;
  speed: Signal<number>;
  fault: ReadonlySignal<Fault | null>;
  /** The table that was read last: a place of the fault is in it. */
  tableRead: ReadonlySignal<string | undefined>;
  /** What was left out or changed of it. */
  notes: ReadonlySignal<readonly string[]>;
  lead(parameter: number): void;
  play(): void;
  pause(): void;
  /** The waypoint that is held in the picture and in the list; null for none. */
  chosen: ReadonlySignal<number | null>;
  choose(index: number | null): void;
  /** A waypoint to where the platform is displaced so; a robot of joints is asked what its actuators do there. Moves of the same one
   * are one step to undo, until the hand lets go (`done`). */
  carry(index: number, platform: Pose): void;
  done(): void;
  /** A waypoint in the middle between this one and the next, on the way as it is; it is then chosen, and moves of it belong to the
   * same step until it is `done`. False where there is none. */
  insert(index: number): boolean;
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

const REST = 150; // milliseconds from the numbers of the last move until the way is proved, if the hand has not let go before
const LASTS = 5000; // milliseconds of a way that is played

export function createTimeline(client: Client, editing: Editing, studying: Studying, posing: Posing): Timeline {
  const { source$, pose$, threshold$, way$, driven$, edit, drive } = editing;
  const given = computed(() => way$.value.length > 0);
  let passed: readonly Pose[] = []; // since the stop before the last
  const crossing = signal<Crossing | null>(null);
  const known = signal(false);
  const at = signal(0);
  const playing = signal(false);
  const loop = signal(false);
  const speed = signal(1);
  const fault = signal<Fault | null>(null);
  const tableRead = signal<string | undefined>(undefined);
  const notes = signal<readonly string[]>([]);
  const passing = signal<{ proof: PathAnswer; place: PathPlace } | null>(null);
  const runner = createRunner(client, editing, "path", "Proving the way", "timeline");
  const stops = computed(() => (given.value ? way$.value : driven$.value));
  const held = signal<number | null>(null);
  const chosen = computed(() => (held.value !== null && held.value < stops.value.length ? held.value : null));
  const proof = computed(() => {
    const now = runner.now.value;
    if (now.state !== "found") return null;
    const { start, through = [], goal } = now.asked;
    const asked = [...(start ? [start] : []), ...through, goal];
    const list = stops.value;
    return asked.length === list.length && asked.every((p, i) => samePose(p, list[i]!)) ? now.result : null;
  });
  const place = computed(() => {
    const [found, pose] = [proof.value, pose$.value];
    return found?.places.find(({ parameter }) => isAt(found, parameter, pose)) ?? null;
  });
  const met = computed(() => (passing.value && passing.value.proof === proof.value ? passing.value.place : null));
  let leads = false; // the pose changes because the way is led along
  let led: Pose | null = null; // where the robot was led to, away from the end of the way
  let wasNamed = false;
  let frame = 0;
  let seen: Numbers | null = null;

  const scales = (): Scales => {
    const study = studying.study.peek();
    const reach = study?.kind === "robot" ? study.axes.map(({ low, high }) => high - low) : [];
    return { length: study?.size ?? 1, coordinates: reach };
  };

  function name(list: readonly Pose[], key?: string): void {
    crossing.value = null;
    notes.value = [];
    edit({ way: list.slice(0, MOST_WAYPOINTS) }, key);
    at.value = Math.min(at.peek(), Math.max(list.length - 1, 0));
  }

  function begin(pose: Pose | null): void {
    pause();
    if (given.peek()) edit({ way: [] });
    led = null;
    crossing.value = null;
    fault.value = null;
    notes.value = [];
    at.value = 0;
    held.value = null;
    passed = [];
    drive(pose ? [pose] : []);
  }

  // another robot, another way
  effect(() => {
    void source$.value;
    untracked(() => {
      seen = null;
      pause();
      led = null;
      passed = [];
      crossing.value = null;
      fault.value = null;
      notes.value = [];
      held.value = null;
      const last = driven$.peek().at(-1);
      if (last && !samePose(last, pose$.peek())) drive([]);
      at.value = Math.max(stops.peek().length - 1, 0);
    });
  });

  // where the robot is driven to
  effect(() => {
    const [pose, study, named] = [pose$.value, studying.study.value, given.value];
    untracked(() => {
      if (!study || study.axes.length === 0 || leads) return;
      pause();
      const back = wasNamed && !named;
      wasNamed = named;
      if (named) return;
      const last = driven$.peek().at(-1);
      if (back && last && !samePose(last, pose)) begin(pose); // what was driven beside the waypoints is not known
      else if (led) begin(led);
      const way: Driven = driven({ stops: driven$.peek(), passed }, pose, scales(), MOST_WAYPOINTS);
      passed = way.passed;
      if (way.stops !== driven$.peek()) drive(way.stops);
      at.value = Math.max(way.stops.length - 1, 0);
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

  // the proof, once the hand lets go, or has rested since the numbers at the pose came
  const waiting = signal<(() => void) | null>(null); // what starts it
  effect(() => {
    const [list, threshold, source] = [stops.value, threshold$.value, source$.value];
    const there = studying.study.value !== null;
    known.value = false;
    const [start, goal] = [list[0], list.at(-1)];
    const asks = source && there && start && goal && list.length >= 2;
    untracked(runner.stop); // while the hand moves on, nobody waits for the way so far
    waiting.value = asks ? () => void runner.start({ source, start, through: list.slice(1, -1), goal, threshold }) : null;
  });
  function prove(): void {
    const start = waiting.peek();
    waiting.value = null;
    start?.();
  }
  effect(() => {
    if (!waiting.value || posing.awaited.value) return;
    const timer = window.setTimeout(prove, REST);
    return () => window.clearTimeout(timer);
  });
  effect(() => {
    void editing.settled.value;
    untracked(prove);
  });

  function lead(parameter: number): void {
    const found = proof.peek();
    const pose = found && poseAt(found, parameter);
    if (!found || !pose) return;
    const place = lastPassed(found.places, at.peek(), parameter);
    if (place) passing.value = { proof: found, place };
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

  function begins(): void {
    at.value = 0;
    passing.value = null;
  }

  function play(): void {
    const found = proof.peek();
    if (!found) return;
    pause();
    playing.value = true;
    if (at.peek() >= found.end - 1e-9) begins();
    let last = performance.now();
    const step = (now: number): void => {
      const { end } = found;
      if (proof.peek() !== found) return pause();
      const next = at.peek() + (Math.max(now - last, 0) * speed.peek() * end) / LASTS;
      last = now;
      if (next >= end && loop.peek()) begins();
      lead(next < end ? next : loop.peek() ? next % end : end);
      if (next >= end && !loop.peek()) return pause();
      frame = requestAnimationFrame(step);
    };
    frame = requestAnimationFrame(step);
  }

  interface Carried {
    index: number;
    source: Source;
    pose: Pose;
    to: Pose;
  }
  let awaited: Carried | null = null;
  let ending = false;
  const carried = latest(
    ({ index: _, ...asked }: Carried) => client.ask("move", asked, { channel: "waypoint" }),
    ({ pose }, asked) => {
      if (!sameSource(asked.source, source$.peek())) return;
      fault.value = null;
      move(asked.index, pose);
      arrived(asked);
    },
    (error, asked) => {
      const why = faultOf(error);
      if (why.kind === "superseded") return;
      fault.value = why;
      arrived(asked);
    },
  );

  function arrived(asked: Carried): void {
    if (asked !== awaited) return;
    awaited = null;
    if (ending) editing.settle();
    ending = false;
  }

  function move(index: number, pose: Pose): void {
    name(stops.peek().map((stop, i) => (i === index ? pose : stop)), `waypoint ${index}`);
  }

  async function asked(args: { poses: Pose[] } | { table: string }) {
    const source = source$.peek();
    fault.value = null;
    tableRead.value = "table" in args ? args.table : undefined;
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
    place,
    crossing,
    met,
    known,
    acknowledge() {
      known.value = true;
      crossing.value = null;
      passing.value = null;
    },
    at,
    playing,
    loop,
    speed,
    fault,
    tableRead,
    notes,
    lead,
    play,
    pause,
    chosen,
    choose: (index) => void (held.value = index),
    carry(index, platform) {
      const [source, pose] = [source$.peek(), stops.peek()[index]];
      if (!source || !pose) return;
      if (studying.study.peek()?.kind !== "robot") return move(index, platform);
      awaited = { index, source, pose, to: platform };
      ending = false;
      carried(awaited);
    },
    done() {
      if (awaited) ending = true;
      else editing.settle();
    },
    insert(index) {
      const [list, found] = [stops.peek(), proof.peek()];
      const pose = found && index + 1 < list.length ? poseAt(found, index + 0.5) : null;
      if (!pose || list.length >= MOST_WAYPOINTS) return false;
      name([...list.slice(0, index + 1), pose, ...list.slice(index + 1)], `waypoint ${index + 1}`);
      held.value = index + 1;
      return true;
    },
    add: () => name([...stops.peek(), pose$.peek()]),
    remove(index) {
      name(stops.peek().filter((_, i) => i !== index));
      held.value = null;
    },
    shift: (index, to) => name(moved(stops.peek(), index, to)),
    put: (index) => name(stops.peek().map((stop, i) => (i === index ? pose$.peek() : stop))),
    clear: () => begin(pose$.peek()),
    take: name,
    async read(table) {
      const found = await asked({ table });
      if (!found) return;
      name(found.poses);
      notes.value = found.notes;
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

function isAt(found: PathAnswer, parameter: number, pose: Pose): boolean {
  const there = poseAt(found, parameter);
  return there !== null && samePose(there, pose);
}
