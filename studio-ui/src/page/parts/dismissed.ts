// A menu in a <details> closes with Escape, which leaves the focus on its button, and when something else is pressed.
import { useEffect, useRef } from "preact/hooks";

export function useDismissed() {
  const box = useRef<HTMLDetailsElement>(null);
  useEffect(() => {
    const press = (event: PointerEvent): void => {
      if (box.current?.open && !box.current.contains(event.target as Node)) box.current.open = false;
    };
    const key = (event: KeyboardEvent): void => {
      if (event.key !== "Escape" || !box.current?.open) return;
      box.current.open = false;
      box.current.querySelector("summary")?.focus();
    };
    addEventListener("pointerdown", press, true);
    addEventListener("keydown", key);
    return () => {
      removeEventListener("pointerdown", press, true);
      removeEventListener("keydown", key);
    };
  }, []);
  return box;
}
