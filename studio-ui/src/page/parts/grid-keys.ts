// Arrow keys within a grid of buttons, of which one takes part in the order of the tab key.
const STEPS: Record<string, [number, number]> = {
  ArrowLeft: [0, -1],
  ArrowRight: [0, 1],
  ArrowUp: [-1, 0],
  ArrowDown: [1, 0],
};

export function moveInGrid(event: KeyboardEvent & { currentTarget: HTMLElement }): void {
  const step = STEPS[event.key];
  const here = document.activeElement;
  if (!step || !(here instanceof HTMLElement)) return;
  const rows = [...event.currentTarget.querySelectorAll<HTMLElement>("[role=row]")].map((row) => [
    ...row.querySelectorAll<HTMLElement>("button"),
  ]);
  const r = rows.findIndex((row) => row.includes(here));
  if (r < 0) return;
  const c = rows[r]?.indexOf(here) ?? 0;
  const row = rows[Math.min(Math.max(r + step[0], 0), rows.length - 1)];
  const next = row?.[Math.min(Math.max(c + step[1], 0), row.length - 1)];
  if (!next) return;
  event.preventDefault();
  focusOnly(rows.flat(), next);
}

/** Focus goes to one of these, which alone stays in the order of the tab key. */
function focusOnly(all: readonly HTMLElement[], next: HTMLElement): void {
  all.forEach((other) => (other.tabIndex = other === next ? 0 : -1));
  next.focus();
}
