// The robot at home in 3D; the camera stays while the robot is changed.
import { useEffect, useMemo, useRef } from "preact/hooks";
import type { LimbsAnswer, Study } from "../../../protocol";
import type { Scene } from "../../../viewer";
import { useSmallViewer } from "../../parts/small-viewer";

interface Props {
  answer: LimbsAnswer | null;
  /** The analysis of this very robot, whose entities are drawn too. */
  study: Study | null;
  /** Points that are pointed at in the table. */
  lit: readonly string[];
}

export function Picture({ answer, study, lit }: Props) {
  const { box, viewer } = useSmallViewer();
  const shown = useRef("");
  const scene = useMemo((): Scene | null => (answer?.scene ? { ...answer.scene, entities: study?.entities ?? [] } : null), [answer, study]);

  useEffect(() => {
    if (!scene || !viewer.current) return;
    const names = JSON.stringify([Object.keys(scene.points), scene.base, scene.platform, scene.unit, scene.entities.map(({ id }) => id), scene.limbs?.map(({ joints }) => joints.map(({ kind }) => kind))]);
    if (names === shown.current) {
      viewer.current.update({ points: scene.points, limbs: scene.limbs, skeleton: scene.skeleton, directions: scene.directions });
    } else viewer.current.show(scene);
    shown.current = names;
  }, [scene]);
  useEffect(() => {
    const points = lit.filter((name) => scene && name in scene.points);
    viewer.current?.highlight(points.length > 0 ? { points } : null);
  }, [lit, scene]);

  return (
    <div class={answer && !scene ? "limb-picture old" : "limb-picture"}>
      <div class="mini-viewer" ref={box} role="group" aria-label="The robot at home in 3D" data-testid="limb-viewer" />
      {answer && !scene && <p class="no-picture">{shown.current ? "This is the last robot that could be drawn." : "No picture yet: home gives no coordinates."}</p>}
    </div>
  );
}
