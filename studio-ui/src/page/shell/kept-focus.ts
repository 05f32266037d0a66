// Where the focus goes when what has it is taken away, or cannot be used any more: to what stands beside it, never to the
// page as a whole.

const FOCUSABLE = "a[href], button, summary, input, select, textarea, [tabindex='0'], [contenteditable=true]";
const WRITES = "input:not([type=range], [type=checkbox], [type=radio]), select, textarea, [contenteditable=true]";
const MOST = 20; // elements that are remembered
const SHOWN = { visibilityProperty: true };

const usable = (one: HTMLElement): boolean => one.isConnected && !one.matches(":disabled") && one.closest("[inert]") === null && one.checkVisibility(SHOWN);

/** Between what something stood; null at an end. */
interface Place {
  before: Node | null;
  next: Node | null;
}

const follows = (one: HTMLElement, node: Node): boolean => !node.contains(one) && (node.compareDocumentPosition(one) & Node.DOCUMENT_POSITION_FOLLOWING) !== 0;

/** Watches the page; `content` is what holds the panel. A finger needs no focus: with it, fields would call the keyboard. */
export function keepFocus(root: HTMLElement, content: () => HTMLElement | null): () => void {
  let held: HTMLElement | null = null;
  let around: HTMLElement[] = []; // what it stands in, from the inside out
  let recent: WeakRef<HTMLElement>[] = []; // what had the focus, the latest first
  let touched = false;
  let waits = 0;
  const taken = new Map<Node, Place>(); // what was taken away of them, and from where

  const lost = (): boolean => document.activeElement === null || document.activeElement === document.body || document.activeElement === held;

  function hold(event: FocusEvent): void {
    if (!(event.target instanceof HTMLElement) || event.target === held) return;
    held = event.target;
    around = [];
    taken.clear();
    for (let one = held.parentElement; one && one !== root.parentElement; one = one.parentElement) around.push(one);
    recent = [new WeakRef(held), ...recent.filter((one) => one.deref() !== held)].slice(0, MOST);
  }

  function forget(): void {
    held = null;
    around = [];
    taken.clear();
  }

  function look(): void {
    waits = 0;
    if (!held || !lost()) return;
    const [gone, chain, places] = [held, around, new Map(taken)];
    if (usable(gone)) {
      if (document.activeElement !== gone) forget(); // it was left
      return;
    }
    forget();
    if (!touched) instead(gone, chain, places)?.focus({ preventScroll: true });
  }

  function instead(gone: HTMLElement, chain: readonly HTMLElement[], places: ReadonlyMap<Node, Place>): HTMLElement | null {
    const main = content();
    let inner: HTMLElement = gone;
    for (const one of chain) {
      if (one.isConnected) {
        if (one === main) return main;
        if (one === root) break;
        const found = beside(inner.isConnected ? { before: inner, next: null } : places.get(inner), one);
        if (found) return found;
      }
      inner = one;
    }
    const before = recent.map((one) => one.deref()).find((one) => one && usable(one));
    return before ?? main;
  }

  /** In `one`: what had the focus last, what has taken the place or follows it, or what comes before it; a field if there is nothing else. */
  function beside(place: Place | undefined, one: HTMLElement): HTMLElement | null {
    const all = [...one.querySelectorAll<HTMLElement>(FOCUSABLE)].filter((other) => other.tabIndex >= 0 && usable(other));
    const plain = all.filter((other) => !other.matches(WRITES));
    const found = plain.length > 0 ? plain : all;
    const last = recent.map((other) => other.deref()).find((other) => other && found.includes(other));
    if (last || !place) return last ?? found.at(-1) ?? null;
    const { before, next } = place;
    const after = before?.isConnected
      ? found.find((other) => follows(other, before))
      : next?.isConnected
        ? found.find((other) => next.contains(other) || follows(other, next))
        : found[0];
    return after ?? found.at(-1) ?? null;
  }

  function changed(records: readonly MutationRecord[]): void {
    if (!held) return;
    let hides = false;
    for (const { type, target, removedNodes, previousSibling, nextSibling } of records) {
      if (type === "attributes") hides ||= target.contains(held);
      else
        for (const node of removedNodes)
          if (node === held || around.includes(node as HTMLElement)) taken.set(node, { before: previousSibling, next: nextSibling });
    }
    if (hides || !held.isConnected) wait();
  }

  const wait = (): void => void (waits ||= window.setTimeout(look));
  const point = ({ pointerType }: PointerEvent): void => void (touched = pointerType === "touch");
  const press = (): void => void (touched = false);

  const watching = new MutationObserver(changed);
  watching.observe(root, { childList: true, subtree: true, attributes: true, attributeFilter: ["disabled", "hidden", "open", "inert"] });
  root.addEventListener("focusin", hold);
  root.addEventListener("focusout", wait);
  addEventListener("pointerdown", point, true);
  addEventListener("keydown", press, true);
  return () => {
    window.clearTimeout(waits);
    watching.disconnect();
    root.removeEventListener("focusin", hold);
    root.removeEventListener("focusout", wait);
    removeEventListener("pointerdown", point, true);
    removeEventListener("keydown", press, true);
  };
}
