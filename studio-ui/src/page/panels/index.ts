// The panels of the page, in the order of the rail. To add one:
//  1. Give it an id in PanelId (state/doc.ts) and in PANELS (state/read.ts), an icon in parts/icon.tsx.
//  2. Write a component that takes { store } and put it into the table below. "beside" stands left of the 3D pane,
//     "wide" takes its place too. A panel that `needs` a study is shown only when one is open.
//  3. Read the document with store.bench$.value (one signal for each field), change it with store.edit({ bench: text }, "bench"): changes in a row with the
//     same key are undone as one, store.settle() ends the row. store.study.value is the structure, store.posing.numbers
//     the numbers at the pose. Ask the server with store.client.ask("manual", { … }, { channel: "manual" }).
//  4. Elements marked data-point="a", data-leg="ab", data-bracket="a b c d" or data-entity="id" take part in the
//     highlighting of the whole page without more ado (parts/pointing.ts); store.lit holds what is lit.
//  5. In 3D: store.space.overlay.value = { planes, constructed, entities, ghost } adds to the picture,
//     store.space.mode.value = "pick" with store.space.onPick(take) hands over points picked in 3D and in the schematic.
//     Take both back when the component goes (the function that useEffect returns).
// Shared parts: Formula, MonomialTable, EntityChip, PointName, Prose, FaultBox, Schematic, Drawing, Tabs, NumberField, Icon.
import type { ComponentType } from "preact";
import type { PanelId } from "../state/doc";
import type { Store } from "../state/store";
import type { IconName } from "../parts/icon";
import { Bench } from "./bench";
import { Dimensions } from "./dimensions";
import { Drawing } from "./drawing";
import { Guided } from "./guided";
import { ManualPanel } from "./manual";
import { Motion } from "./motion";
import { ProjectPanel } from "./project";
import { Start } from "./start";
import { TakeAway } from "./take-away";
import { Where } from "./where";

export interface PanelProps {
  store: Store;
}

export interface Panel {
  id: PanelId;
  title: string;
  /** With a soft hyphen where the word may be parted in the rail. */
  written?: string;
  icon: IconName;
  component: ComponentType<PanelProps>;
  layout: "beside" | "wide";
  needs: "study" | "nothing";
  /** Whether it is of use where the page answers by itself, without numbers. */
  alone?: true;
}

export const panels: readonly Panel[] = [
  { id: "start", title: "Start", icon: "start", component: Start, layout: "wide", needs: "nothing", alone: true },
  { id: "guided", title: "Steps", icon: "guided", component: Guided, layout: "beside", needs: "study", alone: true },
  { id: "manual", title: "By hand", icon: "manual", component: ManualPanel, layout: "beside", needs: "study" },
  { id: "motion", title: "Path, map", icon: "map", component: Motion, layout: "beside", needs: "study" },
  { id: "where", title: "Where to", icon: "where", component: Where, layout: "beside", needs: "study" },
  { id: "dimensions", title: "Dimensions", written: "Dimen\u00adsions", icon: "dimensions", component: Dimensions, layout: "beside", needs: "study" },
  { id: "bench", title: "Bench", icon: "bench", component: Bench, layout: "beside", needs: "nothing", alone: true },
  { id: "draw", title: "Draw", icon: "draw", component: Drawing, layout: "wide", needs: "nothing" },
  { id: "take-away", title: "Take away", icon: "take-away", component: TakeAway, layout: "beside", needs: "study" },
  { id: "project", title: "Project", icon: "project", component: ProjectPanel, layout: "wide", needs: "nothing" },
];

/** Those of this page. */
export const panelsOf = ({ client }: Store): readonly Panel[] => panels.filter(({ alone }) => alone || !client.alone);
