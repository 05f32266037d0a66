// Building a robot joint by joint: a table of its limbs and the text of its file are two views of one thing; beside
// them the robot, its mobility, its wrenches and its condition as they are by now.
import { useEffect, useMemo, useState } from "preact/hooks";
import type { LimbSheet, SheetEdit } from "../../../protocol";
import { download } from "../../lib/download";
import { FaultBox } from "../../parts/fault-box";
import { Tabs } from "../../parts/tabs";
import type { PanelProps } from "../index";
import { AddLimb } from "./add-limb";
import { createBuilding, fileName } from "./editing";
import { TextField } from "./fields";
import { FileText } from "./file-text";
import { LimbCard } from "./limb-card";
import { NamesTable } from "./names-table";
import { Outcome } from "./outcome";
import { Picture } from "./picture";
import { StartFrom } from "./start-from";

type View = "table" | "text";

export function LimbEditor({ store }: PanelProps) {
  const building = useMemo(() => createBuilding(store), [store]);
  useEffect(() => building.dispose, [building]);
  const [view, show] = useState<View>("table");
  const [wish, setFollow] = useState<boolean | null>(null);
  const [lit, light] = useState<readonly string[]>([]);
  const answer = building.answer.value;
  const known = building.known.value;
  const refused = building.refused.value;
  const sheet = answer?.sheet ?? null;
  const follow = wish ?? sheet?.turned ?? false;
  const change = (edit: SheetEdit, key?: string): void => void building.change(edit, key);

  function open(): void {
    store.open(building.source());
  }
  function save(): void {
    const name = fileName(sheet?.title ?? "robot");
    download({ name, blob: new Blob([building.text.peek()], { type: "application/yaml" }) });
  }
  return (
    <div class="limbs-editor">
      <div class="limbs-main">
        <div class="limbs-bar">
          <TextField value={sheet?.title ?? ""} label="Title of the robot" class="title" testid="limbs-title" placeholder="Title" onTake={(text) => change({ do: "title", text })} />
          <StartFrom store={store} building={building} begun={() => setFollow(null)} />
        </div>
        <Tabs<View>
          name="Views of the robot"
          current={view}
          onChoose={show}
          controls="limbs-view"
          tabs={[
            { id: "table", label: "Table", testid: "limbs-table" },
            { id: "text", label: "File as text", testid: "limbs-text" },
          ]}
        />
        {refused && (
          <div class="refused">
            <FaultBox fault={refused.fault} />
          </div>
        )}
        <div id="limbs-view" role="tabpanel" class="limbs-view" onFocusIn={(event) => light(pointsAt(event.target))} onMouseOver={(event) => light(pointsAt(event.target))} onMouseLeave={() => light(NONE)}>
          {view === "text" && <FileText text$={building.text} fault={answer?.every ?? null} onText={(text) => building.write(text, "limbs")} />}
          {view === "text" && answer?.every && <FaultBox fault={answer.every} text={answer.text} />}
          {view === "table" && answer && !sheet && (
            <div class="unread">
              <p>The text of the file cannot be shown as a table:</p>
              {answer.every && <FaultBox fault={answer.every} text={answer.text} />}
              <button type="button" onClick={() => show("text")}>
                Go to the text
              </button>
            </div>
          )}
          {view === "table" && sheet && answer && (
            <>
              <datalist id="limb-points">
                {names(sheet, "point").map((name) => (
                  <option key={name} value={name} />
                ))}
              </datalist>
              <datalist id="limb-directions">
                {[...names(sheet, "direction"), "x", "y", "z"].map((name) => (
                  <option key={name} value={name} />
                ))}
              </datalist>
              <h2 class="sr-only">Limbs</h2>
              <div class="limb-cards" data-testid="limb-cards">
                {sheet.limbs.map((limb, at) => (
                  <LimbCard key={`${at} ${limb.name}`} limb={limb} turned={sheet.turned} at={at} count={sheet.limbs.length} kinds={answer.kinds} change={change} />
                ))}
                <AddLimb plane={sheet.plane} kinds={answer.kinds} add={(text) => change({ do: "limb add", text })} />
              </div>
              {sheet.names.length > 0 && <NamesTable sheet={sheet} units={answer.units} follow={follow} setFollow={setFollow} change={change} />}
            </>
          )}
        </div>
      </div>
      <aside class="limbs-side" aria-label="The robot so far">
        <Picture answer={answer} study={known && answer && known.text === answer.text ? known.study : null} lit={lit} />
        <Outcome building={building} change={change} open={open} save={save} />
      </aside>
    </div>
  );
}

const NONE: readonly string[] = [];

const names = (sheet: LimbSheet, sort: "point" | "direction"): string[] => sheet.names.filter((row) => row.sort === sort).map(({ name }) => name);

/** The points of the joint under the pointer, those of the first copy. */
function pointsAt(target: EventTarget | null): readonly string[] {
  const row = target instanceof Element ? target.closest<HTMLElement>("[data-points]") : null;
  const words = row?.dataset.points?.split(" ") ?? [];
  return words.length > 0 ? words.map((word) => word.replace("%", "1")) : NONE;
}
