// What lies over the page for a moment: the list of commands, that of keys, and a short notice.
import { signal, type ReadonlySignal, type Signal } from "@preact/signals";

export interface Front {
  dialog: Signal<"palette" | "keys" | "repeat" | "glossary" | null>;
  /** The word whose meaning is shown; `pinned` until it is put away. */
  term: Signal<{ name: string; word: HTMLElement; pinned: boolean } | null>;
  /** Whether the guide lies beside the page. */
  guide: Signal<boolean>;
  /** The term that the glossary was opened for. */
  wanted: ReadonlySignal<string | null>;
  glossary(wanted?: string): void;
  /** The stop of the tour, counted from 0; null where none is on. */
  tour: Signal<number | null>;
  notice: ReadonlySignal<string>;
  /** Says what has been done, where nothing else on the page shows it. */
  tell(words: string): void;
}

const LASTS = 2600; // milliseconds that a notice stays

export function createFront(): Front {
  const notice = signal("");
  const dialog: Front["dialog"] = signal(null);
  const term: Front["term"] = signal(null);
  const wanted = signal<string | null>(null);
  let timer = 0;
  return {
    dialog,
    term,
    guide: signal(false),
    wanted,
    tour: signal(null),
    glossary(one) {
      wanted.value = one ?? null;
      term.value = null;
      dialog.value = "glossary";
    },
    notice,
    tell(words) {
      notice.value = words;
      window.clearTimeout(timer);
      timer = window.setTimeout(() => (notice.value = ""), LASTS);
    },
  };
}
