// The expression bench: the language of gcrules, answered as it is written; points, lines and planes stand in 3D.
import type { EditorView } from "@codemirror/view";
import { useEffect, useMemo, useRef, useState } from "preact/hooks";
import { BENCH_OPERATIONS, type BenchResult, type Fault, type Study } from "../../protocol";
import { StoreProvider } from "../parts/context";
import { FaultBox } from "../parts/fault-box";
import { Icon } from "../parts/icon";
import { Seeks } from "../pose/nearest-view";
import type { Overlay } from "../state/scene";
import type { Store } from "../state/store";
import { Answers, labelOf } from "./bench/answers";
import { Editor, type Below } from "./bench/editor";
import { createEvaluation } from "./bench/evaluation";
import { examplesFor } from "./bench/examples";
import { helping } from "./bench/helping";
import { declareText } from "./bench/asking";
import { Operations } from "./bench/operations";
import { Rules } from "./bench/rules";
import { ScriptFiles } from "./bench/script-files";
import type { PanelProps } from "./index";
import "./bench/bench.css";

export function Bench({ store }: PanelProps) {
  const evaluation = useMemo(() => createEvaluation(store), [store]);
  useEffect(() => evaluation.dispose, [evaluation]);
  const [hidden, hide] = useState<ReadonlySet<string>>(new Set());
  const text = store.bench$.value;
  const bench = evaluation.bench.value;
  const results = bench?.results ?? NONE;
  const fault = evaluation.fault.value ?? bench?.fault ?? null;
  const study = store.study.value;

  useEffect(() => {
    store.space.overlay.value = overlayOf(results.filter((result) => !hidden.has(labelOf(result))));
  }, [store, results, hidden]);
  useEffect(() => () => void (store.space.overlay.value = null), [store]);

  const toggle = (label: string): void =>
    hide((now) => new Set(now.has(label) ? [...now].filter((other) => other !== label) : [...now, label]));
  const rank = Number(/^[ \t]*rank[ \t]+(\d+)/m.exec(text)?.[1] ?? 4);
  const below = useMemo<Below[]>(
    () => [
      ...grouped(results).map((group) => ({
        end: group[0]?.end ?? 0,
        key: JSON.stringify([group, group.map((result) => hidden.has(labelOf(result)))]),
        content: (
          <StoreProvider value={store}>
            <Answers results={group} hidden={hidden} rank={rank} onToggle={toggle} />
          </StoreProvider>
        ),
      })),
      ...placed(fault).map((one) => ({
        end: one.place?.start ?? 0,
        key: JSON.stringify(one),
        content: (
          <div class="bench-fault">
            <FaultBox fault={one} />
          </div>
        ),
      })),
    ],
    [store, results, hidden, rank, fault],
  );

  function write(next: string): void {
    if (next !== store.bench$.peek()) store.edit({ bench: next }, "bench");
  }

  const [words, say] = useState("");
  useEffect(() => say(""), [text]);
  const editor = useRef<EditorView | null>(null);
  const help = useMemo(() => helping(store), [store]);
  const theorems = store.gallery.value?.theorems ?? [];
  const examples = [...examplesFor(study), ...theorems];
  const own = examples.length - theorems.length;
  const drawn = results.filter(({ drawn: shown }) => shown).length;
  return (
    <div class="bench">
      <header>
        <h2>Expression bench</h2>
        <div class="bar">
          <label class="examples">
            <span class="sr-only">Examples</span>
            <select
              value=""
              data-testid="bench-examples"
              onChange={(event) => {
                const chosen = examples[Number(event.currentTarget.value)];
                event.currentTarget.value = "";
                if (!chosen) return;
                store.settle();
                store.edit({ bench: chosen.text });
                evaluation.run();
              }}
            >
              <option value="">Examples …</option>
              {examples.slice(0, own).map(({ title }, i) => (
                <option key={title} value={i}>
                  {title}
                </option>
              ))}
              {theorems.length > 0 && (
                <optgroup label="Theorems">
                  {theorems.map(({ title }, i) => (
                    <option key={title} value={own + i}>
                      {title}
                    </option>
                  ))}
                </optgroup>
              )}
            </select>
          </label>
          <Help />
          <ScriptFiles store={store} say={say} />
          <span class="space" />
          {evaluation.busy.value && <span class="spinner" role="status" aria-label="Working" />}
          <button type="button" class="primary" disabled={!text.trim()} title="Ctrl Enter" onClick={evaluation.run} data-testid="bench-run">
            <Icon name="play" size={13} /> Evaluate
          </button>
        </div>
      </header>
      <Operations view={() => editor.current} results={results} legs={legsOf(study)} say={say} />
      {evaluation.words.value && <Seeks words={evaluation.words.value} stop={evaluation.stop} testid="bench-stop" />}
      <Editor
        text$={store.bench$}
        below={below}
        fault={fault}
        help={help}
        onText={write}
        onRun={evaluation.run}
        hold={(view) => void (editor.current = view)}
      />
      {fault && !fault.place && <FaultBox fault={fault} />}
      <p class="note" role="status" data-testid="bench-note">
        {words || (evaluation.stopped.value ? stoppedNote(results.length) : noteOf(results, drawn, firstNote(store), fault !== null))}
      </p>
      {!store.client.alone && <Rules store={store} results={results} text={text} say={say} write={(rule) => editor.current && declareText(editor.current, rule)} />}
    </div>
  );
}

const stoppedNote = (answers: number): string => `Stopped${answers > 0 ? ` with ${counted(answers, "answer")}` : ""}. Evaluate starts over.`;

const NONE: readonly BenchResult[] = [];

/** The legs of the robot that is open, as the language takes them; "" where some point has a long name. */
function legsOf(study: Study | null): string {
  const legs = study?.legs ?? [];
  return legs.length === 6 && legs.flat().every((name) => /^[A-Za-z]\d*'*$/.test(name)) ? legs.map((leg) => leg.join("")).join(" ") : "";
}

function firstNote({ client, study }: Store): string {
  if (client.alone) return "Letters are points: write joins and meets of them.";
  return study.value
    ? "Write joins and meets of the robot's joints: what is a point, a line or a plane stands in 3D at the pose."
    : "Letters are points. Open a structure to see points, lines and planes in 3D.";
}

const counted = (n: number, noun: string): string => `${n} ${noun}${n === 1 ? "" : "s"}`;

function noteOf(results: readonly BenchResult[], drawn: number, first: string, wrong: boolean): string {
  if (results.length === 0 && !wrong) return first;
  const refuted = results.filter(({ verdict }) => verdict === "refuted").length;
  return [
    counted(results.length, "answer"),
    drawn > 0 ? `${drawn} in 3D` : "",
    refuted > 0 ? `${refuted} refuted` : "",
    wrong ? "a fault" : "",
  ]
    .filter(Boolean)
    .join(" · ");
}

/** Faults that have a place stand there. */
const placed = (fault: Fault | null): Fault[] => {
  if (!fault) return [];
  const { more = [], ...first } = fault;
  return [first, ...more].filter(({ place }) => place);
};

/** Answers of one statement stand together. */
function grouped(results: readonly BenchResult[]): BenchResult[][] {
  const groups = new Map<number, BenchResult[]>();
  results.forEach((result) => groups.set(result.end, [...(groups.get(result.end) ?? []), result]));
  return [...groups.values()];
}

function overlayOf(results: readonly BenchResult[]): Overlay {
  const planes: Overlay["planes"] = [];
  const constructed: Overlay["constructed"] = [];
  for (const { drawn } of results) {
    if (drawn?.kind === "plane") planes.push({ label: drawn.label, normal: drawn.normal, offset: drawn.offset });
    else if (drawn) constructed.push(drawn);
  }
  return { planes, constructed, entities: [], alone: planes.length + constructed.length > 0 };
}

function Help() {
  return (
    <details class="bench-help">
      <summary data-testid="bench-help">Language</summary>
      <dl>
        {BENCH_OPERATIONS.map(([sign, words]) => (
          <>
            <dt>
              <code>{sign}</code>
            </dt>
            <dd>{words}</dd>
          </>
        ))}
      </dl>
    </details>
  );
}
