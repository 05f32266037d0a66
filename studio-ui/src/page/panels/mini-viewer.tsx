// A small picture of a robot that is not the one of the study: a drawing under way, a counterexample.
import { useEffect, useRef } from "preact/hooks";
import { createViewer, type Scene, type Viewer } from "../../viewer";
import { useStore } from "../parts/context";

interface Props {
  scene: Scene;
  label: string;
  testid: string;
}

export function MiniViewer({ scene, label, testid }: Props) {
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
  useEffect(() => viewer.current?.show(scene), [scene]);
  useEffect(() => viewer.current?.setTheme(theme), [theme]);
  return <div class="mini-viewer" ref={box} role="group" aria-label={label} data-testid={testid} />;
}
