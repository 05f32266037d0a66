// Where the platform is, how close to a singularity that is, whether one lay on the way, and where the nearest one lies.
import { useState } from "preact/hooks";
import { useStore } from "../parts/context";
import { Tabs } from "../parts/tabs";
import { ActuatorsTable } from "./actuators-table";
import { ModeView } from "./mode-view";
import { NearestView } from "./nearest-view";
import { ReadingsTable } from "./readings-table";
import { SearchView } from "./search-view";
import { Sliders } from "./sliders";
import { VerdictView } from "./verdict-view";
import { Timeline } from "./timeline";

const TABS = [
  { id: "way", label: "Along the way", testid: "tab-way" },
  { id: "readings", label: "Readings", testid: "tab-readings" },
  { id: "actuators", label: "Actuators", testid: "tab-actuators" },
] as const;
type Tab = (typeof TABS)[number]["id"];

export function PosePanel() {
  const { study } = useStore();
  const [tab, choose] = useState<Tab>("way");
  const shown = study.value;
  if (!shown) return null;
  return (
    <div class="pose-panel">
      <VerdictView />
      {shown.axes.length > 0 && <Sliders study={shown} />}
      <section class="tabbed">
        <Tabs<Tab> name="Numbers" tabs={TABS} current={tab} onChoose={choose} />
        {tab === "way" ? <Timeline /> : tab === "readings" ? <ReadingsTable /> : <ActuatorsTable />}
      </section>
      {shown.kind === "platform" && shown.axes.length > 0 && <NearestView />}
      {shown.kind === "robot" && shown.axes.length > 0 && <SearchView />}
      {shown.kind === "robot" && shown.axes.length > 0 && <ModeView />}
    </div>
  );
}
