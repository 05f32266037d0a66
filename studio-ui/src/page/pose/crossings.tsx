// The singular poses of the way, with their causes; and over the picture what has just been crossed.
import type { PathAnswer, Sign, Study } from "../../protocol";
import { short } from "../lib/format";
import { differing, spanned } from "../lib/pose-words";
import { useStore } from "../parts/context";
import { Icon } from "../parts/icon";
import { Prose } from "../parts/prose";
import { poseAt } from "../lib/way";

const ICONS = { regular: "ok", close: "warn", singular: "stop" } as const;

export function Crossings({ proof }: { proof: PathAnswer }) {
  const { timeline, study } = useStore();
  const { places, stretches, verdict, reason, more } = proof;
  const robot = study.value;
  if (!robot) return null;
  return (
    <div class={`crossings ${verdict}`}>
      <p class="word" role="status" data-testid="way-verdict" data-verdict={verdict}>
        <Icon name={ICONS[verdict]} size={16} /> {reason}
      </p>
      <ol>
        {stretches.map((s, i) => (
          <li key={`s${i}`} class={s.singular ? "singular" : "undecided"} data-testid="way-stretch">
            <b>
              {named(proof, s.start, robot)} to {named(proof, s.end, robot)}
            </b>
            <span>{s.words.join(" ")}</span>
          </li>
        ))}
        {places.map((p, i) => (
          <li key={i} class="singular" data-testid="way-place">
            <b title={`Pose ${p.at}, at parameter ${short(p.parameter, 5)} of the way`}>{named(proof, p.parameter, robot)}</b>
            <span>
              <Prose text={p.words.join(" ")} />
            </span>
            {p.pose && (
              <button type="button" class="small" data-testid="way-place-go" onClick={() => timeline.lead(p.parameter)}>
                Go there
              </button>
            )}
          </li>
        ))}
      </ol>
      {more > 0 && <p class="tip">And {more} more.</p>}
    </div>
  );
}

/** The pose at a parameter of the way, by the coordinates in which its poses differ; the parameter where the pose is not known. */
function named(proof: PathAnswer, parameter: number, robot: Study): string {
  const pose = poseAt(proof, parameter);
  const words = pose && differing(pose, proof.samples.flatMap((s) => s.pose ?? []), robot);
  return words || `parameter ${short(parameter, 5)}`;
}

/** At once, from the signs of the factors; then what the proof of the way says, and while the robot is led along it, what it comes
 * past. It stands below the picture, not on it, and on a phone at the foot of the window, where it is seen from each slider. */
export function CrossingAlert() {
  const { timeline, study, posing } = useStore();
  const [seen, proof, shown] = [timeline.crossing.value, timeline.proof.value, study.value];
  const warned = posing.numbers.value?.verdict === "singular"; // the warning over the picture says why
  if (!shown || warned) return null;
  const met = timeline.met.value;
  const places = met ? [met] : timeline.known.value ? [] : (proof?.places ?? []);
  if (!seen && places.length === 0) return null;
  const last = places.at(-1);
  const between = seen && spanned(seen.from, seen.to, shown);
  const span = between ? `between ${between}` : "by the last move";
  const count = places.length === 1 ? "a singular pose" : `${places.length} singular poses`;
  return (
    <div class="crossed" role="alert" data-testid="crossed" data-proved={places.length > 0}>
      <Icon name="stop" size={16} />
      <p>
        {proof && last ? (
          <>
            <b>
              The way leads through {count}, proved{places.length > 1 ? "; the last" : ""} at {named(proof, last.parameter, shown)}.
            </b>{" "}
            <Prose text={last.words[1] ?? last.words[0] ?? ""} />
          </>
        ) : (
          seen && (
            <>
              <b>A singular pose was crossed</b> {span}: <Changed signs={seen.signs} />
            </>
          )
        )}
      </p>
      {last?.pose && (
        <button type="button" class="small" data-testid="crossed-go" onClick={() => timeline.lead(last.parameter)}>
          Go there
        </button>
      )}
      <button type="button" class="quiet tool" aria-label="Put this away" data-testid="crossed-close" onClick={() => timeline.acknowledge()}>
        <Icon name="close" size={14} />
      </button>
    </div>
  );
}

/** What a change of signs tells. */
function Changed({ signs }: { signs: readonly Sign[] }) {
  const named = signs.flatMap(({ statement }) => statement || []);
  if (named.length === 0) return <>the determinant of the undriven joints' screws has changed its sign.</>;
  return (
    <>
      on the way <Prose text={named.join("; and ")} />. A factor of the condition has changed its sign.
    </>
  );
}
