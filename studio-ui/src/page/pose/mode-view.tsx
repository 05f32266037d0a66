// The working modes of a robot with limbs: listed when asked for, and one of them taken for its home.
import type { Methods, Source } from "../../protocol";
import { short } from "../lib/format";
import { useStore } from "../parts/context";
import { Drawing } from "../parts/drawing";
import { FaultBox } from "../parts/fault-box";
import { Seeks } from "./nearest-view";
import { Termed } from "../parts/term";

type Mode = Methods["modes"]["result"]["modes"][number];

export const modeOf = (source: Source | null): string | undefined => (source && "mode" in source ? source.mode : undefined);

/** The source with its home in a mode; undefined stands for that of the file. */
export function inMode(source: Source, mode: string | undefined): Source {
  if (source.kind !== "robot" && source.kind !== "file") return source;
  const { mode: _, ...home } = source;
  return mode === undefined ? home : { ...home, mode };
}

export function ModeView() {
  const { modes, doc, source$, open, panel$ } = useStore();
  const now = modes.now.value;
  const source = source$.value;
  const current = modeOf(source);

  function list(): void {
    const { source, threshold } = doc.peek();
    if (source) void modes.start({ source, threshold });
  }

  return (
    <section class="nearest modes" aria-label="Working modes">
      <h3>
        <Termed text="Working mode" />
      </h3>
      {now.state !== "found" && (
        <div class="buttons">
          <button
            type="button"
            disabled={now.state === "busy"}
            title="Lists all ways in which the limbs hold the platform where it is at home"
            data-testid="modes-list"
            onClick={list}
          >
            <span>{current === undefined ? "that of the file" : current}</span>
            <strong>List all</strong>
          </button>
        </div>
      )}
      {now.state === "busy" && <Seeks words={now.words} stop={modes.stop} testid="modes-stop" />}
      {now.state === "failed" && <FaultBox fault={now.fault} />}
      {now.state === "found" && source && (
        <>
          <div class="buttons many" role="group" aria-label="Working modes">
            {now.result.modes.map((mode, index) => (
              <button
                type="button"
                key={mode.name}
                aria-pressed={index === 0 ? current === undefined : current === mode.name}
                disabled={mode.verdict === null}
                title={`${meaning(mode, index)}: ${mode.drives}`}
                data-testid="mode"
                onClick={() => open(inMode(source, index === 0 ? undefined : mode.name), panel$.peek())}
              >
                {mode.svg && <Drawing svg={mode.svg} label={`The robot at home in the working mode ${mode.name}`} />}
                <span>{mode.name}</span>
                <strong class={mode.verdict ?? ""}>
                  {mode.margin === null ? "—" : short(mode.margin, 3)} {mode.signs && <b>{mode.signs}</b>}
                </strong>
              </button>
            ))}
          </div>
          <p class="tip" role="status">
            σ at home in each mode, and the signs of the condition's factors. {now.result.ways.join("; ")}.
          </p>
        </>
      )}
    </section>
  );
}

const meaning = ({ verdict }: Mode, index: number): string =>
  `${index === 0 ? "As the file has it" : "Limbs are placed differently"}, ${verdict ?? "without numbers"} at home`;
