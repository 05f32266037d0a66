// The document as a signal, its changes, undo and redo, and its copy in the address bar.
import { batch, computed, effect, signal, type ReadonlySignal, type Signal } from "@preact/signals";
import { EMPTY, HOME, TOUR, sameSource, type Doc, type PanelId } from "./doc";
import { leave, plainFragment, readFragment, writeFragment } from "./fragment";
import { begin, closed, moved, record, redone, undone, type History } from "./history";
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
  go(where: { panel?: PanelId; stage?: StageId }): void;
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
    tour$: computed(() => doc.value.tour),
    sketch$: computed(() => doc.value.sketch),
  };
}

const PAUSE = 300; // milliseconds of rest before the address bar is written

export function createEditing(start: Doc | null): Editing {
  const history = signal<History>(begin(start ?? EMPTY));
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
  return editing;
}

function keepInAddress({ doc, edit, unread }: Editing): void {
  let timer = 0;
  let written = location.hash;
  let kept: Doc | null = null; // what stands in the address

  const replace = (fragment: string): void => {
    written = fragment;
    history.replaceState(null, "", fragment || location.pathname + location.search);
  };
  effect(() => {
    const now = doc.value;
    window.clearTimeout(timer);
    timer = window.setTimeout(async () => {
      timer = 0;
      const fragment = await writeFragment(now);
      if (now !== doc.peek()) return;
      replace(fragment);
      kept = now;
    }, PAUSE);
  });
  window.addEventListener("pagehide", () => {
    if (doc.peek() === kept) return;
    const fragment = plainFragment(doc.peek());
    replace(fragment);
    leave(fragment); // a reload has read the address by now
  });
  window.addEventListener("hashchange", async () => {
    if (location.hash === written) return;
    const found = await readFragment(location.hash);
    unread.value = found === null;
    if (found) batch(() => edit(found));
  });
}
