// The document as a signal, its changes, undo and redo, and its copy in the address bar.
import { batch, computed, effect, signal, type ReadonlySignal, type Signal } from "@preact/signals";
import { EMPTY, HOME, TOUR, sameSource, type Doc, type Making, type PanelId } from "./doc";
import { leave, plainFragment, readFragment, writeFragment } from "./fragment";
import { closed, moved, record, redone, undone, type History } from "./history";
import { isReload, recalled, remember } from "./tab-memory";
import { readHistory, writeHistory } from "./undo-memory";
import type { Source, StageId } from "../../protocol";

export interface Editing extends Fields {
  doc: ReadonlySignal<Doc>;
  canUndo: ReadonlySignal<boolean>;
  canRedo: ReadonlySignal<boolean>;
  /** Whether the page came by a link that cannot be read; until it is put away. */
  unread: Signal<boolean>;
  /** Changes the document; changes in a row with the same key are undone as one. */
  edit(change: Partial<Doc>, key?: string): void;
  /** Ends a row of changes: the next one is a step of its own. */
  settle(): void;
  go(where: { panel?: PanelId; stage?: StageId; making?: Making }): void;
  /** Opens a structure at its home pose and shows it. */
  open(source: Source, panel?: PanelId): void;
  undo(): void;
  redo(): void;
}

/** The fields of the document one by one: who reads one is told of its changes only, not of every move of a slider. */
export type Fields = { readonly [K in keyof Doc as `${K}$`]: ReadonlySignal<Doc[K]> };

function fieldsOf(doc: ReadonlySignal<Doc>): Fields {
  return {
    source$: computed(() => doc.value.source),
    pose$: computed(() => doc.value.pose),
    panel$: computed(() => doc.value.panel),
    stage$: computed(() => doc.value.stage),
    threshold$: computed(() => doc.value.threshold),
    commands$: computed(() => doc.value.commands),
    bench$: computed(() => doc.value.bench),
    rules$: computed(() => doc.value.rules),
    tour$: computed(() => doc.value.tour),
    making$: computed(() => doc.value.making),
    sketch$: computed(() => doc.value.sketch),
    limbs$: computed(() => doc.value.limbs),
  };
}

const UNDO = "gcrules-studio-undo"; // key of the steps over a reload

const PAUSE = 300; // milliseconds of rest before the address bar is written

export function createEditing(start: Doc | null): Editing {
  const history = signal<History>(readHistory(isReload() ? recalled(UNDO) : null, start ?? EMPTY));
  const doc = computed(() => history.value.present);

  const edit = (change: Partial<Doc>, key: string | null = null): void => {
    history.value = record(history.peek(), change, key);
  };

  const editing: Editing = {
    doc,
    ...fieldsOf(doc),
    canUndo: computed(() => history.value.past.length > 0),
    canRedo: computed(() => history.value.future.length > 0),
    unread: signal(start === null),
    edit,
    settle: () => void (history.value = closed(history.peek())),
    go: (where) => void (history.value = moved(history.peek(), where)),
    open(source, panel = "guided") {
      const same = sameSource(source, doc.peek().source);
      if (same) return editing.go({ panel });
      edit({ source, pose: HOME, commands: [], tour: TOUR, panel, stage: null });
    },
    undo: () => void (history.value = undone(history.peek())),
    redo: () => void (history.value = redone(history.peek())),
  };
  keepInAddress(editing);
  addEventListener("pagehide", () => remember(UNDO, writeHistory(history.peek())));
  return editing;
}

/** The state of entries of the browser's history that the page has written itself. */
const OWN = "gcrules-studio";

/** Keeps the document in the address; another panel or structure is a place of its own, to which the browser's "back" leads. */
function keepInAddress({ doc, edit, go, panel$, making$, source$, unread }: Editing): void {
  let timer = 0;
  let written = location.hash;
  let kept: Doc | null = null; // what stands in the address

  const write = (fragment: string, how: "pushState" | "replaceState"): void => {
    written = fragment;
    history[how](OWN, "", fragment || location.pathname + location.search);
  };

  history.replaceState(OWN, "", location.href);
  let place = { panel: panel$.peek(), making: making$.peek(), source: source$.peek() };
  const moved = (now: typeof place): boolean => {
    const other = now.panel !== place.panel || now.making !== place.making || !sameSource(now.source, place.source);
    place = now;
    return other;
  };
  effect(() => {
    if (moved({ panel: panel$.value, making: making$.value, source: source$.value })) write(plainFragment(doc.peek()), "pushState");
  });
  let visits = 0;
  window.addEventListener("popstate", async ({ state }) => {
    if (state !== OWN) return;
    const visit = ++visits;
    written = location.hash;
    const found = await readFragment(written);
    if (!found || visit !== visits) return; // the browser is elsewhere by now
    place = found; // where the browser is already
    if (sameSource(found.source, doc.peek().source)) go({ panel: found.panel, making: found.making, ...(found.stage && { stage: found.stage }) });
    else edit(found);
  });
  effect(() => {
    const now = doc.value;
    window.clearTimeout(timer);
    timer = window.setTimeout(async () => {
      timer = 0;
      const fragment = await writeFragment(now);
      if (now !== doc.peek()) return;
      write(fragment, "replaceState");
      kept = now;
    }, PAUSE);
  });
  window.addEventListener("pagehide", () => {
    if (doc.peek() === kept) return;
    const fragment = plainFragment(doc.peek());
    write(fragment, "replaceState");
    leave(fragment); // a reload has read the address by now
  });
  window.addEventListener("hashchange", async () => {
    if (location.hash === written) return;
    const found = await readFragment(location.hash);
    unread.value = found === null;
    if (found) batch(() => edit(found));
  });
}
