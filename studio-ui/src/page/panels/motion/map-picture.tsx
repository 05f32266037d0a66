// The picture of a map: cells are coloured by what is proved of them, free ones the deeper the larger the measure; singular
// curves on top.
import { useEffect, useRef } from "preact/hooks";
import type { Axis, CellStatus, Frame, MapAnswer } from "../../../protocol";
import { short } from "../../lib/format";
import { useStore } from "../../parts/context";
import { extent, partOf, shades, ticks } from "./spots";
import "./map-picture.css";

export const FRAME: Frame = { left: 0.115, right: 0.985, top: 0.02, bottom: 0.875 };

export const CELLS: Readonly<Record<CellStatus, string>> = {
  free: "proved free of singular poses",
  crossed: "crossed by singular poses",
  undecided: "not decided",
  outside: "not followed to a corner",
};

const PALE = 0.16; // how deep the colour of the least measure is

export function MapPicture({ result }: { result: MapAnswer }) {
  const { axes, curves } = result;
  const [across, upwards] = axes;
  if (!across || !upwards) return null;
  const path = (points: readonly (readonly number[])[]) =>
    points.map(([x = 0, y = 0], i) => `${i ? "L" : "M"}${partOf(across, x)} ${1 - partOf(upwards, y)}`).join("");
  return (
    <div class="map-picture" role="img" aria-label={`Map over ${across.name} and ${upwards.name}`} data-testid="map-picture">
      <div class="field" style={{ inset: insetOf(FRAME) }}>
        <Cells result={result} />
        <svg viewBox="0 0 1 1" preserveAspectRatio="none" aria-hidden="true">
          {curves.map(({ points, reached }, i) => (
            <path key={i} d={path(points)} class={reached ? "curve" : "curve beyond"} />
          ))}
        </svg>
      </div>
      <Ticks axis={across} upright={false} />
      <Ticks axis={upwards} upright />
    </div>
  );
}

const insetOf = ({ left, right, top, bottom }: Frame) =>
  [top, 1 - right, 1 - bottom, left].map((part) => `${100 * part}%`).join(" ");

function Cells({ result }: { result: MapAnswer }) {
  const { theme } = useStore().taste;
  const canvas = useRef<HTMLCanvasElement>(null);
  const dark = theme.value;
  const { status } = result;
  const [columns, rows] = [status.length, status[0]?.length ?? 0];
  useEffect(() => {
    const brush = canvas.current?.getContext("2d");
    if (!brush || !canvas.current) return;
    const style = getComputedStyle(canvas.current);
    const depth = shades(result);
    brush.clearRect(0, 0, columns, rows);
    status.forEach((column, i) =>
      column.forEach((kind, j) => {
        brush.fillStyle = style.getPropertyValue(`--cell-${kind}`);
        brush.globalAlpha = kind === "free" ? PALE + (1 - PALE) * (depth[i]?.[j] ?? 0) : 1;
        brush.fillRect(i, rows - 1 - j, 1, 1);
      }),
    );
  }, [result, dark]);
  return <canvas ref={canvas} width={columns} height={rows} aria-hidden="true" />;
}

function Ticks({ axis, upright }: { axis: Axis; upright: boolean }) {
  const size = upright ? FRAME.bottom - FRAME.top : FRAME.right - FRAME.left;
  const place = (part: number) =>
    upright ? { top: `${100 * (FRAME.bottom - part * size)}%` } : { left: `${100 * (FRAME.left + part * size)}%` };
  const unit = axis.unit === "deg" ? "°" : axis.unit;
  return (
    <div class={upright ? "ticks upright" : "ticks"} aria-hidden="true">
      {ticks(axis).map((value) => (
        <span key={value} style={place(partOf(axis, value))}>
          {short(value, 4)}
        </span>
      ))}
      <b>{unit ? `${axis.name} (${unit})` : axis.name}</b>
    </div>
  );
}

export function MapLegend({ result, measure }: { result: MapAnswer; measure: string }) {
  const kinds = (Object.keys(CELLS) as CellStatus[]).filter((kind) => result.status.some((row) => row.includes(kind)));
  const [least, most] = extent(result);
  return (
    <ul class="map-legend" aria-label="Legend" data-testid="map-legend">
      {result.curves.length > 0 && (
        <li>
          <i class="curve" /> singular
        </li>
      )}
      {result.curves.some(({ reached }) => !reached) && (
        <li>
          <i class="curve beyond" /> singular, beyond the limits
        </li>
      )}
      {kinds.map((kind) => (
        <li key={kind}>
          <i class={kind} /> {CELLS[kind]}
        </li>
      ))}
      <li>
        <i class="robot" /> the robot
      </li>
      <li>
        <i class="ramp" /> {measure} from {short(least, 3)} to {short(most, 3)}
      </li>
    </ul>
  );
}
