// An answer that comes below the fold is brought into sight, with the question above it as far as there is room.
import { useEffect, useRef } from "preact/hooks";

/** For the element of a question with its answer: scrolled to once there is an answer where there was none. */
export function useSight(answered: boolean) {
  const element = useRef<HTMLElement>(null);
  const before = useRef(answered);
  useEffect(() => {
    const came = answered && !before.current;
    before.current = answered;
    const found = element.current;
    if (!came || !found || found.getBoundingClientRect().bottom <= innerHeight) return;
    const calm = matchMedia("(prefers-reduced-motion: reduce)").matches;
    found.scrollIntoView({ block: "start", behavior: calm ? "auto" : "smooth" });
  }, [answered]);
  return element;
}
