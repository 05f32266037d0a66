// A project as a file: JSON with a number of its format. It is read as a whole or not at all.
import type { Fault, Pose } from "../../protocol";
import { leftOut } from "../lib/strict";
import type { Doc } from "./doc";
import { changedFields } from "./fragment";
import { readDoc, readPose } from "./read";

export interface NamedPose {
  name: string;
  pose: Pose;
}

/** A robot at hand, with all that was done with it. */
export interface KeptRobot {
  name: string;
  note: string;
  state: Doc;
  way: readonly Pose[];
  poses: readonly NamedPose[];
}

export interface Project {
  title: string;
  note: string;
  robots: readonly KeptRobot[];
}

export const NO_PROJECT: Project = { title: "", note: "", robots: [] };

export const FORMAT = 1;
const KIND = "gcrules studio project";
const LONGEST = 8_000_000; // characters

export function writeProject({ title, note, robots }: Project): string {
  const kept = robots.map(({ state, ...robot }) => ({ ...robot, state: changedFields(state) }));
  return `${JSON.stringify({ kind: KIND, format: FORMAT, title, note, robots: kept }, null, 2)}\n`;
}

/** Whether a text means to be a project, whatever is wrong with it. */
export const isProject = (text: string): boolean => /^\s*\{[^{}[\]]*"kind"\s*:\s*"gcrules studio project"/.test(text);

class Unfit extends Error {
  constructor(
    message: string,
    readonly hint?: string,
  ) {
    super(message);
  }
}

/** The project of a text, or what is wrong with it. */
export function readProject(text: string, name: string): { project: Project } | { fault: Fault } {
  try {
    return { project: read(text) };
  } catch (error) {
    if (!(error instanceof Unfit)) throw error;
    const hint = error.hint ?? "nothing of it was opened";
    return { fault: { kind: "input", message: `${name}: ${error.message}`, hint } };
  }
}

function read(text: string): Project {
  if (text.length > LONGEST) throw new Unfit(`it is larger than ${LONGEST / 1e6} MB`);
  const x = object(parsed(text), "the file", ["kind", "format", "title", "note", "robots"]);
  if (x.kind !== KIND) throw new Unfit("it is not a project of the studio", `its "kind" would be "${KIND}"`);
  if (typeof x.format !== "number") throw new Unfit("it does not give the number of its format", `"format": ${FORMAT}`);
  if (x.format !== FORMAT) throw new Unfit(`its format is ${x.format}, and this studio reads ${FORMAT}`, "a newer gcrules has written it");
  return { title: words(x.title, "title"), note: words(x.note, "note"), robots: list(x.robots, "robots").map(robot) };
}

function parsed(text: string): unknown {
  try {
    return JSON.parse(text);
  } catch (error) {
    throw new Unfit(`it is not JSON: ${error instanceof Error ? error.message : String(error)}`);
  }
}

function robot(given: unknown, i: number): KeptRobot {
  const at = `robots[${i + 1}]`;
  const x = object(given, at, ["name", "note", "state", "way", "poses"]);
  const told = object(x.state, `${at}.state`);
  if (!("source" in told)) throw new Unfit(`${at}.state names no robot`, 'its "source" says which');
  const state = readDoc(told);
  whole(told, state, `${at}.state`);
  return {
    name: words(x.name, `${at}.name`),
    note: words(x.note, `${at}.note`),
    state,
    way: list(x.way, `${at}.way`).map((p, k) => pose(p, `${at}.way[${k + 1}]`)),
    poses: list(x.poses, `${at}.poses`).map((p, k) => {
      const place = `${at}.poses[${k + 1}]`;
      const named = object(p, place, ["name", "pose"]);
      return { name: words(named.name, `${place}.name`), pose: pose(named.pose, `${place}.pose`) };
    }),
  };
}

function pose(given: unknown, at: string): Pose {
  const found = readPose(given);
  whole(object(given, at), found, at);
  return found;
}

function whole(given: object, found: object, at: string): void {
  const place = leftOut(given, found, at);
  if (place !== null) throw new Unfit(`${place} is not understood`);
}

function object(x: unknown, at: string, keys?: readonly string[]): Record<string, unknown> {
  if (typeof x !== "object" || x === null || Array.isArray(x)) throw new Unfit(`${at} is not an object`);
  const other = keys && Object.keys(x).find((key) => !keys.includes(key));
  if (other !== undefined) throw new Unfit(`${at} has "${other}", which is not known`, `known are ${keys?.join(", ")}`);
  return x as Record<string, unknown>;
}

function list(x: unknown, at: string): unknown[] {
  if (!Array.isArray(x)) throw new Unfit(`${at} is not a list`);
  return x;
}

function words(x: unknown, at: string): string {
  if (typeof x !== "string") throw new Unfit(`${at} is not text`);
  return x;
}
