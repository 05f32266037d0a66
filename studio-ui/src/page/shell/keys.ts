// Keys of the whole page. Text fields and the editor keep their own undo.
import { useEffect } from "preact/hooks";
import type { Store } from "../state/store";

export function useKeys(store: Store): void {
  useEffect(() => {
    const press = (event: KeyboardEvent): void => {
      if (event.altKey || writes(event.target)) return;
      const key = event.key.toLowerCase();
      if (!(event.ctrlKey || event.metaKey)) return enlarge(store, key);
      const act = key === "z" ? (event.shiftKey ? store.redo : store.undo) : key === "y" ? store.redo : null;
      if (!act) return;
      event.preventDefault();
      store.moving.stop();
      act();
    };
    addEventListener("keydown", press);
    return () => removeEventListener("keydown", press);
  }, [store]);
}

/** F shows the picture alone, Escape the page again. */
function enlarge({ space, study }: Store, key: string): void {
  if (key === "f" && study.peek() && space.viewer.peek()) space.large.value = !space.large.peek();
  if (key === "escape") space.large.value = false;
}

function writes(target: EventTarget | null): boolean {
  if (!(target instanceof HTMLElement)) return false;
  if (target.isContentEditable || target instanceof HTMLTextAreaElement) return true;
  return target instanceof HTMLInputElement && !["range", "checkbox", "radio", "button"].includes(target.type);
}
