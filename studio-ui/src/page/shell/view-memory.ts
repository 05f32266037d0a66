// Where one looks from, kept over a reload of the page.
import type { Source } from "../../protocol";
import type { Stand, Viewer } from "../../viewer";
import { sameSource } from "../state/doc";
import { isReload, recalled, remember } from "../state/tab-memory";

const KEY = "gcrules-view";

interface Kept extends Stand {
  source: Source;
}

/** `restore` takes up the view of the page before, if that showed the same source; once, when the first robot is shown. */
export function viewMemory(viewer: Viewer, source: () => Source | null): { restore(): void; stop(): void } {
  let kept = isReload() ? read(recalled(KEY)) : null;
  const leave = (): void => {
    const now = source();
    remember(KEY, now && JSON.stringify({ source: now, ...viewer.stand }));
  };
  addEventListener("pagehide", leave);
  return {
    restore() {
      const now = source();
      if (kept && now && sameSource(kept.source, now)) viewer.setStand({ eye: kept.eye, target: kept.target });
      kept = null;
    },
    stop: () => removeEventListener("pagehide", leave),
  };
}

function read(text: string | null): Kept | null {
  try {
    return text === null ? null : (JSON.parse(text) as Kept);
  } catch {
    return null;
  }
}
