// Whole ranges of poses: which part of them is proved free of singular poses, as a map of boxes; or whether all of it is, as a certificate.
import type { BoxesArgs, Study } from "../../../protocol";
import { CertificateButton } from "../../parts/certificate-button";
import { useStore } from "../../parts/context";
import { Icon } from "../../parts/icon";
import { samePose } from "../../state/doc";
import { wholeInWords, wholeOf, type Whole } from "../../state/roaming";
import { CertificateResult } from "./certificate";
import { BoxesPicture, Moved, Shares } from "./range-parts";
import { Question } from "./section";
import { WholeFields } from "./whole-fields";

const KINDS: Record<Whole["kind"], { verb: string; why: string }> = {
  map: {
    verb: "Map",
    why: "Which part of all poses in these ranges is free of singular ones, proved; the other coordinates stay as they are.",
  },
  certificate: {
    verb: "Certify",
    why: "Is the whole range free of singular poses? A proof with the least margin, a singular pose, or what is left.",
  },
};

export function BoxesSection({ study }: { study: Study }) {
  const { roaming, doc, pose$ } = useStore();
  const { boxes, certify, whole$ } = roaming;
  const whole = whole$.value;
  const { kind, cone, tilt } = whole;
  const ranges = wholeOf(study, whole);
  const busy = (kind === "map" ? boxes : certify).now.value.state === "busy";

  function ask(): void {
    const { source, pose } = doc.peek();
    if (!source) return;
    const over = study.wholes.flatMap(({ unit }, i) => (ranges[i] ? [wholeInWords(ranges[i], unit)] : []));
    const { margin, limits, boxes: most } = whole;
    const args: BoxesArgs = { source, pose, over, margin, boxes: most, ...(limits && { limits }) };
    if (kind === "map") void boxes.start(args);
    else void certify.start({ ...args, ...(cone && { cone }), ...(tilt && { tilt }) });
  }

  const { verb, why } = KINDS[kind];
  const asking = {
    title: "Whole ranges",
    why,
    fields: <WholeFields study={study} ranges={ranges} />,
    ask: (
      <button type="button" class="primary" disabled={busy || !ranges.some(Boolean)} onClick={ask} data-testid="boxes-go">
        <Icon name={kind === "map" ? "where" : "ok"} size={14} /> {verb}
      </button>
    ),
  };
  if (kind === "certificate") {
    return (
      <Question {...asking} name="certify" runner={certify} tone={({ answer }) => answer}>
        {(result, asked) => <CertificateResult result={result} asked={asked} />}
      </Question>
    );
  }
  return (
    <Question {...asking} name="boxes" runner={boxes}>
      {(result, asked) => (
        <>
          <Shares result={result} />
          <BoxesPicture result={result} />
          {!samePose(asked.pose, pose$.value) && <Moved />}
          <CertificateButton what="boxes" asked={asked} />
        </>
      )}
    </Question>
  );
}
