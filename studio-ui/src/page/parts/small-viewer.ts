// A viewer in a box of its own, for a robot that is not the one of the study; it goes with the component.
import type { RefObject } from "preact";
import { useEffect, useRef } from "preact/hooks";
import { createViewer, type Viewer } from "../../viewer";
import { useStore } from "./context";

export function useSmallViewer(): { box: RefObject<HTMLDivElement | null>; viewer: { readonly current: Viewer | null } } {
  const { taste } = useStore();
  const box = useRef<HTMLDivElement>(null);
  const viewer = useRef<Viewer | null>(null);
  const theme = taste.theme.value;
  useEffect(() => {
    if (!box.current) return undefined;
    const made = createViewer(box.current, { gizmo: false, theme: taste.theme.peek() });
    viewer.current = made;
    return () => {
      viewer.current = null;
      made.dispose();
    };
  }, [taste]);
  useEffect(() => viewer.current?.setTheme(theme), [theme]);
  return { box, viewer };
}
