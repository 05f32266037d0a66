// To the editor of limbs, with the robot that is open or with the one that is there.
import type { Source } from "../../protocol";
import type { Store } from "../state/store";
import { faultOf } from "../state/studying";
import type { Action } from "./table";

/** The robot of limbs and joints that is open, if it is one. */
export function limbsAtHand({ study, source$ }: Store): Source | null {
  const source = source$.value;
  return study.value?.robot && (source?.kind === "robot" || source?.kind === "file") ? source : null;
}

/** Takes the robot that is open into the editor; what was being built there is one step of undo away. */
export async function editLimbs(store: Store): Promise<void> {
  const start = limbsAtHand(store);
  if (!start) return;
  try {
    const { text } = await store.client.ask("limbs", { start });
    store.settle();
    if (text !== store.limbs$.peek()) store.edit({ limbs: text });
    store.go({ panel: "draw", making: "limbs" });
  } catch (error) {
    store.front.tell(faultOf(error).message);
  }
}

export const limbActions = (store: Store): Action[] => [
  {
    id: "build",
    title: "Build a robot, limb by limb",
    group: "Go to",
    words: "new joints draw make mechanism editor",
    act: () => store.go({ panel: "draw", making: "limbs" }),
  },
  {
    id: "edit-limbs",
    title: "Edit the limbs of this robot",
    group: "Go to",
    words: "joints change build",
    fits: () => limbsAtHand(store) !== null,
    act: () => void editLimbs(store),
  },
];
