// Points and legs by name, to be pointed at.
import type { Study } from "../../protocol";
import { useStore } from "../parts/context";
import { PointName } from "../parts/point-name";

export function PointList({ study }: { study: Study }) {
  const { lit } = useStore();
  const target = lit.current.value;
  const point = (name: string) => (
    <button
      type="button"
      key={name}
      class={target?.points.includes(name) ? "point lit" : "point"}
      data-point={name}
      aria-label={`point ${name}`}
    >
      <PointName name={name} />
    </button>
  );
  return (
    <dl class="bodies">
      <dt>Platform</dt>
      <dd>{study.platform.map(point)}</dd>
      <dt>Base</dt>
      <dd>{study.base.map(point)}</dd>
      <dt>Legs</dt>
      <dd>
        {study.legs.map(([a, b]) => (
          <button
            type="button"
            key={`${a} ${b}`}
            class={target?.kind === "leg" && target.points.join(" ") === `${a} ${b}` ? "point lit" : "point"}
            data-leg={`${a} ${b}`}
            aria-label={`leg ${a} ${b}`}
          >
            <PointName name={a} />
            <PointName name={b} />
          </button>
        ))}
      </dd>
    </dl>
  );
}
