// Where the robot can go: what is asked for when the user wants it, and stays until something else is opened.
import type { Client } from "../net/client";
import { withoutMode } from "./choosing";
import type { Editing } from "./editing";
import { createRunner, type Runner } from "./running";

export interface Roaming {
  /** They stay while one of them is taken for the home of a robot of joints. */
  assemblies: Runner<"assemblies">;
  aspects: Runner<"aspects">;
  free: Runner<"free">;
}

export function createRoaming(client: Client, editing: Editing): Roaming {
  const whatever = { ...editing, source$: withoutMode(editing.source$) };
  return {
    assemblies: createRunner(client, whatever, "assemblies", "Following all solutions"),
    aspects: createRunner(client, editing, "aspects", "Looking at poses"),
    free: createRunner(client, editing, "free", "Proving boxes"),
  };
}
