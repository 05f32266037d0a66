// A certificate: the margin that is proved, the parts of the volume, the pose that matters most, and the file that can be checked again.
import type { CertificateAnswer, CertifiedPlace, CertifyArgs } from "../../../protocol";
import { short } from "../../lib/format";
import { Checked } from "../../parts/certificate-button";
import { useStore } from "../../parts/context";
import { Icon } from "../../parts/icon";
import { Prose } from "../../parts/prose";
import { samePose } from "../../state/doc";
import { download } from "../../lib/download";
import { madeOf, sizeOf } from "../take-away/making";
import { BoxesPicture, Moved, Shares } from "./range-parts";

const TITLES: Record<CertifiedPlace["kind"], string> = {
  singular: "A singular pose",
  below: "A pose below the margin",
  least: "The smallest margin that was seen",
};

export function CertificateResult({ result, asked }: { result: CertificateAnswer; asked: CertifyArgs }) {
  const { pose$ } = useStore();
  const { place, bound, answer } = result;
  const known = [asked.pose, ...(place?.pose ? [place.pose] : [])];
  return (
    <>
      {bound !== null && (
        <dl class="bounds">
          <div>
            <dt>σ ≥ {short(bound)}</dt>
            <dd>proved, {answer === "free" ? "in all of the range that is reached" : "in all boxes that are free"}</dd>
          </div>
          {place?.kind === "least" && (
            <div>
              <dt>σ = {short(place.margin)}</dt>
              <dd>the smallest that was seen</dd>
            </div>
          )}
        </dl>
      )}
      <Shares result={result} />
      {place && <PlaceCard place={place} />}
      <BoxesPicture result={result} />
      {!known.some((pose) => samePose(pose, pose$.value)) && <Moved />}
      <Kept result={result} />
    </>
  );
}

/** A pose that the robot can be taken to. */
function PlaceCard({ place: { kind, words, margin, causes, pose, short: ends } }: { place: CertifiedPlace }) {
  const { moving, pose$ } = useStore();
  const there = pose !== null && samePose(pose, pose$.value);
  return (
    <div class={`certified ${kind}`} data-testid="certify-place" data-kind={kind}>
      <div class="head">
        <strong>{TITLES[kind]}</strong>
        <button
          type="button"
          disabled={!pose || there}
          title={pose ? undefined : "The sliders do not lead there from home"}
          data-testid="certify-go"
          onClick={() => pose && moving.to(pose)}
        >
          <Icon name="target" size={14} /> {there ? "Here" : "Go there"}
        </button>
      </div>
      <p class="at">
        {words.replaceAll("-", "−")}, σ = {short(margin, 3)}
      </p>
      {causes.map((cause) => (
        <p key={cause}>
          <Prose text={cause} />
        </p>
      ))}
      {!pose && <p class="tip">The sliders do not lead there from home.</p>}
      {ends && <p class="tip">The actuators come to a stop at this pose: the sliders end just short of it.</p>}
    </div>
  );
}

function Kept({ result: { file, check, answer } }: { result: CertificateAnswer }) {
  const made = madeOf(file);
  return (
    <div class="kept">
      <button type="button" onClick={() => download(made)} data-testid="certify-file">
        <Icon name="take-away" size={15} /> Certificate <span class="size">{sizeOf(made.blob.size)}</span>
      </button>
      <Checked text={check}>{answer === "undecided" && <> More boxes decide more; so does a smaller range.</>}</Checked>
    </div>
  );
}
