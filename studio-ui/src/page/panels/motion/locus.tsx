// The polynomials of the singular poses around the pose on show, with their factors, to be copied.
import { useSignal } from "@preact/signals";
import type { LocusPart, Polynomial, Study } from "../../../protocol";
import { useStore } from "../../parts/context";
import { FaultBox } from "../../parts/fault-box";
import { useSight } from "../../parts/sight";
import { Seeks } from "../../pose/nearest-view";
import { samePose } from "../../state/doc";
import { rangesOf } from "../../state/touring";
import { Facts } from "./facts";
import "./locus.css";

const FORMS = [
  ["plain", "Text"],
  ["latex", "LaTeX"],
  ["python", "Python"],
] as const;

export function LocusSection({ study }: { study: Study }) {
  const { touring, doc, tour$, pose$ } = useStore();
  const { locus } = touring;
  const now = locus.now.value;
  const sight = useSight(now.state === "found");
  const slice = rangesOf(study, tour$.value)?.map(({ name }) => name) ?? [];
  const sliced = study.loci.some((pair) => pair.every((name) => slice.includes(name)));

  function go(over?: string[]): void {
    const { source, pose } = doc.peek();
    if (source) void locus.start({ source, pose, ...(over && { over }) });
  }

  return (
    <section class="locus" aria-label="Locus" ref={sight}>
      <h3>The singular poses as a formula</h3>
      {study.no_locus && (
        <p class="tip" data-testid="locus-none">
          There is no such polynomial: {study.no_locus}.
        </p>
      )}
      <div class="ask" hidden={study.no_locus !== ""}>
        <div class="row">
          <span class="told">The polynomial that is 0 at them, exactly, and its factors.</span>
          <button type="button" class="primary" disabled={now.state === "busy"} onClick={() => go()} data-testid="locus-position">
            Of the position
          </button>
          {sliced && (
            <button type="button" class="second" disabled={now.state === "busy"} onClick={() => go(slice)} data-testid="locus-slice">
              Of the map: {slice.join(", ")}
            </button>
          )}
        </div>
      </div>
      {now.state === "busy" && <Seeks words={now.words} stop={locus.stop} testid="locus-stop" />}
      {now.state === "failed" && <FaultBox fault={now.fault} />}
      {now.state === "found" && (
        <div class="answer">
          <p class="guarantee" data-testid="locus-statement">
            {now.result.statement}
          </p>
          {now.result.notes.map((note) => (
            <p key={note} class="tip">
              {note}
            </p>
          ))}
          {!samePose(now.asked.pose, pose$.value) && <p class="tip">The robot has moved since: this is at the pose that was asked about.</p>}
          {now.result.parts.map((part) => (
            <Part key={part.name} part={part} />
          ))}
          {now.result.roots.map(({ name, places, square, sign }) => (
            <article key={name} class="polynomial" data-testid="locus-root">
              <p class="reason">
                {name} tells apart two places of {places}; in home's mode it {sign ? `has the sign of ${sign}` : "is positive"}.
              </p>
              <Formulas name={`${name}²`} polynomial={square} />
            </article>
          ))}
          <Facts facts={now.result.facts} title="What was computed, and how it was checked" />
        </div>
      )}
    </section>
  );
}

function Part({ part }: { part: LocusPart }) {
  const { name, statement, polynomial, factors, undecided } = part;
  const vanishes = polynomial.terms === 0;
  const alone = factors.length === 1 && factors[0]?.multiplicity === 1;
  return (
    <article class="polynomial" data-testid="locus-part">
      <p class="reason">{statement}</p>
      {vanishes ? (
        <p class="none">{name} is 0 at all of these poses.</p>
      ) : (
        <>
          <Formulas name={name} polynomial={polynomial} />
          {undecided && <p class="tip">Its factors are not decided: {undecided}.</p>}
          {alone && <p class="tip">It has no factors over the rationals{ofZeros(factors[0]?.zeros)}.</p>}
          {!alone &&
            factors.map(({ polynomial: factor, multiplicity, never, zeros }, i) => (
              <div key={i} data-testid="locus-factor">
                <p class="tip">
                  Factor {i + 1}
                  {multiplicity > 1 && `, to the power ${multiplicity}`}
                  {never && ", 0 in no pose"}
                  {ofZeros(zeros)}
                </p>
                <Formulas name={`${name}_${i + 1}`} polynomial={factor} />
              </div>
            ))}
        </>
      )}
    </article>
  );
}

function ofZeros(zeros = ""): string {
  return zeros && `: ${zeros}`;
}

function Formulas({ name, polynomial }: { name: string; polynomial: Polynomial }) {
  const form = useSignal<(typeof FORMS)[number][0]>("plain");
  const said = useSignal("Copy");
  const text = polynomial[form.value];

  async function copy(): Promise<void> {
    try {
      await navigator.clipboard.writeText(text);
      said.value = "Copied";
    } catch {
      said.value = "Select the text and copy it";
    }
    setTimeout(() => (said.value = "Copy"), 2500);
  }

  return (
    <figure class="formula-text">
      <figcaption>
        <b>{name}</b>
        <span>
          degree {polynomial.degree}, {polynomial.terms} {polynomial.terms === 1 ? "term" : "terms"}
        </span>
        <span class="forms" role="group" aria-label={`How ${name} is written`}>
          {FORMS.map(([kind, title]) => (
            <button type="button" key={kind} aria-pressed={form.value === kind} onClick={() => (form.value = kind)} data-testid={`locus-${kind}`}>
              {title}
            </button>
          ))}
        </span>
        <button type="button" class="second" onClick={() => void copy()} data-testid="locus-copy" aria-live="polite">
          {said.value}
        </button>
      </figcaption>
      <pre tabIndex={0} aria-label={`${name} as ${form.value}`} data-testid="locus-text">
        {text}
      </pre>
    </figure>
  );
}
