// The meaning of a word of the page, beside the word: while it is pointed at or has the focus, and after a press until it is put away.
import { useEffect, useLayoutEffect, useRef } from "preact/hooks";
import { entryOf } from "../lib/terms";
import { useStore } from "../parts/context";
import { GuideLink } from "../parts/guide-link";
import type { Front } from "../state/front";

const [SOON, AWHILE] = [250, 200]; // milliseconds before it comes, and before it goes when the mouse has left
const GAP = 8; // pixels from the word, and from the edge of the window

export function TermTip() {
  const { front } = useStore();
  const box = useRef<HTMLDivElement>(null);
  const shown = front.term.value;
  const entry = shown && entryOf(shown.name);
  useEffect(() => listen(front), [front]);
  useLayoutEffect(() => {
    if (box.current && shown) place(box.current, shown.word.getBoundingClientRect());
  }, [shown]);
  if (!entry) return null;
  return (
    <div ref={box} id="term-tip" class="term-tip" role="tooltip" data-testid="term-tip">
      <p>
        <b>{entry.term.charAt(0).toUpperCase() + entry.term.slice(1)}</b>. {entry.meaning}
      </p>
      <p class="guide">
        <GuideLink entry={entry} />
        <button type="button" class="quiet" onClick={() => front.glossary(entry.term)} data-testid="term-more">
          In the glossary
        </button>
      </p>
    </div>
  );
}

function place(box: HTMLElement, word: DOMRect): void {
  const { width, height } = box.getBoundingClientRect();
  const below = word.bottom + GAP;
  const top = below + height > innerHeight - GAP ? Math.max(GAP, word.top - GAP - height) : below;
  const left = Math.min(Math.max(GAP, word.left + word.width / 2 - width / 2), innerWidth - GAP - width);
  box.style.transform = `translate(${Math.round(left)}px, ${Math.round(top)}px)`;
}

/** Hears of all words of the page at once; returns how to stop. */
function listen({ term }: Front): () => void {
  let timer = 0;
  const later = (act: () => void, wait: number): void => {
    window.clearTimeout(timer);
    timer = window.setTimeout(act, wait);
  };
  const near = (event: Event, selector: string): HTMLElement | null =>
    event.target instanceof Element ? event.target.closest<HTMLElement>(selector) : null;
  const show = (word: HTMLElement, pinned: boolean): void => {
    window.clearTimeout(timer);
    term.value = { name: word.dataset.term ?? "", word, pinned };
  };
  const hide = (): void => void (term.value = null);

  const over = (event: PointerEvent): void => {
    if (event.pointerType !== "mouse" || term.peek()?.pinned) return;
    const word = near(event, "[data-term]");
    if (word) later(() => show(word, false), SOON);
    else if (near(event, "#term-tip")) window.clearTimeout(timer);
    else if (term.peek()) later(hide, AWHILE);
    else window.clearTimeout(timer);
  };
  const focus = (event: FocusEvent): void => {
    const word = near(event, "[data-term]");
    if (word?.matches(":focus-visible")) show(word, false);
    else if (!near(event, "#term-tip")) hide();
  };
  const press = (event: MouseEvent): void => {
    const word = near(event, "[data-term]");
    if (word) return term.peek()?.pinned && term.peek()?.word === word ? hide() : show(word, true);
    if (!near(event, "#term-tip")) hide();
  };
  const scrolled = (event: Event): void => {
    if (event.target instanceof Node && term.peek() && event.target.contains(term.peek()?.word ?? null)) hide();
  };

  const events: [string, (event: never) => void][] = [
    ["pointerover", over],
    ["focusin", focus],
    ["click", press],
    ["scroll", scrolled],
  ];
  events.forEach(([name, act]) => document.addEventListener(name, act as EventListener, true));
  return () => events.forEach(([name, act]) => document.removeEventListener(name, act as EventListener, true));
}
