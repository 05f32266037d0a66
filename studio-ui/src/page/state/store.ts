// All that the page knows, in one object that every panel is given.
import { signal, type ReadonlySignal, type Signal } from "@preact/signals";
import type { Gallery } from "../../protocol";
import type { Client } from "../net/client";
import type { Doc } from "./doc";
import { createChoosing } from "./choosing";
import { createComparing, type Comparing } from "./comparing";
import { createEditing, type Editing } from "./editing";
import { createFront, type Front } from "./front";
import { createLate } from "./late";
import { createLeading, type Leading } from "./leading";
import { createLit, type Lit } from "./lit";
import { createMoving, type Moving } from "./moving";
import { createPosing, type Posing } from "./posing";
import { createProjecting, type Projecting } from "./projecting";
import { createResizing, type Resizing } from "./resizing";
import type { Runner } from "./running";
import { createSeeker, type Seeker } from "./seeking";
import { createSharing, type Sharing } from "./sharing";
import { createSpace, type Space } from "./space";
import { createStudying, type Studying } from "./studying";
import { createTaste, type Taste } from "./taste";
import { createTimeline, type Timeline } from "./timeline";
import { createTouring, type Touring } from "./touring";
import { createRoaming, type Roaming } from "./roaming";

export interface Store extends Editing, Studying {
  /** Asks the server; see protocol.ts. */
  client: Client;
  gallery: ReadonlySignal<Gallery | null>;
  /** The title of the robot that is being built limb by limb, while that is on show. */
  built: Signal<string | null>;
  posing: Posing;
  timeline: Timeline;
  moving: Moving;
  leading: Leading;
  /** Whether the answer for the pose that is asked for is late. */
  late: ReadonlySignal<boolean>;
  sharing: Sharing;
  resizing: Resizing;
  comparing: Comparing;
  seeker: Seeker;
  projecting: Projecting;
  touring: Touring;
  roaming: Roaming;
  modes: Runner<"modes">;
  lit: Lit;
  front: Front;
  space: Space;
  taste: Taste;
}

export function createStore(client: Client, start: Doc | null): Store {
  const editing = createEditing(start);
  const studying = createStudying(client, editing);
  const gallery = signal<Gallery | null>(null);
  void client.ask("gallery", {}).then((found) => (gallery.value = found));
  const sharing = createSharing(client, editing);
  const front = createFront();
  void client.ask("hello", {}).then(({ opened, shared, guide }) => {
    front.guide.value = guide;
    if (opened && !editing.doc.peek().source) editing.open(opened);
    if (opened && shared) sharing.begin(opened);
  });
  const posing = createPosing(client, editing, studying);
  const leading = createLeading(client, editing, posing);
  const timeline = createTimeline(client, editing, studying, posing);
  return {
    ...editing,
    ...studying,
    client,
    gallery,
    built: signal<string | null>(null),
    posing,
    timeline,
    moving: createMoving(editing, posing),
    leading,
    late: createLate(posing, leading),
    sharing,
    resizing: createResizing(client, editing, studying),
    comparing: createComparing(client, editing, studying),
    seeker: createSeeker(client, editing),
    projecting: createProjecting(editing, studying, timeline),
    touring: createTouring(client, editing),
    roaming: createRoaming(client, editing),
    modes: createChoosing(client, editing),
    lit: createLit(),
    front,
    space: createSpace(),
    taste: createTaste(),
  };
}
