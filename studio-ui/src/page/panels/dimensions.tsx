// The dimensions of the robot on show, and another robot beside it.
import { useEffect } from "preact/hooks";
import { editLimbs, limbsAtHand } from "../actions/limbs";
import { FaultBox } from "../parts/fault-box";
import { Comparison } from "./dimensions/comparison";
import { Coordinates } from "./dimensions/coordinates";
import { Limits } from "./dimensions/limits";
import { Plan } from "./dimensions/plan";
import type { PanelProps } from "./index";
import "./dimensions/dimensions.css";

export function Dimensions({ store }: PanelProps) {
  const { resizing } = store;
  const selected = resizing.selected.value;
  const select = (name: string | null): void => void (resizing.selected.value = name);
  const study = store.study.value;
  useEffect(() => () => (store.settle(), select(null)), [store]);
  if (!study) return null;
  return (
    <div class="dimensions">
      <header>
        <h2>Dimensions</h2>
        <p class="why">{study.robot ? "What is changed is seen beside what was." : "The condition depends on how the legs are joined, not on their places: it stays. The margin, the map and what is proved follow. Drag a joint in the picture or in the plan, or type its place."}</p>
      </header>
      {study.robot ? (
        <section aria-label="Joints">
          <p class="why">This robot is described by its joints: their kinds, directions and places at home are a table of its own.</p>
          {limbsAtHand(store) && (
            <button type="button" data-testid="shape-limbs" onClick={() => void editLimbs(store)}>
              Change its limbs and their places
            </button>
          )}
        </section>
      ) : (
        <section aria-label="Places of the joints">
          {study.invented && <p class="tip">The shape was invented. What is changed here makes it yours.</p>}
          <Plan study={study} selected={selected} select={select} />
          <Coordinates study={study} selected={selected} select={select} />
          <Limits />
          {resizing.fault.value && <FaultBox fault={resizing.fault.value} />}
        </section>
      )}
      <Comparison study={study} />
    </div>
  );
}
