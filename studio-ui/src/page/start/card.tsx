// A structure of the gallery. Its drawing is made when the card comes into view.
import { useEffect, useRef, useState } from "preact/hooks";
import type { GalleryItem } from "../../protocol";
import { useStore } from "../parts/context";
import { Drawing } from "../parts/drawing";
import { sameSource } from "../state/doc";

export function Card({ item }: { item: GalleryItem }) {
  const { open, source$ } = useStore();
  const card = useRef<HTMLLIElement>(null);
  const seen = useSeen(card);
  const current = sameSource(source$.value, item.source);
  return (
    <li ref={card}>
      <button
        type="button"
        class={current ? "card current" : "card"}
        data-testid={`card-${item.source.kind}-${item.id}`}
        onClick={() => open(item.source)}
      >
        <span class="picture" aria-hidden="true">
          {seen && <Drawing svg={item.svg} />}
        </span>
        <span class="title">{item.title}</span>
        <span class="detail">{item.detail}</span>
        {item.statement && <span class="statement">{item.statement}</span>}
      </button>
    </li>
  );
}

function useSeen(element: { current: HTMLElement | null }): boolean {
  const [seen, see] = useState(false);
  useEffect(() => {
    if (!element.current) return;
    const watch = new IntersectionObserver(
      (entries) => {
        if (!entries.some(({ isIntersecting }) => isIntersecting)) return;
        see(true);
        watch.disconnect();
      },
      { rootMargin: "400px" },
    );
    watch.observe(element.current);
    return () => watch.disconnect();
  }, []);
  return seen;
}
