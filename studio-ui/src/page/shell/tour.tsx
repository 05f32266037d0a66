// The tour: a card beside the page, one stop after the other, and what it points at.
import { useEffect, useRef } from "preact/hooks";
import { useStore } from "../parts/context";
import { Icon } from "../parts/icon";
import { STOPS } from "../state/tour-stops";
import "./tour.css";

const MARK = "data-toured";
const OFTEN = 100; // milliseconds between two looks for a part of the page

export function TourCard() {
  const store = useStore();
  const { tour } = store.front;
  const at = tour.value;
  const stop = at === null ? undefined : STOPS[at];
  const next = useRef<HTMLButtonElement>(null);

  useEffect(() => {
    if (!stop) return undefined;
    const giveUp = stop.lead(store);
    next.current?.focus();
    const unmark = stop.at === null ? undefined : pointedAt(stop.at);
    return () => {
      giveUp?.();
      unmark?.();
    };
  }, [stop, store]);

  if (!stop || at === null) return null;
  const last = at === STOPS.length - 1;
  const go = (to: number | null): void => void (tour.value = to);
  return (
    <div
      class="tour"
      role="dialog"
      aria-labelledby="tour-title"
      data-testid="tour"
      onKeyDown={(event) => {
        if (event.key !== "Escape") return;
        event.stopPropagation();
        go(null);
      }}
    >
      <p class="count">
        {at + 1} of {STOPS.length}
      </p>
      <h2 id="tour-title">{stop.title}</h2>
      <p aria-live="polite">{stop.words}</p>
      <div class="buttons">
        <button type="button" onClick={() => go(at - 1)} disabled={at === 0} data-testid="tour-back">
          Back
        </button>
        <button ref={next} type="button" class="primary" onClick={() => (last ? (go(null), store.go({ panel: "start" })) : go(at + 1))} data-testid="tour-next">
          {last ? "To the start" : "Next"}
        </button>
        <button type="button" class="tool" aria-label="End the tour" title="End the tour (Esc)" onClick={() => go(null)} data-testid="tour-close">
          <Icon name="close" size={16} />
        </button>
      </div>
    </div>
  );
}

/** Marks a part of the page as soon as it is there, and again where it is drawn anew; the function that is returned takes the mark back. */
function pointedAt(testid: string): () => void {
  let marked: Element | null = null;
  function look(): void {
    const found = [...document.querySelectorAll(`[data-testid="${testid}"], section.${testid}`)].find((one) => one.getClientRects().length > 0);
    if (!found || found === marked) return;
    marked?.removeAttribute(MARK);
    marked = found;
    found.setAttribute(MARK, "");
    found.scrollIntoView({ block: "nearest" });
  }
  look();
  const timer = window.setInterval(look, OFTEN);
  return () => {
    window.clearInterval(timer);
    marked?.removeAttribute(MARK);
  };
}
