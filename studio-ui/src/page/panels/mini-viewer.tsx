// A small picture of a robot that is not the one of the study: a drawing under way, a counterexample.
import { useEffect } from "preact/hooks";
import type { Scene } from "../../viewer";
import { useSmallViewer } from "../parts/small-viewer";

interface Props {
  scene: Scene;
  label: string;
  testid: string;
}

export function MiniViewer({ scene, label, testid }: Props) {
  const { box, viewer } = useSmallViewer();
  useEffect(() => viewer.current?.show(scene), [scene]);
  return <div class="mini-viewer" ref={box} role="group" aria-label={label} data-testid={testid} />;
}
