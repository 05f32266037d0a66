// The map as a picture: what stands under the pointer is said, and a click takes the robot there.
import { useSignal } from "@preact/signals";
import type { CellStatus, MapAnswer, MapArgs, Measure, Pose } from "../../../protocol";
import { short } from "../../lib/format";
import { CertificateButton } from "../../parts/certificate-button";
import { useStore } from "../../parts/context";
import { FaultBox } from "../../parts/fault-box";
import { MARGIN, samePose } from "../../state/doc";
import { spoken } from "../../state/touring";
import { Facts } from "./facts";
import { CELLS, FRAME, MapLegend, MapPicture } from "./map-picture";
import { Plot, type Spot } from "./plot";
import { partOf, stepped, valueOf, within } from "./spots";

interface Props {
  asked: MapArgs;
  result: MapAnswer;
  measures: readonly Measure[];
  /** Draws the map anew, around where the robot is. */
  again(): void;
}

export function MapResult({ asked, result, measures, again }: Props) {
  const { touring, moving, pose$ } = useStore();
  const hovered = useSignal<Spot | null>(null);
  const chosen = useSignal<Spot | null>(null);
  const led = useSignal<Pose | null>(null); // where the robot was taken from the map
  const { axes, fixed, guarantee } = result;
  const going = touring.place.now.value;
  const mark = marked();
  const spot = hovered.value ?? mark;
  const here = touring.here.value;
  const elsewhere = here !== null && here.fixed !== fixed;

  /** The chosen place, unless the robot was taken there and has left it since; keys ask anew, they outrun pictures. */
  function marked(): Spot | null {
    const left = led.value !== null && !moving.active.value && !samePose(led.value, pose$.value);
    return left ? null : chosen.value;
  }

  function choose(at: Spot): void {
    chosen.value = at;
    led.value = null;
  }

  function key(event: KeyboardEvent): void {
    const by = STEPS[event.key];
    const from = marked();
    hovered.value = null;
    if (by) choose(stepped(from ?? [0.5, 0.5], by, result.margin));
    else if (event.key === "Enter" && from) void go(from);
    else return;
    event.preventDefault();
  }

  async function go(at: Spot): Promise<void> {
    const { source, over, pose } = asked;
    const place = axes.map((axis, i) => valueOf(axis, at[i as 0 | 1])) as [number, number];
    const found = await touring.place.start({ source, over, pose, place });
    if (!found) return;
    led.value = found.pose;
    moving.to(found.pose);
  }

  return (
    <div class="answer">
      <p class="guarantee" data-testid="map-guarantee">
        {guarantee}
      </p>
      <Plot
        frame={FRAME}
        picture={<MapPicture result={result} />}
        testid="map-plot"
        label="A place of the map: the arrow keys choose it, Enter takes the robot there"
        onKey={key}
        onHover={(at) => (hovered.value = at)}
        onPress={choose}
        onRelease={() => chosen.value && void go(chosen.value)}
      >
        {here && <Robot axes={axes} at={here.at} elsewhere={elsewhere} />}
        {mark && <span class="here" style={{ left: `${100 * mark[0]}%`, bottom: `${100 * mark[1]}%` }} />}
      </Plot>
      {fixed && (
        <p class="fixed" data-testid="map-fixed">
          Everywhere in this map: {fixed}.
        </p>
      )}
      {elsewhere && (
        <p class="elsewhere" data-testid="map-elsewhere">
          The robot is not in this map, as it stands at another place: {here.fixed}.{" "}
          <button type="button" data-testid="map-again" onClick={again}>
            Map where it is
          </button>
        </p>
      )}
      <MapLegend result={result} measure={spoken(asked.measure ?? MARGIN)} />
      <p class="readout" data-testid="map-readout" aria-live="polite">
        {spot ? <Spoken result={result} spot={spot} measure={measures.find(({ name }) => name === asked.measure)} /> : "Point at the map to read it; a click takes the robot there."}
      </p>
      {going.state === "failed" && <FaultBox fault={going.fault} />}
      <CertificateButton what="map" asked={asked} />
      <Facts facts={result.facts} title="What was computed" />
    </div>
  );
}

const [DIAMOND, ARROW] = ["M6 0L0 6L-6 0L0 -6Z", "M-1.5 0L-13.5 7L-10.5 0L-13.5 -7Z"]; // the arrow's tip lies at the edge

/** The robot's place, an arrow at the edge towards it where it is outside; hollow where the map is of other poses. */
function Robot({ axes, at, elsewhere }: { axes: MapAnswer["axes"]; at: readonly number[]; elsewhere: boolean }) {
  const parts = axes.map((axis, i) => partOf(axis, at[i] ?? 0));
  const inside = parts.map((part) => Math.min(Math.max(part, 0), 1));
  const [left, bottom] = inside.map((part) => `${100 * part}%`);
  const [right = 0, up = 0] = parts.map((part, i) => Math.sign(part - (inside[i] ?? part)));
  const outside = right !== 0 || up !== 0;
  const words = outside ? "The robot is outside this map" : elsewhere ? "The robot, which is not in this map" : "The robot";
  const turn = outside ? `${(Math.atan2(0 - up, right) * 180) / Math.PI}deg` : "0deg";
  const shape = outside ? ARROW : DIAMOND;
  return (
    <svg viewBox="-15 -15 30 30" class={elsewhere ? "robot elsewhere" : "robot"} role="img" aria-label={words} style={{ left, bottom, "--turn": turn }} data-testid="map-robot">
      <path class="rim" d={shape} />
      <path d={shape} />
    </svg>
  );
}

interface SpokenProps {
  result: MapAnswer;
  spot: Spot;
  measure: Measure | undefined;
}

function Spoken({ result, spot, measure }: SpokenProps) {
  const { axes, margin, index, status } = result;
  const [rows, columns] = [margin.length, margin[0]?.length ?? 0];
  const node = [Math.round(spot[0] * (rows - 1)), Math.round(spot[1] * (columns - 1))] as const;
  const cell = [within(spot[0], rows - 1), within(spot[1], columns - 1)] as const;
  const sigma = margin[node[0]]?.[node[1]] ?? null;
  const own = index[node[0]]?.[node[1]];
  const kind = status[cell[0]]?.[cell[1]] ?? "undecided";
  return (
    <>
      {axes.map((axis, i) => (
        <span key={axis.name}>
          {axis.name} <b>{short(valueOf(axis, spot[i as 0 | 1]), 4)}</b>
          {axis.unit === "deg" ? "°" : axis.unit && ` ${axis.unit}`} ·{" "}
        </span>
      ))}
      σ <b>{sigma === null ? "none" : short(sigma, 3)}</b>
      {measure && own !== undefined && (
        <>
          , {spoken(measure.name)} <b>{own === null ? "none" : short(own, 3)}</b> {measure.unit}
        </>
      )}{" "}
      at the nearest node · the cell is <b class={kind}>{CELLS[kind as CellStatus]}</b>
    </>
  );
}

const STEPS: Readonly<Record<string, Spot>> = { ArrowRight: [1, 0], ArrowLeft: [-1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
