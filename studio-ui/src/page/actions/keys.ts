// Keys as the table of actions writes them: "f", "?", "Mod z", "Mod Shift z"; "Mod" is Ctrl, on a Mac ⌘.

type Pressed = Pick<KeyboardEvent, "key" | "ctrlKey" | "metaKey" | "shiftKey" | "altKey">;

const LETTER = /^\p{L}$/u;

/** Whether these keys are the ones pressed. For a sign such as "?" it does not matter how the keyboard makes it. */
export function isPressed(keys: string, event: Pressed): boolean {
  const parts = keys.split(" ");
  const key = parts.at(-1) ?? "";
  const shift = !LETTER.test(key) || event.shiftKey === parts.includes("Shift");
  const mod = (event.ctrlKey || event.metaKey) === parts.includes("Mod");
  return event.key.toLowerCase() === key.toLowerCase() && mod && shift && event.altKey === parts.includes("Alt");
}

/** One key without Ctrl, Alt or ⌘: it can be switched off, since speech input and slips of the hand press such keys. */
export const isSingle = (keys: string): boolean => keys.length === 1;

const MAC = typeof navigator !== "undefined" && /Mac|iP(hone|ad)/.test(navigator.userAgent);
const NAMES: Readonly<Record<string, string>> = {
  Mod: MAC ? "⌘" : "Ctrl",
  Escape: "Esc",
  ArrowUp: "↑",
  ArrowDown: "↓",
  Arrows: "← ↑ ↓ →",
  PageUp: "Page ↑",
  PageDown: "Page ↓",
};

/** The names of the keys, as they stand on the keyboard. */
export const namesOf = (keys: string): string[] =>
  keys.split(" ").map((key) => NAMES[key] ?? (LETTER.test(key) ? key.toUpperCase() : key));
