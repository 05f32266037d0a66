// The sheet: a plan of base and platform, one above the other. Points are placed, dragged and dropped on one another;
// legs are dragged from point to point. With the keyboard: arrows move a point, Delete takes it away, Enter joins.
import { useRef, useState } from "preact/hooks";
import type { Sketch, Vec3 } from "../../../protocol";
import { hull } from "../../lib/hull";
import { bodyOf, gridOf, legFault, merged, moved, placeOf, snapped, withLeg, without, withoutLeg, withPoint, type Body } from "./sketch";

export type Tool = Body | "leg" | "erase";

interface Props {
  sketch: Sketch;
  tool: Tool;
  /** Half the height of what is seen. */
  span: number;
  snap: boolean;
  height: number;
  selected: string | null;
  select(name: string | null): void;
  change(sketch: Sketch, key?: string): void;
  /** The end of a drag: what follows is a step of its own. */
  settle(): void;
  say(words: string | null): void;
}

type Drag =
  | { kind: "point"; name: string; far: boolean }
  | { kind: "leg"; from: string; to: [number, number] };

const REACH = 0.045; // of the span: what a pointer counts as upon a point

export function Sheet({ sketch, tool, span, snap, height, selected, select, change, settle, say }: Props) {
  const svg = useRef<SVGSVGElement>(null);
  const [drag, setDrag] = useState<Drag | null>(null);
  const [begun, begin] = useState<string | null>(null); // where a leg starts that is made by two clicks
  const step = gridOf(span);
  const unit = span / 250;
  const layer: Body = tool === "platform" ? "platform" : "base";

  const at = (event: PointerEvent): [number, number] => {
    const matrix = svg.current?.getScreenCTM();
    if (!matrix) return [0, 0];
    const { x, y } = new DOMPoint(event.clientX, event.clientY).matrixTransform(matrix.inverse());
    return [x, -y];
  };
  const placed = (x: number, y: number): [number, number] =>
    snap ? [snapped(x, step), snapped(y, step)] : [Number(x.toPrecision(5)), Number(y.toPrecision(5))];

  /** The nearest point within reach, of the layer that is being drawn first. */
  function under([x, y]: readonly [number, number], but: string | null = null, only: Body | null = null): string | null {
    const near = Object.entries(sketch.points)
      .map(([name, p]) => ({ name, far: Math.hypot(p[0] - x, p[1] - y), other: bodyOf(sketch, name) !== layer }))
      .filter(({ name, far }) => far < REACH * span * 1.3 && name !== but && (!only || bodyOf(sketch, name) === only))
      .sort((a, b) => Number(a.other) - Number(b.other) || a.far - b.far);
    return near[0]?.name ?? null;
  }

  function join(a: string, b: string): void {
    const fault = legFault(sketch, a, b);
    say(fault);
    if (!fault) change(withLeg(sketch, a, b));
  }

  function down(event: PointerEvent): void {
    if (event.button !== 0) return;
    const here = at(event);
    const name = under(here);
    say(null);
    if (tool === "erase") return erase(name, event);
    if (name === null && tool === "leg") return begin(null);
    svg.current?.setPointerCapture(event.pointerId);
    if (name === null) {
      const [x, y] = placed(...here);
      change(withPoint(sketch, layer, [x, y, layer === "platform" ? height : 0]));
      return select(null);
    }
    select(name);
    setDrag(tool === "leg" ? { kind: "leg", from: name, to: here } : { kind: "point", name, far: false });
  }

  function erase(name: string | null, event: PointerEvent): void {
    if (name) return change(without(sketch, name));
    const leg = event.target instanceof Element ? event.target.getAttribute("data-index") : null;
    if (leg !== null) change(withoutLeg(sketch, Number(leg)));
  }

  function move(event: PointerEvent): void {
    if (!drag) return;
    const here = at(event);
    if (drag.kind === "leg") return setDrag({ ...drag, to: here });
    const [x, y] = placed(...here);
    const [x0, y0, z] = placeOf(sketch, drag.name);
    if (x === x0 && y === y0) return;
    setDrag({ ...drag, far: true });
    change(moved(sketch, drag.name, [x, y, z]), "sheet");
  }

  function up(event: PointerEvent): void {
    const here = at(event);
    const now = drag;
    setDrag(null);
    if (now?.kind === "point") {
      const into = now.far ? under(here, now.name, bodyOf(sketch, now.name)) : null;
      if (into) {
        change(merged(sketch, now.name, into), "sheet");
        select(into);
        say(`${now.name} was merged into ${into}: their legs meet there.`);
      }
      settle();
    } else if (now) {
      const to = under(here, now.from, bodyOf(sketch, now.from) === "base" ? "platform" : "base") ?? under(here);
      if (to && to !== now.from) {
        begin(null);
        join(now.from, to);
      } else if (to) twoClicks(to);
    }
  }

  function twoClicks(name: string): void {
    if (begun === null || begun === name) return begin(begun === name ? null : name);
    begin(null);
    join(begun, name);
  }

  function key(event: KeyboardEvent, name: string): void {
    const by = ({ ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] } as Record<string, [number, number]>)[event.key];
    if (by) {
      const [x, y, z] = placeOf(sketch, name);
      const far = event.shiftKey ? step / 10 : step;
      const to: Vec3 = [Number((x + by[0] * far).toPrecision(9)), Number((y + by[1] * far).toPrecision(9)), z];
      change(moved(sketch, name, to), `key-${name}`);
    } else if (event.key === "Delete" || event.key === "Backspace") change(without(sketch, name));
    else if (event.key === "Enter" || event.key === " ") twoClicks(name);
    else if (event.key === "Escape") begin(null);
    else return;
    event.preventDefault();
  }

  const dropped = drag?.kind === "point" ? mergesWith(sketch, drag.name, REACH * span) : null;
  const order = layer === "base" ? [...sketch.platform, ...sketch.base] : [...sketch.base, ...sketch.platform];
  return (
    <svg
      ref={svg}
      class={`sheet tool-${tool}`}
      viewBox={`${-1.2 * span} ${-span} ${2.4 * span} ${2 * span}`}
      role="group"
      aria-label="Plan of the robot. Every point can be moved with the arrow keys; Enter on two points joins them by a leg."
      data-testid="sheet"
      onPointerDown={down}
      onPointerMove={move}
      onPointerUp={up}
      onPointerCancel={() => setDrag(null)}
    >
      <defs>
        <pattern id="grid-fine" width={step} height={step} patternUnits="userSpaceOnUse">
          <path d={`M${step} 0H0V${step}`} class="grid-line" />
        </pattern>
      </defs>
      <rect class="ground" x={-8 * span} y={-8 * span} width={16 * span} height={16 * span} fill="url(#grid-fine)" />
      <path class="axes" d={`M${-8 * span} 0H${8 * span}M0 ${-8 * span}V${8 * span}`} />
      {(["base", "platform"] as const).map((body) => (
        <Outline key={body} sketch={sketch} body={body} />
      ))}
      {sketch.legs.map(([a, b], i) => {
        const [p, q] = [placeOf(sketch, a), placeOf(sketch, b)];
        const ends = { x1: p[0], y1: -p[1], x2: q[0], y2: -q[1] };
        return (
          <g key={`${a} ${b}`} class={selected === a || selected === b ? "leg lit" : "leg"}>
            <line {...ends} />
            <line {...ends} class="hit" data-index={i} />
          </g>
        );
      })}
      {drag?.kind === "leg" && (
        <line
          class="leg-drawn"
          x1={placeOf(sketch, drag.from)[0]}
          y1={-placeOf(sketch, drag.from)[1]}
          x2={drag.to[0]}
          y2={-drag.to[1]}
        />
      )}
      {order.map((name) => {
        const [x, y] = placeOf(sketch, name);
        const body = bodyOf(sketch, name) ?? "base";
        const state = [name === selected && "selected", name === begun && "begun", name === dropped && "target"].filter(Boolean);
        return (
          <g
            key={name}
            class={`joint ${body} ${state.join(" ")}${body === layer || tool === "leg" || tool === "erase" ? "" : " behind"}`}
            transform={`translate(${x} ${-y}) scale(${unit})`}
            tabIndex={0}
            role="button"
            aria-label={`${body} point ${name} at ${x}, ${y}`}
            data-testid={`sheet-${name}`}
            onFocus={() => select(name)}
            onKeyDown={(event) => key(event, name)}
          >
            <circle class="halo" r="15" />
            <circle class="dot" r="6.5" />
            <text x={body === "base" ? -15 : 15} y={body === "base" ? 17 : -9} text-anchor={body === "base" ? "end" : "start"}>
              {name}
            </text>
          </g>
        );
      })}
    </svg>
  );
}

/** The point that this one would be merged with if it were dropped now. */
function mergesWith(sketch: Sketch, name: string, reach: number): string | null {
  const [x, y] = placeOf(sketch, name);
  const body = bodyOf(sketch, name);
  const near = Object.entries(sketch.points).find(
    ([other, p]) => other !== name && bodyOf(sketch, other) === body && Math.hypot(p[0] - x, p[1] - y) < reach,
  );
  return near?.[0] ?? null;
}

/** The bodies as the hull of their points. */
function Outline({ sketch, body }: { sketch: Sketch; body: Body }) {
  const corners = hull(sketch[body].map((name): [number, number] => [placeOf(sketch, name)[0], placeOf(sketch, name)[1]]));
  return corners.length < 2 ? null : <polygon class={`body-outline ${body}`} points={corners.map(([x, y]) => `${x},${-y}`).join(" ")} />;
}
