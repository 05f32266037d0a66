// Pointing, for the whole page at once: parts only mark their elements with data-point="a", data-leg="ab",
// data-bracket="a b c d" or data-entity="plane-1"; hovering or focusing such an element lights its target up, a click pins it.
import type { Entity, Study } from "../../protocol";
import { bracketTarget, entityTarget, legTarget, pointTarget, type Target } from "../state/lit";
import type { Store } from "../state/store";

const MARKED = "[data-point],[data-leg],[data-bracket],[data-entity]";

type Marks = Partial<Record<"point" | "leg" | "bracket" | "entity", string>>;

function targetOf(marks: Marks, study: Study | null, entities: readonly Entity[]): Target | null {
  const { point, leg, bracket, entity } = marks;
  if (entity !== undefined) {
    const found = entities.find(({ id }) => id === entity);
    return found ? entityTarget(found) : null;
  }
  if (bracket !== undefined) {
    const points = bracket.split(" ");
    const same = entities.find((e) => samePoints(e.points, points));
    return same ? entityTarget(same) : bracketTarget(points);
  }
  if (leg !== undefined) {
    const found = study?.legs.find((pair) => pair.join("") === leg || pair.join(" ") === leg);
    return found ? legTarget(found) : null;
  }
  return point === undefined ? null : pointTarget(point);
}

export const samePoints = (a: readonly string[], b: readonly string[]): boolean =>
  a.length === b.length && a.every((point) => b.includes(point));

/** Listens on the page; returns how to stop. */
export function listen(root: HTMLElement, store: Store): () => void {
  const marked = (event: Event): Element | null =>
    event.target instanceof Element ? event.target.closest(MARKED) : null;

  const target = (element: Element | null): Target | null => {
    if (!(element instanceof HTMLElement || element instanceof SVGElement)) return null;
    const extra = store.space.overlay.peek()?.entities ?? [];
    const study = store.study.peek();
    return targetOf({ ...element.dataset }, study, [...extra, ...(study?.entities ?? [])]);
  };

  const hover = (event: Event): void => store.lit.hover(target(marked(event)));
  const leave = (): void => store.lit.hover(null);
  const click = (event: Event): void => {
    const element = marked(event);
    const found = target(element);
    if (!found) return;
    const [name] = found.points;
    if (found.kind === "point" && name && store.space.pick(name)) return;
    store.lit.pin(found);
  };

  const events: [string, (event: never) => void][] = [
    ["pointerover", hover],
    ["pointerleave", leave],
    ["focusin", hover],
    ["focusout", leave],
    ["click", click],
  ];
  events.forEach(([name, act]) => root.addEventListener(name, act as EventListener));
  return () => events.forEach(([name, act]) => root.removeEventListener(name, act as EventListener));
}
