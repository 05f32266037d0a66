// A plan of the joints, seen along one axis of the file's frame: dragged, or moved with the arrow keys.
import { useRef, useState } from "preact/hooks";
import type { Study } from "../../../protocol";
import { hull } from "../../lib/hull";
import { useStore } from "../../parts/context";
import { Tabs } from "../../parts/tabs";
import { jointWords, onGrid, placeOf, pointsOf, stepOf, written } from "../../state/joint-places";
import { planLabels, SHEET, type Named } from "./plan-labels";

const VIEWS = [
  { id: "top", label: "From above", title: "x to the right, y upwards", axes: [0, 1] },
  { id: "front", label: "From the front", title: "x to the right, z upwards", axes: [0, 2] },
  { id: "side", label: "From the side", title: "y to the right, z upwards", axes: [1, 2] },
] as const;
type View = (typeof VIEWS)[number]["id"];

interface Props {
  study: Study;
  selected: string | null;
  select(name: string | null): void;
}

interface Window {
  x: number;
  y: number;
  half: number;
}

export function Plan({ study, selected, select }: Props) {
  const { resizing } = useStore();
  const svg = useRef<SVGSVGElement>(null);
  const [view, look] = useState<View>("top");
  const [dragged, drag] = useState<{ name: string; window: Window } | null>(null);
  const wanted = resizing.wanted.value;
  const [right, up] = VIEWS.find(({ id }) => id === view)!.axes;
  const flat = (name: string): [number, number] => {
    const at = placeOf(study, wanted, name);
    return [at[right], at[up]];
  };
  const rows = pointsOf(study).filter(({ name, at }) => at ?? study.points[name]);
  const names = rows.map(({ name }) => name);
  const { x, y, half } = dragged?.window ?? windowOf(names.map(flat)); // the picture stays still under the hand
  const step = stepOf(study);
  const round = (value: number): number => onGrid(value, step);
  const unit = (2 * half) / SHEET.height;
  const onSheet = ([p, q]: readonly [number, number]): [number, number] => [(p - x) / unit + SHEET.width / 2, (y - q) / unit + SHEET.height / 2];
  const joints = rows.map(({ name }): Named => ({ name, at: onSheet(flat(name)), body: bodyOf(study, name), selected: name === selected }));
  const labels = planLabels(
    joints,
    study.shape.bars.map(([a, b]) => [onSheet(flat(a)), onSheet(flat(b))]),
  );

  function move(name: string, to: readonly [number, number]): void {
    const [a, b] = [written(right, to[0]), written(up, to[1])];
    resizing.move(name, [a[0] ?? b[0], a[1] ?? b[1], a[2] ?? b[2]]);
  }

  function drop(): void {
    if (dragged) resizing.done();
    drag(null);
  }

  function key(event: KeyboardEvent, name: string): void {
    const by = ({ ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] } as Record<string, [number, number]>)[event.key];
    if (!by) return;
    event.preventDefault();
    const far = event.shiftKey ? 10 * step : step;
    const [p, q] = flat(name);
    move(name, [Number((p + by[0] * far).toPrecision(12)), Number((q + by[1] * far).toPrecision(12))]);
    resizing.done();
  }

  function follow(event: PointerEvent): void {
    const matrix = svg.current?.getScreenCTM();
    if (!dragged || !matrix) return;
    const spot = new DOMPoint(event.clientX, event.clientY).matrixTransform(matrix.inverse());
    const to: [number, number] = [round(spot.x), round(-spot.y)];
    const [p, q] = flat(dragged.name);
    if (to[0] !== p || to[1] !== q) move(dragged.name, to);
  }

  return (
    <div class="plan">
      {study.shape.groups.some(({ axes }) => axes.length === 3) && (
        <Tabs<View> name="View of the joints" tabs={VIEWS.map((one) => ({ ...one, testid: `plan-${one.id}` }))} current={view} onChoose={look} />
      )}
      <svg
        ref={svg}
        class="plan-sheet"
        viewBox={`${x - (unit * SHEET.width) / 2} ${-y - half} ${unit * SHEET.width} ${2 * half}`}
        role="group"
        aria-label="Plan of the joints. Each can be moved with the arrow keys, ten times as far with Shift."
        data-testid="plan"
        onPointerMove={follow}
        onPointerUp={drop}
        onPointerCancel={drop}
      >
        {(["base", "platform"] as const).map((body) => {
          const corners = hull(study[body].map(flat));
          return corners.length > 1 && <polygon key={body} class={`outline ${body}`} points={corners.map(([p, q]) => `${p},${-q}`).join(" ")} />;
        })}
        {study.shape.bars.map(([a, b]) => {
          const [p, q] = [flat(a), flat(b)];
          return <line key={`${a} ${b}`} class={selected === a || selected === b ? "leg lit" : "leg"} x1={p[0]} y1={-p[1]} x2={q[0]} y2={-q[1]} />;
        })}
        {rows.map(({ name, at }, i) => {
          const [p, q] = flat(name);
          const { body } = joints[i]!;
          const label = labels[i];
          const place = `translate(${p} ${-q}) scale(${unit})`;
          const dot = (
            <>
              <circle class="dot" r={SHEET.dot} />
              {label && (
                <text x={label.by[0]} y={label.by[1]} text-anchor="middle" dominant-baseline="central">
                  {label.text}
                </text>
              )}
            </>
          );
          if (!at)
            return (
              <g key={name} class={`joint ${body} determined`} transform={place}>
                {dot}
              </g>
            );
          return (
            <g
              key={name}
              class={`joint ${body}${name === selected ? " selected" : ""}`}
              transform={place}
              tabIndex={0}
              role="button"
              aria-label={jointWords(study, name)}
              data-testid={`plan-${name}`}
              onFocus={() => select(name)}
              onKeyDown={(event) => key(event, name)}
              onPointerDown={(event) => {
                if (event.button !== 0) return;
                svg.current?.setPointerCapture(event.pointerId);
                select(name);
                drag({ name, window: { x, y, half } });
              }}
            >
              <circle class="halo" r="13" />
              {dot}
            </g>
          );
        })}
      </svg>
    </div>
  );
}

const bodyOf = (study: Study, name: string): Named["body"] =>
  study.base.includes(name) ? "base" : study.platform.includes(name) ? "platform" : "limb";

function windowOf(places: readonly (readonly [number, number])[]): Window {
  const [xs, ys] = [places.map(([p]) => p), places.map(([, q]) => q)];
  const [left, right, low, high] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
  return { x: (left + right) / 2, y: (low + high) / 2, half: 0.66 * Math.max((right - left) / 1.4, high - low) || 1 };
}
