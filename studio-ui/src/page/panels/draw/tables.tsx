// Points and legs as tables: all that the sheet can do, in numbers.
import { useState } from "preact/hooks";
import type { Sketch, Vec3 } from "../../../protocol";
import { Icon } from "../../parts/icon";
import { NumberField } from "../../parts/number-field";
import { PointName } from "../../parts/point-name";
import { bodyOf, gridOf, legFault, moved, nameFault, placeOf, renamed, withLeg, without, withoutLeg, withPoint, type Body } from "./sketch";

interface Props {
  sketch: Sketch;
  span: number;
  height: number;
  selected: string | null;
  select(name: string | null): void;
  change(sketch: Sketch, key?: string): void;
  say(words: string | null): void;
}

const AXES = ["x", "y", "z"] as const;

export function Points({ sketch, span, height, selected, select, change, say }: Props) {
  const step = gridOf(span);

  function add(body: Body): void {
    const n = sketch[body].length;
    const turn = (2 * Math.PI * n) / 6 + (body === "base" ? 0 : Math.PI / 6);
    const far = span * (body === "base" ? 0.7 : 0.45);
    const round = (c: number) => Number((Math.round((c * far) / step) * step).toPrecision(9));
    change(withPoint(sketch, body, [round(Math.cos(turn)), round(Math.sin(turn)), body === "base" ? 0 : height]));
  }

  return (
    <section class="draw-points" aria-label="Points">
      <table>
        <thead>
          <tr>
            <th scope="col">Point</th>
            {AXES.map((axis) => (
              <th scope="col" key={axis}>
                {axis}
              </th>
            ))}
            <td />
          </tr>
        </thead>
        {(["platform", "base"] as const).map((body) => (
          <tbody key={body} class={body}>
            {sketch[body].map((name) => (
              <tr key={name} class={name === selected ? "selected" : ""} data-testid={`row-${name}`}>
                <th scope="row">
                  <Name sketch={sketch} name={name} change={change} select={select} say={say} />
                </th>
                {AXES.map((axis, i) => (
                  <td key={axis}>
                    <NumberField
                      value={placeOf(sketch, name)[i] ?? 0}
                      step={step}
                      digits={0}
                      label={`${axis} of ${name}`}
                      testid={`${axis}-${name}`}
                      onChange={(value) =>
                        change(moved(sketch, name, placeOf(sketch, name).map((c, j) => (j === i ? value : c)) as Vec3), `${axis}-${name}`)
                      }
                    />
                  </td>
                ))}
                <td>
                  <button type="button" class="quiet" aria-label={`Delete ${name}`} title="Delete" onClick={() => change(without(sketch, name))}>
                    <Icon name="close" size={13} />
                  </button>
                </td>
              </tr>
            ))}
          </tbody>
        ))}
      </table>
      <p class="add">
        <button type="button" onClick={() => add("base")} data-testid="add-base">
          + Base point
        </button>
        <button type="button" onClick={() => add("platform")} data-testid="add-platform">
          + Platform point
        </button>
      </p>
    </section>
  );
}

function Name({ sketch, name, change, select, say }: Pick<Props, "sketch" | "change" | "select" | "say"> & { name: string }) {
  const [text, type] = useState<string | null>(null);
  function take(): void {
    if (text === null) return;
    const to = text.trim();
    type(null);
    if (to === name) return;
    const fault = nameFault(sketch, name, to);
    say(fault);
    if (fault) return;
    change(renamed(sketch, name, to));
    select(to);
  }
  return (
    <>
      <span class={`dot ${bodyOf(sketch, name) ?? ""}`} aria-hidden="true" />
      <input
        type="text"
        class="name"
        aria-label={`Name of point ${name}`}
        data-testid={`name-${name}`}
        value={text ?? name}
        onFocus={() => select(name)}
        onInput={(event) => type(event.currentTarget.value)}
        onBlur={take}
        onKeyDown={(event) => {
          if (event.key === "Enter") take();
          if (event.key === "Escape") type(null);
        }}
      />
    </>
  );
}

export function Legs({ sketch, change, say }: Pick<Props, "sketch" | "change" | "say">) {
  const [from, setFrom] = useState("");
  const [to, setTo] = useState("");
  const { base, platform, legs } = sketch;
  const a = base.includes(from) ? from : (base[0] ?? "");
  const b = platform.includes(to) ? to : (platform[0] ?? "");

  function add(): void {
    const fault = legFault(sketch, a, b);
    say(fault);
    if (!fault) change(withLeg(sketch, a, b));
  }

  return (
    <section class="draw-legs" aria-label="Legs">
      <ul data-testid="draw-legs">
        {legs.map(([p, q], i) => (
          <li key={`${p} ${q}`}>
            <span class="math">
              <PointName name={p} />
              <PointName name={q} />
            </span>
            <button type="button" class="quiet" aria-label={`Delete leg ${p} ${q}`} title="Delete" onClick={() => change(withoutLeg(sketch, i))}>
              <Icon name="close" size={12} />
            </button>
          </li>
        ))}
      </ul>
      {base.length > 0 && platform.length > 0 && (
        <p class="add">
          <select aria-label="Base end of the leg" value={a} onChange={(event) => setFrom(event.currentTarget.value)} data-testid="leg-from">
            {base.map((name) => (
              <option key={name}>{name}</option>
            ))}
          </select>
          <select aria-label="Platform end of the leg" value={b} onChange={(event) => setTo(event.currentTarget.value)} data-testid="leg-to">
            {platform.map((name) => (
              <option key={name}>{name}</option>
            ))}
          </select>
          <button type="button" onClick={add} data-testid="add-leg">
            + Leg
          </button>
        </p>
      )}
    </section>
  );
}
