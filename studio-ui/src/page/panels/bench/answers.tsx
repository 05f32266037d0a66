// What one statement gave: a formula, a verdict, and whether it stands in the picture.
import { useState } from "preact/hooks";
import type { AppliedRule, BenchResult, Piece, Repeated, RuleOwner } from "../../../protocol";
import { Formula } from "../../parts/formula";
import { Icon, type IconName } from "../../parts/icon";
import { hangOf } from "../../lib/hanging";
import { LineToCopy, useCopy } from "../../parts/line-to-copy";

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
  const [repeating, repeat] = useState(false);
  const copy = useCopy();
  const { name, command, verdict, text, tex, terms, step, drawn } = result;
  const pieces = IN_WORDS.has(command ?? "") ? [] : result.pieces;
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
        <InWords result={result} />
      )}
      {pieces.length > 0 && (command || result.way) && reasonsOf(text) && <Said text={reasonsOf(text)} />}
      {pieces.length > MOST && (
        <button type="button" class="quiet" onClick={() => showAll(!all)}>
          {all ? "Less" : pieces.length < terms ? `The first ${pieces.length} of ${terms} terms` : `All ${terms} terms`}
        </button>
      )}
      <Applied rules={result.applied} />
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
        <button type="button" class="quiet act" title="Copy this answer" aria-label="Copy this answer" data-testid="bench-copy" onClick={() => copy(text, "The answer")}>
          <Icon name="copy" size={15} />
        </button>
        {tex && (
          <button type="button" class="quiet act" title={texTitle(command)} aria-label={texTitle(command)} data-testid="bench-copy-tex" onClick={() => copy(tex, "LaTeX")}>
            TeX
          </button>
        )}
        <button
          type="button"
          class="quiet act"
          title="Repeat this answer: lines for the shell and for Python"
          aria-label="Repeat this answer"
          aria-expanded={repeating}
          data-testid="bench-repeat"
          onClick={() => repeat(!repeating)}
        >
          <Icon name="terminal" size={15} />
        </button>
      </span>
      {repeating && <Repeating repeated={result.repeat} />}
    </div>
  );
}

/** An answer without a formula: how it is known, and what a proof assumes not to vanish. */
function InWords({ result: { verdict, sentences, text } }: { result: BenchResult }) {
  if (sentences.length > 0) return <Analysed sentences={sentences} text={text} />;
  const reasons = VERDICTS[verdict] ? reasonsOf(text) : text;
  if (reasons) return <Said text={reasons} />;
  return verdict === "proved" ? null : <Said text={text} />;
}

/** Answers that are sentences, with the formulas in them. */
const IN_WORDS = new Set(["analyze", "transversals"]);

const texTitle = (command: string | null): string => `Copy ${IN_WORDS.has(command ?? "") ? "the condition" : "this answer"} as LaTeX`;

const FEW = 12; // lines of an answer in words that are shown without being asked for

/** Plain text, broken to the width that there is: what is broken goes on below its first word, of facts below what is said. */
function Lined({ lines }: { lines: readonly string[] }) {
  return (
    <pre class="said">
      {lines.map((line, i) => (
        <span key={i} style={{ "--hang": `${hangOf(line)}ch` }}>
          {line}
          {"\n"}
        </span>
      ))}
    </pre>
  );
}

function Said({ text }: { text: string }) {
  const [all, showAll] = useState(false);
  const lines = text.split("\n");
  const long = lines.length > FEW + 3;
  return (
    <>
      <Lined lines={long && !all ? lines.slice(0, FEW) : lines} />
      {long && (
        <button type="button" class="quiet" onClick={() => showAll(!all)} data-testid="bench-more">
          {all ? "Less" : `All ${lines.length} lines`}
        </button>
      )}
    </>
  );
}

/** The condition in sentences, as the analysis begins; the whole of it when it is asked for. */
function Analysed({ sentences, text }: { sentences: readonly string[]; text: string }) {
  const [all, showAll] = useState(false);
  return (
    <div class="analysed">
      {sentences.map((sentence) => (
        <p key={sentence}>{sentence}</p>
      ))}
      {all && <Lined lines={text.split("\n")} />}
      <button type="button" class="quiet" onClick={() => showAll(!all)} data-testid="bench-more">
        {all ? "Less" : "The analysis, step by step"}
      </button>
    </div>
  );
}

/** The rules that led to an answer; those that did not come with gcrules stand out. */
function Applied({ rules }: { rules: readonly AppliedRule[] }) {
  if (rules.length === 0) return null;
  return (
    <p class="applied" data-testid="bench-applied">
      by{" "}
      {rules.map(({ id, sentence, owner }) => (
        <code key={id} class={owner.kind === "gcrules" ? "" : "own"} title={[sentence, ownerName(owner)].filter(Boolean).join(" — ")}>
          {id}
        </code>
      ))}
    </p>
  );
}

const ownerName = ({ kind, name, line }: RuleOwner): string => (kind === "text" ? "of this text" : kind === "gcrules" ? "gcrules" : line === null ? name : `${name}:${line}`);

function Repeating({ repeated }: { repeated: Repeated | null }) {
  if (!repeated)
    return (
      <p class="lines none" data-testid="bench-lines">
        The lines for this answer would be too long: those for the whole bench repeat it.
      </p>
    );
  const { shell, python, files } = repeated;
  return (
    <div class="lines" data-testid="bench-lines">
      <LineToCopy title="Line for the shell" language="shell" text={shell} files={files} name="shell" />
      {python ? <LineToCopy title="Lines of Python" language="python" text={python} files={[]} name="python" /> : <p class="none">No function of Python does this.</p>}
    </div>
  );
}

/** Without the first line, which repeats what was written. */
/** What stands below the first line of an answer, which says again what was asked. */
function reasonsOf(text: string): string {
  const lines = text.split("\n").slice(1);
  const indent = Math.min(...lines.map((line) => line.search(/\S|$/)));
  return lines.map((line) => line.slice(indent)).join("\n");
}

function nameOf(name: string): Piece {
  const found = /^([A-Za-z]+)_?(\d+)?('*)$/.exec(name);
  const [, letters = name.replaceAll("_", "\\_"), number, primes = ""] = found ?? [];
  const word = letters.length > 1 ? `\\mathit{${letters}}` : letters;
  return { tex: `${word}${primes}${number ? `_{${number}}` : ""}`, points: [], brackets: [] };
}
