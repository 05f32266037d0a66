// Another robot beside the one on show: its picture in the same pose, and both robots' numbers side by side.
import { useSignalEffect } from "@preact/signals";
import { useEffect } from "preact/hooks";
import type { Numbers, Source, Study, Verdict } from "../../../protocol";
import { short } from "../../lib/format";
import { useStore } from "../../parts/context";
import { FaultBox } from "../../parts/fault-box";
import { Icon } from "../../parts/icon";
import { inSight } from "../../parts/in-sight";
import { useSmallViewer } from "../../parts/small-viewer";
import type { Other } from "../../state/comparing";
import { posedPart, sceneOf } from "../../state/scene";

const WORDS: Record<Verdict, string> = { regular: "regular", close: "close to singular", singular: "singular" };

export function Comparison({ study }: { study: Study }) {
  const { comparing, posing } = useStore();
  const [other, numbers] = [comparing.other.value, comparing.numbers.value];
  const place = !comparing.together.value ? "at its home" : study.kind === "platform" ? "in the same pose" : "its actuators as far from home";
  return (
    <section class="comparison" aria-label="Side by side">
      <header>
        <h3>Side by side</h3>
        {other && (
          <span class="buttons">
            <button type="button" onClick={comparing.swap} data-testid="beside-swap">
              Change places
            </button>
            <button type="button" class="tool" aria-label="Close the other robot" title="Close it" onClick={comparing.close} data-testid="beside-close">
              <Icon name="close" size={16} />
            </button>
          </span>
        )}
      </header>
      <Choice />
      {comparing.fault.value && <FaultBox fault={comparing.fault.value} />}
      {other && (
        <>
          <Picture other={other} numbers={numbers} label={`${other.name}, ${place}`} />
          <p class="tip">
            {other.name}, {place}
            {comparing.together.value ? "." : ": its poses are not those of this robot."}
          </p>
          <div class="scrolled">
            <table class="readings beside" data-testid="beside">
              <thead>
                <tr>
                  <td />
                  <th scope="col">{study.title}</th>
                  <th scope="col">{other.name}</th>
                </tr>
              </thead>
              <tbody>
                {rowsOf(posing.numbers.value, numbers).map(([key, a, b]) => (
                  <tr key={key}>
                    <th scope="row">{key}</th>
                    <td>{a}</td>
                    <td>{b}</td>
                  </tr>
                ))}
              </tbody>
            </table>
          </div>
        </>
      )}
    </section>
  );
}

/** The other robot, looked at from where the one on show is. */
function Picture({ other, numbers, label }: { other: Other; numbers: Numbers | null; label: string }) {
  const { space } = useStore();
  const { box, viewer } = useSmallViewer();
  useEffect(() => viewer.current?.show(sceneOf(other.study)), [other]);
  useEffect(() => {
    const [shown, picture] = [viewer.current, box.current];
    if (!numbers || !shown || !picture) return;
    shown.update(posedPart(numbers, true));
    shown.whole(); // links come with the first numbers
    if (!inSight(shown, picture, other.study.platform)) shown.setView("fit");
  }, [other, numbers]);
  useSignalEffect(() => {
    if (space.from.value) viewer.current?.lookFrom(space.from.value);
  });
  return <div class="mini-viewer" ref={box} role="group" aria-label={label} data-testid="beside-picture" />;
}

type Row = readonly [string, string, string];

/** What both can say; a quantity that only one has stands alone. */
function rowsOf(mine: Numbers | null, theirs: Numbers | null): Row[] {
  const both = [mine, theirs];
  const row = (key: string, of: (numbers: Numbers) => string): Row => [key, ...(both.map((n) => (n ? of(n) : "…")) as [string, string])];
  const keys = [...new Set(both.flatMap((n) => n?.jacobian.map(({ key }) => key) ?? []))];
  return [
    row("verdict", ({ verdict }) => WORDS[verdict]),
    row("margin σ", ({ margin }) => short(margin)),
    ...(both.some((n) => n && onLegs(n)) ? [row("leg lengths", (n) => (onLegs(n) ? spread(n) : "–"))] : []),
    ...(both.some((n) => n && !onLegs(n)) ? [row("actuators, from home", (n) => (onLegs(n) ? "–" : spread(n)))] : []),
    ...keys.map((key) => row(key, ({ jacobian }) => jacobian.find((fact) => fact.key === key)?.value ?? "–")),
  ];
}

/** The actuators of six legs are told by their lengths, others by how far they are from home. */
const onLegs = ({ platform }: Numbers): boolean => platform === null;

/** From the least to the greatest, and what is beyond its limits. */
function spread({ actuators }: Numbers): string {
  const units = new Set(actuators.map(({ unit }) => unit));
  const unit = units.size === 1 ? [...units][0] : null;
  if (actuators.length === 0 || unit == null) return "–";
  const values = actuators.map(({ value }) => value);
  const beyond = actuators.filter(({ low, high, value }) => (low !== null && value < low) || (high !== null && value > high)).length;
  const range = `${short(Math.min(...values))} to ${short(Math.max(...values))} ${unit === "deg" ? "°" : unit}`.trim();
  return beyond > 0 ? `${range}, ${beyond} beyond limits` : range;
}

function Choice() {
  const { comparing, projecting, gallery, source$ } = useStore();
  const kept = projecting.project.value.robots.map(({ name, state }) => ({ name, source: state.source }));
  const shown = gallery.value;
  const groups: readonly (readonly [string, readonly { name: string; source: Source | null }[]])[] = [
    ["The project", kept],
    ["Examples", (shown?.examples ?? []).map(({ title, source }) => ({ name: title, source }))],
    ["Robots", (shown?.robots ?? []).map(({ title, source }) => ({ name: title, source }))],
  ];
  const all = groups.flatMap(([, list]) => list);
  return (
    <div class="choice">
      <button type="button" onClick={comparing.keep} disabled={!source$.value} data-testid="beside-keep">
        This robot as it is now
      </button>
      <select
        aria-label="Another robot beside it"
        data-testid="beside-choose"
        value=""
        onChange={(event) => {
          const robot = all[Number(event.currentTarget.value)];
          event.currentTarget.value = "";
          if (robot?.source) comparing.choose(robot.name, robot.source);
        }}
      >
        <option value="">or another one …</option>
        {groups.map(
          ([label, list]) =>
            list.length > 0 && (
              <optgroup key={label} label={label}>
                {list.map((one) => (
                  <option key={all.indexOf(one)} value={all.indexOf(one)} disabled={!one.source}>
                    {one.name}
                  </option>
                ))}
              </optgroup>
            ),
        )}
      </select>
    </div>
  );
}
