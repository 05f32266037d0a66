// Reads a document that comes from outside (a link): every field is checked, what is not understood is left out.
import {
  FARTHEST, LONGEST_FILE, LONGEST_RULES, MOST_COMMANDS, MOST_COORDINATES, MOST_LEGS, MOST_POINTS, MOST_RULES, MOST_RULE_FILES,
  MOST_WAYPOINTS, STAGE_IDS,
  type Pose, type RuleFile, type Sketch, type Source, type Vec3,
} from "../../protocol";
import { EMPTY, FINENESS, HOME, NODES, TOUR, type Doc, type Making, type PanelId, type Range, type Tour } from "./doc";

type Loose = Record<string, unknown>;

const PANELS: readonly PanelId[] = ["start", "guided", "manual", "motion", "where", "dimensions", "bench", "draw", "take-away", "project"];
const MADE: readonly Making[] = ["legs", "limbs"];
/** Panels that need nothing to be open. */
const WITHOUT_SOURCE: readonly PanelId[] = ["bench", "draw", "project"];

const isObject = (x: unknown): x is Loose => typeof x === "object" && x !== null && !Array.isArray(x);
const isText = (x: unknown): x is string => typeof x === "string";
const isNumber = (x: unknown): x is number => typeof x === "number" && Number.isFinite(x);
const listOf = <T>(is: (x: unknown) => x is T) => (x: unknown): x is T[] => Array.isArray(x) && x.every(is);
const isPlace = (x: unknown): x is number => isNumber(x) && Math.abs(x) <= FARTHEST;
const isVec3 = (x: unknown): x is Vec3 => listOf(isPlace)(x) && x.length === 3;
const isLeg = (x: unknown): x is [string, string] => listOf(isText)(x) && x.length === 2;
const isRange = (x: unknown): x is Range => isObject(x) && isText(x.name) && isPlace(x.low) && isPlace(x.high);
const among = <T extends string>(allowed: readonly T[]) => (x: unknown): x is T => allowed.some((a) => a === x);

function readSource(x: unknown): Source | null {
  if (!isObject(x)) return null;
  const { kind, id, name, legs, text } = x;
  const mode = isText(x.mode) ? { mode: x.mode } : {};
  if (kind === "class" && isText(id)) return { kind, id };
  if (kind === "robot" && isText(id)) return { kind, id, ...mode };
  if (kind === "example" && isText(name)) return { kind, name };
  if (kind === "legs" && isText(legs)) return { kind, legs };
  if (kind === "file" && isText(text) && isText(name)) return { kind, text, name, ...mode };
  return null;
}

export function readPose(x: unknown): Pose {
  if (!isObject(x) || !isVec3(x.translation) || !listOf(isNumber)(x.quaternion) || x.quaternion.length !== 4) return HOME;
  const [w, a, b, c] = x.quaternion as [number, number, number, number];
  const size = Math.hypot(w, a, b, c);
  if (!(size > 1e-9 && size < 1e9)) return HOME;
  const unit = Math.abs(size - 1) < 1e-9;
  const pose: Pose = {
    translation: x.translation,
    quaternion: unit ? [w, a, b, c] : [w / size, a / size, b / size, c / size],
  };
  return listOf(isPlace)(x.coordinates) && x.coordinates.length <= MOST_COORDINATES ? { ...pose, coordinates: x.coordinates } : pose;
}

/** A way is read as a whole or not at all: without one of its poses it would be another. */
function readWay(x: unknown): Pose[] {
  if (!Array.isArray(x) || x.length > MOST_WAYPOINTS) return [];
  const found = x.map(readPose);
  return found.includes(HOME) ? [] : found; // that one stands for a pose that cannot be read
}

function readSketch(x: unknown): Sketch | null {
  if (!isObject(x) || !isText(x.title) || !isObject(x.points)) return null;
  const { title, base, platform, legs } = x;
  const all = Object.entries(x.points).filter((e): e is [string, Vec3] => isVec3(e[1]) && !(e[0] in Object.prototype));
  if (!listOf(isText)(base) || !listOf(isText)(platform) || !listOf(isLeg)(legs)) return null;
  const points = Object.fromEntries(all.slice(0, MOST_POINTS));
  const placed = (name: string) => Object.hasOwn(points, name);
  return {
    title,
    points,
    base: base.filter(placed),
    platform: platform.filter(placed),
    legs: legs.filter((leg) => leg.every(placed)).slice(0, MOST_LEGS),
  };
}

const isRuleFile = (x: unknown): x is RuleFile =>
  isObject(x) && isText(x.name) && x.name.trim() !== "" && x.name.length <= 200 && isText(x.text) && !x.text.includes("\0") && x.text.length <= LONGEST_RULES && listOf(isText)(x.off) && x.off.length <= MOST_RULES;

function readRules(x: unknown): readonly RuleFile[] {
  if (!listOf(isRuleFile)(x)) return EMPTY.rules;
  return x.slice(0, MOST_RULE_FILES).map(({ name, text, off }) => ({ name, text, off: off.filter((id) => id.trim() !== "" && id.length <= 200) }));
}

function readTour(x: unknown): Tour {
  if (!isObject(x)) return TOUR;
  const { start, to, over, nodes, measure, box, fineness } = x;
  const [first, second] = listOf(isRange)(over) ? over : [];
  const [a, b, c] = listOf(isRange)(box) ? box : [];
  return {
    start: isObject(start) ? readPose(start) : null,
    to: isText(to) ? to : "",
    over: first && second ? [first, second] : null,
    nodes: isNumber(nodes) && NODES.includes(nodes) ? nodes : TOUR.nodes,
    measure: isText(measure) ? measure : TOUR.measure,
    box: a && b && c && [a, b, c].every(({ name }, i) => name === "xyz"[i]) ? [a, b, c] : null,
    fineness: isNumber(fineness) && FINENESS.includes(fineness) ? fineness : null,
  };
}

export function readDoc(x: unknown): Doc {
  if (!isObject(x)) return EMPTY;
  const source = readSource(x.source);
  const panel = among(PANELS)(x.panel) ? x.panel : EMPTY.panel;
  return {
    source,
    pose: readPose(x.pose),
    panel: source || WITHOUT_SOURCE.includes(panel) ? panel : "start",
    stage: among(STAGE_IDS)(x.stage) ? x.stage : EMPTY.stage,
    threshold: isText(x.threshold) ? x.threshold : EMPTY.threshold,
    commands: listOf(isText)(x.commands) ? x.commands.slice(0, MOST_COMMANDS) : [],
    bench: isText(x.bench) ? x.bench : "",
    rules: readRules(x.rules),
    tour: readTour(x.tour),
    way: readWay(x.way),
    driven: readWay(x.driven),
    making: among(MADE)(x.making) ? x.making : EMPTY.making,
    sketch: readSketch(x.sketch),
    limbs: isText(x.limbs) && x.limbs.length <= LONGEST_FILE ? x.limbs : null,
  };
}
