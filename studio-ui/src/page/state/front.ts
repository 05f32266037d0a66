// What lies over the page for a moment: the list of commands, that of keys, and a short notice.
import { signal, type ReadonlySignal, type Signal } from "@preact/signals";

export interface Front {
  dialog: Signal<"palette" | "keys" | "repeat" | null>;
  notice: ReadonlySignal<string>;
  /** Says what has been done, where nothing else on the page shows it. */
  tell(words: string): void;
}

const LASTS = 2600; // milliseconds that a notice stays

export function createFront(): Front {
  const notice = signal("");
  let timer = 0;
  return {
    dialog: signal(null),
    notice,
    tell(words) {
      notice.value = words;
      window.clearTimeout(timer);
      timer = window.setTimeout(() => (notice.value = ""), LASTS);
    },
  };
}
