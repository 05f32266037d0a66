// The dimensions of the robot on show, and another robot beside it.
import { useEffect } from "preact/hooks";
import { editLimbs, limbsAtHand } from "../actions/limbs";
import { FaultBox } from "../parts/fault-box";
import { atHome, isHome } from "../state/doc";
import { Comparison } from "./dimensions/comparison";
import { Coordinates } from "./dimensions/coordinates";
import { Limits } from "./dimensions/limits";
import { Plan } from "./dimensions/plan";
import type { PanelProps } from "./index";
import "./dimensions/dimensions.css";

const WHY = {
  platform:
    "The condition depends on how the legs are joined, not on their places: it stays. The margin, the map and what is proved follow. Drag a joint in the picture or in the plan, or type its place.",
  robot:
    "Joints and how they are arranged stay, and with them the condition. The margin, the map and what is proved follow. Drag a joint in the picture or in the plan, or type its place; it goes where its relations let it.",
};

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
        <p class="why">{WHY[study.kind]}</p>
      </header>
      <section aria-label="Places of the joints">
        {study.invented && <p class="tip">The shape was invented. What is changed here makes it yours.</p>}
        {study.kind === "robot" && !isHome(store.pose$.value) && (
          <p class="tip">
            The dimensions are those at home.{" "}
            <button type="button" data-testid="shape-home" onClick={() => (store.edit({ pose: atHome(store.pose$.peek()) }), store.settle())}>
              Go home
            </button>{" "}
            to drag joints in the picture.
          </p>
        )}
        <Plan study={study} selected={selected} select={select} />
        <Coordinates study={study} selected={selected} select={select} />
        <Limits />
        {resizing.fault.value && <FaultBox fault={resizing.fault.value} />}
        {limbsAtHand(store) && (
          <button type="button" data-testid="shape-limbs" onClick={() => void editLimbs(store)}>
            Change its joints and relations
          </button>
        )}
      </section>
      <Comparison study={study} />
    </div>
  );
}
