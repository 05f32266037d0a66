// Keys of the whole page, as the table of actions has them. Text fields and the editor keep their own.
import { useEffect } from "preact/hooks";
import { isPressed, isSingle } from "../actions/keys";
import { actionsOf, canBeDone } from "../actions/table";
import type { Store } from "../state/store";

export function useKeys(store: Store): void {
  useEffect(() => {
    const press = (event: KeyboardEvent): void => {
      if (event.defaultPrevented || store.front.dialog.peek()) return;
      const found = actionsOf(store).find(
        (action) =>
          action.keys?.some((keys) => isPressed(keys, event) && (action.everywhere || reaches(store, keys, event.target))) &&
          canBeDone(action),
      );
      if (!found) return;
      event.preventDefault();
      found.act();
    };
    addEventListener("keydown", press);
    return () => removeEventListener("keydown", press);
  }, [store]);
}

/** Whether keys are meant for the page rather than for what has the focus. */
function reaches({ taste }: Store, keys: string, target: EventTarget | null): boolean {
  if (writes(target)) return !isSingle(keys) && isUntouched(target);
  return !isSingle(keys) || (taste.single.peek() && !(target instanceof HTMLSelectElement));
}

/** Of a field of a table: as long as nothing has been typed, undo is that of the page. */
const isUntouched = (target: EventTarget | null): boolean => target instanceof HTMLElement && target.dataset.untouched === "true";

function writes(target: EventTarget | null): boolean {
  if (!(target instanceof HTMLElement)) return false;
  if (target.isContentEditable || target instanceof HTMLTextAreaElement) return true;
  return target instanceof HTMLInputElement && !["range", "checkbox", "radio", "button"].includes(target.type);
}
