// The verdict at the pose: value, margin, and the reason. Its height stays, so that sliders do not move under the hand.
import { computed } from "@preact/signals";
import { useMemo } from "preact/hooks";
import type { Study, Verdict } from "../../protocol";
import { steady } from "../lib/format";
import { useStore } from "../parts/context";
import type { Posing } from "../state/posing";
import { FaultBox } from "../parts/fault-box";
import { Icon, type IconName } from "../parts/icon";
import { Term } from "../parts/term";
import { Gauge } from "./gauge";

export const VERDICTS: Record<Verdict, [string, IconName]> = {
  regular: ["Regular", "ok"],
  close: ["Close to singular", "warn"],
  singular: ["Singular", "stop"],
};

const SCALES = {
  platform:
    "The superbracket over ρ³ times the six leg lengths, with its sign: zero at a singular pose. ρ is the root-mean-square distance of the legs' platform ends from their centroid",
  robot:
    "The superbracket of the equivalent lines over Hadamard's bound, the product of the lengths of their six coordinate vectors, with its sign: zero at a singular pose. Points count from their centroid, at unit scale. Without equivalent lines, σ",
};

const NONE: [string, IconName] = ["No numbers here", "warn"];
const WAITING: [string, IconName] = ["…", "ok"];

/** The numbers of the pose on show; none where it has a fault: those that are known are of another pose. */
function shown({ headline, fault }: Posing): { value: string; margin: string } | null {
  const found = headline.value;
  if (fault.value) return { value: "–", margin: "–" };
  return found && { value: steady(found.value), margin: steady(found.margin).trim().replace("+", "") };
}

const MARGIN = "The singularity margin: 0 at a singular pose, at most 1; the same in every frame and unit";

export function VerdictView() {
  const { posing, client, late, study } = useStore();
  const lost = client.line.value === "lost";
  const busy = late.value && !lost;
  const stale = lost || busy || posing.fault.value ? " stale" : "";
  const texts = useMemo(
    () => ({
      value: computed(() => shown(posing)?.value ?? "…"),
      margin: computed(() => shown(posing)?.margin ?? "…"),
      verdict: computed(() => (posing.fault.value ? null : (posing.headline.value?.verdict ?? null))),
    }),
    [posing],
  );
  const verdict = texts.verdict.value;
  const [word, icon] = verdict ? VERDICTS[verdict] : posing.fault.value ? NONE : WAITING;
  return (
    <section class={`verdict ${verdict ?? "waiting"}${stale}`} aria-label="At this pose" aria-busy={busy}>
      <div class="headline">
        <p class="word" role="status" data-testid="verdict" data-verdict={verdict ?? ""}>
          <Icon name={icon} size={20} /> {word}
        </p>
        {busy && (
          <p class="computing" data-testid="computing">
            <span class="spinner" aria-hidden="true" /> <span class="words">computing …</span>
          </p>
        )}
        <dl>
          <dt>
            <Term name="value">value</Term>
          </dt>
          <dd data-testid="value">{texts.value}</dd>
          <dt>
            <Term name="margin">σ</Term>
          </dt>
          <dd data-testid="margin">{texts.margin}</dd>
        </dl>
      </div>
      <Gauge />
      <Reason />
      <Meanings kind={study.value?.kind ?? "platform"} />
    </section>
  );
}

/** What the two numbers are, and how they belong together: for those who cannot point at them too. */
function Meanings({ kind }: { kind: Study["kind"] }) {
  return (
    <details class="meanings" data-testid="meanings">
      <summary>What value, σ and ε are</summary>
      <p>
        <b>Value</b>: {lower(SCALES[kind])}.
      </p>
      <p>
        <b>σ</b>: {lower(MARGIN)}. It is zero where the value is; between such poses the two need not rise and fall together.
      </p>
      <p>
        <b>ε</b>: the threshold. A pose is called close where σ does not guarantee it.
      </p>
    </details>
  );
}

const lower = (words: string): string => words.charAt(0).toLowerCase() + words.slice(1);

function Reason() {
  const { posing } = useStore();
  const fault = posing.fault.value;
  const numbers = posing.numbers.value;
  if (fault) return <FaultBox fault={fault} />;
  if (!numbers) return null;
  return (
    <div class="reason">
      <p data-testid="reason">{numbers.reason}</p>
      {numbers.notes.map((note) => (
        <p class="note" key={note}>
          {note}
        </p>
      ))}
    </div>
  );
}
