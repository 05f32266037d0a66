// Making a robot: a platform on six legs is drawn, one with other limbs is built joint by joint.
import type { Making } from "../state/doc";
import { Tabs } from "../parts/tabs";
import { Draw } from "./draw";
import { LimbEditor } from "./limbs/limb-editor";
import type { PanelProps } from "./index";
import "./limbs/limbs.css";

export function Drawing({ store }: PanelProps) {
  const making = store.making$.value;
  return (
    <div class="making">
      <Tabs<Making>
        name="What is made"
        class="tabs making-tabs"
        controls="making"
        current={making}
        onChoose={(id) => store.go({ making: id })}
        tabs={[
          { id: "legs", label: "Six legs", title: "A platform on six legs, drawn in plan", testid: "making-legs" },
          { id: "limbs", label: "Limbs and joints", title: "Any parallel robot, joint by joint", testid: "making-limbs" },
        ]}
      />
      <div id="making" role="tabpanel" class="making-body">
        {making === "legs" ? <Draw store={store} /> : <LimbEditor store={store} />}
      </div>
    </div>
  );
}
