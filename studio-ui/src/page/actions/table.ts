// Everything that the page can be told to do, in one table: the list of commands, the list of keys, the keyboard and the buttons
// of the header read it. To add an action, add a row; its keys then work, and are listed.
import type { Store } from "../state/store";
import { atHome, isHome } from "../state/doc";
import { linkOf } from "../state/fragment";
import { panelsOf } from "../panels";
import { namesOf } from "./keys";
import { limbActions } from "./limbs";
import { pictureActions } from "./picture";

export const GROUPS = ["Go to", "Edit", "Pose and way", "Picture", "Page", "Open"] as const;

export interface Action {
  id: string;
  title: string;
  group: (typeof GROUPS)[number];
  /** In the writing of keys.ts; each of them does it. */
  keys?: readonly string[];
  /** Its keys act where something is being written, too. */
  everywhere?: boolean;
  /** Other words by which it is found. */
  words?: string;
  /** Whether it can be done now; always, where that is not said. */
  fits?(): boolean;
  /** Of what is switched: whether it is on. */
  isOn?(): boolean;
  act(): void;
}

/** What it does, and by which keys. */
export const titleOf = ({ title, keys = [] }: Action): string => (keys[0] ? `${title} (${namesOf(keys[0]).join(" ")})` : title);

export const canBeDone = ({ fits }: Action): boolean => fits?.() ?? true;

/** All actions but those that open a structure of the gallery. Of two with the same keys the first that fits is done. */
export function actionsOf(store: Store): Action[] {
  return [...panelActions(store), ...(store.client.alone ? [] : limbActions(store)), ...editActions(store), ...poseActions(store), ...pictureActions(store), ...pageActions(store)];
}

export function actionOf(store: Store, id: string): Action {
  const found = actionsOf(store).find((action) => action.id === id);
  if (!found) throw new RangeError(`no action is called ${id}`);
  return found;
}

/** One for each structure of the gallery. */
export function structureActions({ gallery, open }: Store): Action[] {
  const { examples = [], robots = [], classes = [] } = gallery.value ?? {};
  const items = [...examples, ...robots, ...classes];
  items.sort((a, b) => (a.familiar ?? Infinity) - (b.familiar ?? Infinity) || 0);
  return items.map(({ source, id, title, detail, group, words }) => ({
    id: `open-${source.kind}-${id}`,
    title,
    group: "Open",
    words: [id, detail, group, words].join(" "),
    act: () => open(source),
  }));
}

function panelActions(store: Store): Action[] {
  const { go, source$ } = store;
  return panelsOf(store).map(({ id, title, needs }, i) => ({
    id: `panel-${id}`,
    title,
    group: "Go to",
    ...(i < 9 && { keys: [String(i + 1)] }),
    words: "panel",
    fits: () => needs === "nothing" || source$.value !== null,
    act: () => go({ panel: id }),
  }));
}

function editActions(store: Store): Action[] {
  const { moving, canUndo, canRedo } = store;
  const rested = (act: () => void) => () => (moving.stop(), act());
  return [
    { id: "undo", title: "Undo", group: "Edit", keys: ["Mod z"], fits: () => canUndo.value, act: rested(store.undo) },
    { id: "redo", title: "Redo", group: "Edit", keys: ["Mod Shift z", "Mod y"], fits: () => canRedo.value, act: rested(store.redo) },
  ];
}

function poseActions(store: Store): Action[] {
  const { client, study, pose$, moving, timeline, space, posing, panel$, stage$, go } = store;
  const moves = () => (study.value?.axes.length ?? 0) > 0;
  const step = (by: number) => {
    const stages = study.value?.stages ?? [];
    return stages[Math.max(stages.findIndex(({ id }) => id === stage$.value), 0) + by]?.id;
  };
  const stepAction = (id: string, title: string, key: string, by: number): Action => ({
    id,
    title,
    group: "Go to",
    keys: [key],
    fits: () => panel$.value === "guided" && step(by) !== undefined,
    act() {
      const stage = step(by);
      if (stage) go({ stage });
    },
  });
  return [
    stepAction("step-next", "Next step", "n", 1),
    stepAction("step-back", "Step before", "b", -1),
    {
      id: "home",
      title: "Take the robot home",
      group: "Pose and way",
      keys: ["h"],
      fits: () => moves() && !isHome(pose$.value),
      act: () => moving.to(atHome(pose$.peek())),
    },
    {
      id: "way-play",
      title: "Play the way, or stop it",
      group: "Pose and way",
      keys: ["p"],
      fits: () => timeline.proof.value?.samples.some(({ pose }) => pose !== null) ?? false,
      act: () => (timeline.playing.peek() ? timeline.pause() : timeline.play()),
    },
    { id: "way-add", title: "Add this pose to the way", group: "Pose and way", keys: ["a"], fits: () => !client.alone && moves(), act: timeline.add },
    { id: "way-clear", title: "Start the way over from here", group: "Pose and way", fits: () => !client.alone && moves(), act: timeline.clear },
    {
      id: "motion",
      title: "Play the gained motion, or stop it",
      group: "Pose and way",
      keys: ["m"],
      fits: () => (posing.numbers.value?.motion ?? null) !== null,
      act: () => void (space.playing.value = !space.playing.peek()),
    },
  ];
}

function pageActions(store: Store): Action[] {
  const { client, front, taste, space, lit, doc, study, bench$, projecting } = store;
  const served = () => !client.alone;
  const dark = () => taste.theme.value === "dark";
  async function copyLink(): Promise<void> {
    const { fragment, short } = await linkOf(doc.peek());
    await navigator.clipboard.writeText(location.origin + location.pathname + fragment);
    front.tell(short ? "The link is copied without the way, with which it would be too long" : "The link is copied");
  }
  return [
    { id: "palette", title: "Commands", group: "Page", keys: ["Mod k"], everywhere: true, words: "palette", act: () => void (front.dialog.value = "palette") },
    { id: "keys", title: "Keys", group: "Page", keys: ["?"], words: "shortcuts keyboard help", act: () => void (front.dialog.value = "keys") },
    { id: "tour", title: "A tour of three minutes", group: "Page", words: "help introduction begin learn", fits: served, act: () => void (front.tour.value = 0) },
    {
      id: "repeat",
      title: "Repeat it: lines for the shell and for Python",
      group: "Page",
      keys: ["r"],
      words: "command line copy terminal notebook script",
      fits: () => served() && (study.value !== null || bench$.value.trim() !== ""),
      act: () => void (front.dialog.value = "repeat"),
    },
    {
      id: "project-keep",
      title: "Add what is open to the project, or bring it up to date there",
      group: "Page",
      keys: ["Mod s"],
      words: "save keep bookmark",
      fits: () => served() && study.value !== null,
      act() {
        projecting.keep();
        front.tell("Kept in the project");
      },
    },
    {
      id: "copy-link",
      title: "Copy a link that restores this state",
      group: "Page",
      words: "share url",
      act: () => void copyLink().catch(() => front.tell("The browser does not allow copying")),
    },
    {
      id: "theme",
      title: dark() ? "Light colours" : "Dark colours",
      group: "Page",
      keys: ["t"],
      words: "theme dark light",
      act: () => void (taste.chosen.value = dark() ? "light" : "dark"),
    },
    { id: "glossary", title: "Glossary", group: "Page", keys: ["g"], words: "terms words meaning help", act: () => front.glossary() },
    {
      id: "hide-term",
      title: "Close the explanation of a word",
      group: "Page",
      keys: ["Escape"],
      fits: () => front.term.value !== null,
      act: () => void (front.term.value = null),
    },
    {
      id: "leave-large",
      title: "Show the page beside the picture again",
      group: "Page",
      keys: ["Escape"],
      fits: () => space.large.value,
      act: () => void (space.large.value = false),
    },
    {
      id: "let-go",
      title: "Let go of what is lit up",
      group: "Page",
      keys: ["Escape"],
      fits: () => lit.pinned.value !== null,
      act: () => lit.pin(null),
    },
  ];
}
