// What can be dragged in the picture: waypoints of a way that is given, and joints while the panel of the shape is open.
import { effect } from "@preact/signals";
import type { PathAnswer, Pose, Study, Vec3 } from "../../protocol";
import type { Grip, Options, Viewer } from "../../viewer";
import { carried, IDENTITY } from "../../viewer/pose";
import { add, sub } from "../../viewer/vectors";
import { fileAt, jointWords, pointsOf, seenAt, shapeOf, snapped, stepOf, writtenAt } from "../state/joint-places";
import { isHome, samePose } from "../state/doc";
import { sceneOf } from "../state/scene";
import type { Store } from "../state/store";

/** Whether joints are dragged: those of a robot of joints at home, where its file says where they are. */
const resizes = ({ panel$, study, pose$ }: Store): boolean =>
  panel$.value === "dimensions" && study.value !== null && (study.value.kind === "platform" || isHome(pose$.value));

/** Whether a way that is given is drawn. */
const isOnShow = ({ timeline, space }: Store): boolean => timeline.given.value && space.layers.value.way;

type Handlers = Required<Pick<Options, "onGrip" | "onChoose" | "onRemove" | "onInsert">>;

export function gripHandlers(store: Store): Handlers {
  const { timeline, resizing, study, pose$ } = store;
  let between: { id: string; index: number } | null = null; // what was dragged out of the line
  let from: { name: string; at: Vec3 } | null = null; // where a joint was when the hand took it

  function stopOf(id: string): number | null {
    const [look, index] = id.split(" ");
    if (look === "stop") return Number(index);
    if (between?.id === id) return between.index;
    if (!timeline.insert(Number(index))) return null;
    between = { id, index: Number(index) + 1 };
    return between.index;
  }

  function dragJoint(shown: Study, name: string, seen: Vec3): void {
    const wanted = resizing.wanted.peek();
    const now = shapeOf(shown, wanted).points[name] ?? [0, 0, 0];
    if (from?.name !== name) from = { name, at: now };
    const to = snapped(fileAt(shown, wanted, pose$.peek(), name, seen), from.at, stepOf(shown));
    resizing.selected.value = name;
    if (to.some((c, i) => c !== now[i])) resizing.move(name, writtenAt(to, now));
  }

  function withStop(id: string, act: (index: number) => void): void {
    const index = jointOf(id) === null ? stopOf(id) : null;
    if (index !== null) act(index);
  }

  return {
    onGrip(id, { at, turn }, done) {
      const shown = study.peek();
      if (!shown) return;
      const joint = jointOf(id);
      if (joint !== null) {
        if (!done) return dragJoint(shown, joint, at);
        from = null;
        return resizing.done();
      }
      const index = stopOf(id);
      if (index === null) return;
      timeline.choose(index);
      resizing.selected.value = null;
      if (!done) return timeline.carry(index, { translation: sub(at, shown.about), quaternion: turn });
      between = null;
      timeline.done();
    },
    onChoose(id) {
      const joint = id === null ? null : jointOf(id);
      resizing.selected.value = joint;
      timeline.choose(id === null || joint !== null ? null : stopOf(id));
      if (between) timeline.done();
      between = null;
    },
    onRemove: (id) => withStop(id, timeline.remove),
    onInsert: (id) => withStop(id, (index) => (timeline.insert(index), timeline.done())),
  };
}

const jointOf = (id: string): string | null => (id.startsWith("joint ") ? id.slice(6) : null);

export function showGrips(store: Store, viewer: Viewer): () => void {
  const { timeline, resizing, study, pose$ } = store;
  const platformOf = placesKnown(store);
  const stops = [
    effect(() => {
      const shown = study.value;
      const joints = shown && resizes(store) ? jointGrips(shown, store) : [];
      const given = shown !== null && isOnShow(store);
      const way = given ? wayGrips(shown, store, platformOf) : [];
      const line = given ? lineOf(shown, timeline.proof.value, way) : null;
      const [joint, stop] = [resizing.selected.value, timeline.chosen.value];
      const chosen = joint !== null ? `joint ${joint}` : stop !== null && given ? `stop ${stop}` : null;
      viewer.update({ grips: [...joints, ...way], way: line, chosen });
    }),
    // joints are where they are dragged to at once; what follows from them comes with the answer
    effect(() => {
      const [shown, wanted] = [study.value, resizing.wanted.value];
      if (!shown || shown.kind === "robot" || Object.keys(wanted).length === 0) return;
      const { points, about } = shapeOf(shown, wanted);
      viewer.update({ points, about, pose: IDENTITY, constructed: [], motion: null });
      viewer.setPose(pose$.peek());
    }),
  ];
  return () => stops.forEach((stop) => stop());
}

function jointGrips(shown: Study, { resizing, pose$ }: Store): Grip[] {
  const [wanted, pose, step] = [resizing.wanted.value, pose$.value, stepOf(shown)];
  const own = pointsOf(shown).filter(({ name, at }) => at !== null && shown.points[name]);
  return own.map(({ name }) => ({
    id: `joint ${name}`,
    at: seenAt(shown, wanted, pose, name),
    label: name,
    name: jointWords(shown, name),
    look: "joint",
    step,
  }));
}

/** Where the platform is in a pose of the page, as far as that is known. */
type PlatformOf = (pose: Pose) => Pose | null;

/** Of robots of joints the answers about ways tell it; a place stays known when the way changes. */
function placesKnown({ study, timeline }: Store): PlatformOf {
  let known: { of: Study; places: { pose: Pose; platform: Pose }[] } | null = null;
  return (pose) => {
    const shown = study.value;
    if (!shown) return null;
    if (shown.kind !== "robot") return pose;
    if (known?.of !== shown) known = { of: shown, places: [] };
    // a proof is that of the stops as they are; its own poses, which were solved for, are those up to rounding
    const list = timeline.stops.value;
    const found = timeline.proof.value?.samples.flatMap(({ platform, parameter }) => {
      const pose = list[parameter];
      return pose && platform ? [{ pose, platform }] : [];
    });
    if (found) known.places = [...known.places.filter((one) => !found.some((other) => samePose(one.pose, other.pose))), ...found].slice(-1000);
    return known.places.find((one) => samePose(one.pose, pose))?.platform ?? null;
  };
}

function wayGrips(shown: Study, { timeline }: Store, platformOf: PlatformOf): Grip[] {
  const list = timeline.stops.value;
  const proof = timeline.proof.value;
  const stops = list.flatMap((pose, i): Grip[] => {
    const platform = platformOf(pose);
    if (!platform) return [];
    const at = add(shown.about, platform.translation);
    const name = `Waypoint ${i + 1} of ${list.length}`;
    return [{ id: `stop ${i}`, at, turn: platform.quaternion, label: String(i + 1), name, look: "stop" }];
  });
  const between = list.slice(1).flatMap((_, i): Grip[] => {
    const platform = proof && nearestSample(proof, i + 0.5);
    if (!platform) return [];
    const at = add(shown.about, platform.translation);
    return [{ id: `between ${i}`, at, turn: platform.quaternion, label: "", name: "", look: "between" }];
  });
  return [...stops, ...between];
}

function nearestSample({ samples }: PathAnswer, parameter: number): Pose | null {
  const away = (sample: { parameter: number }): number => Math.abs(sample.parameter - parameter);
  const known = samples.filter((sample) => sample.platform !== null && away(sample) < 0.4);
  return known.sort((a, b) => away(a) - away(b))[0]?.platform ?? null;
}

/** The way of the platform's centre: as it was proved, else straight from waypoint to waypoint. */
function lineOf(shown: Study, proof: PathAnswer | null, grips: readonly Grip[]) {
  const place = (platform: Pose | null): Vec3[] => (platform ? [add(shown.about, platform.translation)] : []);
  if (!proof) return { line: grips.flatMap(({ look, at }) => (look === "stop" ? [at] : [])), singular: [] };
  const at = new Map(proof.samples.map(({ parameter, platform }) => [parameter, platform]));
  return {
    line: proof.samples.flatMap(({ platform }) => place(platform)),
    singular: proof.places.flatMap(({ parameter }) => place(at.get(parameter) ?? null)),
  };
}

/** The platform in the pose of the chosen waypoint, pale. */
export function ghostNow(store: Store): Record<string, Vec3> | undefined {
  const { timeline, study } = store;
  const [shown, index] = [study.value, timeline.chosen.value];
  const pose = index === null || !isOnShow(store) ? undefined : timeline.stops.value[index];
  if (!shown || shown.kind !== "platform" || !pose) return undefined;
  const { points, about } = sceneOf(shown);
  const there = (name: string): [string, Vec3][] => (points[name] ? [[name, carried(points[name], IDENTITY, pose, about)]] : []);
  return Object.fromEntries(shown.platform.flatMap(there));
}
