// The waypoints: to go to, to put elsewhere, to drag into another order, to take out; and as a table, both ways.
import { useRef, useState } from "preact/hooks";
import { useStore } from "../parts/context";
import { Icon } from "../parts/icon";
import { inWords } from "../lib/pose-words";
import { download } from "../lib/download";
import { fileName } from "../panels/take-away/making";

const LISTED = 40;

/** A row that is dragged, and the one that it is over. */
interface Dragged {
  from: number;
  to: number;
}

function rowAt({ clientX, clientY }: PointerEvent): number | null {
  const row = document.elementFromPoint(clientX, clientY)?.closest<HTMLElement>("li[data-index]");
  return row ? Number(row.dataset["index"]) : null;
}

export function Stops() {
  const { timeline, study, settle } = useStore();
  const { stops, given } = timeline;
  const shown = study.value;
  const [dragged, drag] = useState<Dragged | null>(null);
  const list = stops.value;
  if (!shown) return null;

  function key(event: KeyboardEvent, index: number): void {
    const by = { ArrowUp: -1, ArrowDown: 1 }[event.key];
    if (by === undefined || !event.altKey) return;
    event.preventDefault();
    timeline.shift(index, Math.min(Math.max(index + by, 0), list.length - 1));
  }

  return (
    <div class="stops" data-given={given.value}>
      <div class="line">
        <button type="button" class="small" data-testid="way-add" title="Add the pose on show as the last waypoint" onClick={timeline.add}>
          Add this pose
        </button>
        <Tables />
        <span class="space" />
        <button type="button" class="quiet" data-testid="way-clear" disabled={list.length < 2 && !given.value} onClick={() => (settle(), timeline.clear())}>
          Start over here
        </button>
      </div>
      {list.length > 1 && (
        <details open={given.value}>
          <summary data-testid="way-stops">
            {list.length} waypoints{given.value ? "" : ", as it was driven"}
          </summary>
          <ol>
            {list.slice(0, LISTED).map((pose, i) => (
              <li
                key={i}
                class={dragged?.from === i ? "held" : dragged?.to === i ? "over" : given.value && timeline.chosen.value === i ? "chosen" : ""}
                data-testid="way-stop"
                data-index={i}
              >
                <span
                  class="grip"
                  title="Drag it to another place in the list"
                  data-testid="way-grip"
                  onPointerDown={(event) => {
                    event.preventDefault();
                    event.currentTarget.setPointerCapture(event.pointerId);
                    drag({ from: i, to: i });
                  }}
                  onPointerMove={(event) => dragged && drag({ ...dragged, to: rowAt(event) ?? dragged.to })}
                  onPointerUp={() => {
                    if (dragged && dragged.to !== dragged.from) timeline.shift(dragged.from, dragged.to);
                    drag(null);
                  }}
                  onPointerCancel={() => drag(null)}
                >
                  <Icon name="grip" size={14} />
                </span>
                <button
                  type="button"
                  class="quiet name"
                  title="Go there; Alt and an arrow key moves it in the list"
                  onKeyDown={(event) => key(event, i)}
                  onClick={() => {
                    timeline.lead(i);
                    if (given.value) timeline.choose(i);
                  }}
                >
                  <b>{i + 1}</b> {inWords(pose, shown)}
                </button>
                <button type="button" class="quiet" title="The pose on show takes its place" data-testid="way-put" onClick={() => timeline.put(i)}>
                  Put here
                </button>
                <button type="button" class="quiet tool" aria-label={`Take out waypoint ${i + 1}`} data-testid="way-remove" onClick={() => timeline.remove(i)}>
                  <Icon name="close" size={14} />
                </button>
              </li>
            ))}
          </ol>
          {list.length > LISTED && <p class="tip">And {list.length - LISTED} more.</p>}
        </details>
      )}
    </div>
  );
}

function Tables() {
  const { timeline, study } = useStore();
  const input = useRef<HTMLInputElement>(null);
  async function write(): Promise<void> {
    const table = await timeline.table();
    if (table !== null) download({ name: fileName(study.peek()?.title, "way.csv"), blob: new Blob([table], { type: "text/csv" }) });
  }
  return (
    <>
      <button type="button" class="small" title="A table of poses, as for gcrules path" onClick={() => input.current?.click()}>
        Open CSV
      </button>
      <input
        ref={input}
        type="file"
        accept=".csv,.txt,text/csv"
        hidden
        aria-label="A table of poses"
        data-testid="way-file"
        onChange={async (event) => {
          const [file] = event.currentTarget.files ?? [];
          const text = await file?.text();
          if (input.current) input.current.value = "";
          if (text !== undefined) await timeline.read(text);
        }}
      />
      <button type="button" class="small" data-testid="way-save" disabled={timeline.stops.value.length < 2} onClick={() => void write()}>
        Save CSV
      </button>
    </>
  );
}
