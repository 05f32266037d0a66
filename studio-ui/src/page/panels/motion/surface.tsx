// The singular surface over x, y and z, drawn in the picture around the robot.
import { computed } from "@preact/signals";
import { useEffect, useMemo } from "preact/hooks";
import type { Study, SurfaceArgs, SurfaceAnswer, Vec3 } from "../../../protocol";
import { show } from "../../actions/picture";
import { short } from "../../lib/format";
import { useStore } from "../../parts/context";
import { FaultBox } from "../../parts/fault-box";
import { useSight } from "../../parts/sight";
import { Icon } from "../../parts/icon";
import { NumberField } from "../../parts/number-field";
import { digitsOf } from "../../pose/axis-slider";
import { Seeks } from "../../pose/nearest-view";
import { FINENESS, type Box } from "../../state/doc";
import { boxOf, finenessOf, isStale, nearestCorner } from "../../state/surfacing";
import { inWords } from "../../state/touring";
import { Facts } from "./facts";
import "./surface.css";

export function SurfaceSection({ study }: { study: Study }) {
  const { touring, doc, tour$ } = useStore();
  const { surface, change } = touring;
  const now = surface.now.value;
  const shown = surface.shown.value;
  const sight = useSight(shown !== null);
  const standard = boxOf(study);
  const box = standard && (tour$.value.box ?? standard);
  const nodes = tour$.value.fineness ?? finenessOf(study);
  useEffect(() => surface.stop, [surface]); // nobody looks any more

  function go(): void {
    const { source, pose } = doc.peek();
    if (!source || !box) return;
    void surface.start((n) => ({ source, pose, over: inAll(box, n) }), nodes);
  }

  return (
    <section class="surface" aria-label="Singular surface" ref={sight}>
      <h3>Over x, y and z: the singular surface</h3>
      {!box && <Instead study={study} />}
      {box && (
        <form
          class="ask"
          onSubmit={(event) => {
            event.preventDefault();
            go();
          }}
        >
          {box.map((range, i) => (
            <Span key={range.name} box={box} index={i} study={study} onChange={(changed) => change({ box: changed })} />
          ))}
          <div class="row">
            <label>
              <span class="label">poses</span>
              <select
                value={nodes}
                aria-label="Poses of the surface, along each coordinate"
                data-testid="surface-nodes"
                onChange={(event) => change({ fineness: Number(event.currentTarget.value) })}
              >
                {FINENESS.map((n) => (
                  <option key={n} value={n}>
                    {n}³
                  </option>
                ))}
              </select>
            </label>
            <button type="submit" class="primary" disabled={now.state === "busy"} data-testid="surface-go">
              <Icon name="layers" size={14} /> Surface in 3D
            </button>
          </div>
        </form>
      )}
      {now.state === "busy" && <Seeks words={now.words} stop={surface.stop} testid="surface-stop" />}
      {now.state === "failed" && <FaultBox fault={now.fault} />}
      {shown && <Answer study={study} asked={shown.asked} result={shown.result} again={go} />}
    </section>
  );
}

const inAll = ([x, y, z]: Box, n: number): SurfaceArgs["over"] => [inWords(x, "", n), inWords(y, "", n), inWords(z, "", n)];

/** What to do where the platform's place is not told by x, y and z. */
function Instead({ study }: { study: Study }) {
  const names = study.freedoms.map(({ name }) => name);
  const own = names.length > 0 ? `The freedoms of this robot are ${names.join(", ")}` : "The platform does not move in all of x, y and z";
  return (
    <p class="tip" data-testid="surface-instead">
      {own}: there is no surface over x, y and z. Use the map over two of them above; it shows the singular poses as curves.
    </p>
  );
}

interface SpanProps {
  box: Box;
  index: number;
  study: Study;
  onChange(box: Box): void;
}

function Span({ box, index, study, onChange }: SpanProps) {
  const range = box[index]!;
  const axis = study.ranges.find(({ name }) => name === range.name);
  const step = (axis?.step ?? 0.01) * 10;
  const change = (part: { low?: number; high?: number }) =>
    onChange(box.map((one, i) => (i === index ? { ...one, ...part } : one)) as Box);
  return (
    <div class="row">
      <span class="label">{range.name}</span>
      {(["low", "high"] as const).map((end) => (
        <>
          {end === "high" && <span>to</span>}
          <NumberField
            key={end}
            value={range[end]}
            step={step}
            digits={digitsOf(step)}
            label={`${range.name} of the surface ${end === "low" ? "from" : "to"}`}
            testid={`surface-${end}-${range.name}`}
            onChange={(value) => change({ [end]: value })}
          />
        </>
      ))}
      <span class="unit">{axis?.unit}</span>
    </div>
  );
}

interface AnswerProps {
  study: Study;
  asked: SurfaceArgs;
  result: SurfaceAnswer;
  again(): void;
}

function Answer({ study, asked, result, again }: AnswerProps) {
  const store = useStore();
  const { touring, moving, posing, pose$, space } = store;
  const { free, cells, nodes, guarantee, resolution, facts } = result;
  const stale = useMemo(
    () => computed(() => isStale({ asked, result }, pose$.value, posing.numbers.value, study)),
    [asked, result, study],
  ).value;
  const drawn = result.faces.length > 0;
  const going = touring.place.now.value;

  async function toward(): Promise<void> {
    const at = (study.kind === "robot" ? posing.numbers.peek()?.platform : pose$.peek())?.translation ?? [0, 0, 0];
    const place = nearestCorner(result, at as Vec3);
    const found = place && (await touring.place.start({ source: asked.source, over: asked.over, pose: asked.pose, place }));
    if (found) moving.to(found.pose);
  }

  return (
    <div class="answer">
      <p class="guarantee" data-testid="surface-guarantee">
        {guarantee}
      </p>
      <p class="reason" data-testid="surface-share" aria-live="polite">
        <b>{short((100 * free) / Math.max(cells, 1), 3)} %</b> of {cells.toLocaleString("en")} cells ({nodes.map((n) => n - 1).join(" × ")}) are proved
        free. {resolution}
      </p>
      {drawn && (
        <div class="surface-tools">
          <label>
            <input
              type="checkbox"
              checked={space.layers.value.surface}
              data-testid="surface-shown"
              onChange={(event) => show(store, "surface", event.currentTarget.checked)}
            />
            <i class={stale ? "swatch stale" : "swatch"} aria-hidden="true" /> Shown in the picture
          </label>
          <button type="button" class="second" disabled={stale || going.state === "busy"} onClick={() => void toward()} data-testid="surface-nearest">
            <Icon name="target" size={14} /> Go to its nearest corner
          </button>
        </div>
      )}
      {result.reached.includes(false) && <p class="tip">Grey parts of the surface are beyond the limits of the robot.</p>}
      {stale && (
        <p class="outdated" role="status" data-testid="surface-stale">
          <Icon name="warn" size={16} />
          <span>The platform has turned since: the surface, now grey, holds for the turn that was asked about.</span>
          <button type="button" class="second" onClick={again} data-testid="surface-again">
            Work it out here
          </button>
        </p>
      )}
      {going.state === "failed" && <FaultBox fault={going.fault} />}
      <Facts facts={facts} title="What was computed for the surface" />
    </div>
  );
}
