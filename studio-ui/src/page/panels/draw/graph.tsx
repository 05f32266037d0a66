// The legs as a graph, drawn at once: platform joints above, base joints below.
import type { Sketch } from "../../../protocol";
import { sideBySide } from "../../../viewer/names";

const [GAP, ROWS, MARGIN] = [48, 84, 26];

export function Graph({ sketch, selected }: { sketch: Sketch; selected: string | null }) {
  const { base, legs } = sketch;
  const upper = arranged(sketch);
  const width = GAP * Math.max(base.length, upper.length, 4) + MARGIN;
  const at = new Map<string, [number, number]>();
  [upper, base].forEach((row, r) =>
    row.forEach((name, i) => at.set(name, [((i + 0.5) * (width - MARGIN)) / row.length + MARGIN / 2, MARGIN + r * ROWS])),
  );
  const place = (name: string): [number, number] => at.get(name) ?? [0, 0];
  return (
    <div class="schematic" data-testid="draw-schematic">
      <svg class="schematic" viewBox={`0 0 ${width} ${ROWS + 2 * MARGIN}`} role="img" aria-label={`${legs.length} legs: ${legs.map(sideBySide).join(", ")}`}>
        {legs.map(([a, b]) => (
          <line
            key={`${a} ${b}`}
            class={selected === a || selected === b ? "leg lit" : "leg"}
            x1={place(a)[0]}
            y1={place(a)[1]}
            x2={place(b)[0]}
            y2={place(b)[1]}
          />
        ))}
        {[...at].map(([name, [x, y]]) => (
          <g key={name} class={`joint ${base.includes(name) ? "base" : "platform"}`}>
            <circle cx={x} cy={y} r="5" />
            <text x={x} y={base.includes(name) ? y + 20 : y - 11} text-anchor="middle">
              {name}
            </text>
          </g>
        ))}
      </svg>
    </div>
  );
}

/** Platform joints in the sequence of the middles of their base joints, so that few legs cross. */
function arranged({ base, platform, legs }: Sketch): string[] {
  const middle = (name: string): number => {
    const ends = legs.filter((leg) => leg.includes(name)).map(([a, b]) => base.indexOf(a === name ? b : a));
    return ends.length === 0 ? base.length : ends.reduce((sum, i) => sum + i, 0) / ends.length;
  };
  return [...platform].sort((a, b) => middle(a) - middle(b));
}
