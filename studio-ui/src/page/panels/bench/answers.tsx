// What one statement gave: a formula, a verdict, and whether it stands in the picture.
import { useState } from "preact/hooks";
import type { BenchResult, Piece } from "../../../protocol";
import { Formula } from "../../parts/formula";
import { Icon, type IconName } from "../../parts/icon";

const STEPS = ["scalar", "point", "line", "plane"];
const MOST = 40; // pieces that are shown without being asked for

const VERDICTS: Partial<Record<BenchResult["verdict"], { title: string; icon: IconName }>> = {
  proved: { title: "Proved", icon: "ok" },
  refuted: { title: "Refuted", icon: "close" },
  undecided: { title: "Not decided", icon: "warn" },
};

interface Props {
  results: readonly BenchResult[];
  hidden: ReadonlySet<string>;
  rank: number;
  onToggle(label: string): void;
}

export function Answers({ results, hidden, rank, onToggle }: Props) {
  return (
    <div class="bench-answers">
      {results.map((result, i) => (
        <Answer key={i} result={result} rank={rank} shown={!hidden.has(labelOf(result))} onToggle={onToggle} />
      ))}
    </div>
  );
}

export const labelOf = ({ drawn }: BenchResult): string => drawn?.label ?? "";

interface AnswerProps {
  result: BenchResult;
  rank: number;
  shown: boolean;
  onToggle(label: string): void;
}

function Answer({ result, rank, shown, onToggle }: AnswerProps) {
  const [all, showAll] = useState(false);
  const { name, command, pieces, verdict, text, step, drawn } = result;
  const said = VERDICTS[verdict];
  const kind = step === null || rank !== 4 ? undefined : STEPS[step];
  return (
    <div class={`bench-answer ${verdict}`} data-testid="bench-result" data-verdict={verdict} {...(name && { "data-name": name })}>
      {said && (
        <p class="verdict">
          <Icon name={said.icon} size={15} /> {said.title}
        </p>
      )}
      {pieces.length > 0 ? (
        <Formula left={name ? [nameOf(name)] : []} right={all ? pieces : pieces.slice(0, MOST)} />
      ) : (
        (verdict !== "proved" || !said) && <pre class="said">{said ? reasonsOf(text) : text}</pre>
      )}
      {command && pieces.length > 0 && reasonsOf(text) !== text && <pre class="said">{reasonsOf(text)}</pre>}
      {pieces.length > MOST && (
        <button type="button" class="quiet" onClick={() => showAll(!all)}>
          {all ? "Less" : `All ${pieces.length} terms`}
        </button>
      )}
      <span class="about">
        {kind && <span class="kind">{kind}</span>}
        {drawn && (
          <button
            type="button"
            class="quiet draw"
            aria-pressed={shown}
            title={shown ? "Shown in 3D" : "Not shown in 3D"}
            aria-label={`${drawn.label} in 3D`}
            data-testid="bench-draw"
            onClick={() => onToggle(drawn.label)}
          >
            <Icon name="orbit" size={15} /> 3D
          </button>
        )}
      </span>
    </div>
  );
}

/** Without the first line, which repeats what was written. */
const reasonsOf = (text: string): string => text.split("\n").slice(1).map((line) => line.replace(/^ {2}/, "")).join("\n") || text;

function nameOf(name: string): Piece {
  const found = /^([A-Za-z]+)_?(\d+)?('*)$/.exec(name);
  const [, letters = name.replaceAll("_", "\\_"), number, primes = ""] = found ?? [];
  const word = letters.length > 1 ? `\\mathit{${letters}}` : letters;
  return { tex: `${word}${primes}${number ? `_{${number}}` : ""}`, points: [], brackets: [] };
}
