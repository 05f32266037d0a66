// The coordinates of all joints as a table.
import type { Study } from "../../../protocol";
import { useStore } from "../../parts/context";
import { NumberField } from "../../parts/number-field";
import { PointName } from "../../parts/point-name";
import { placeOf, stepOf, written } from "../../state/joint-places";

const AXES = ["x", "y", "z"] as const;

interface Props {
  study: Study;
  selected: string | null;
  select(name: string | null): void;
}

export function Coordinates({ study, selected, select }: Props) {
  const { resizing } = useStore();
  const wanted = resizing.wanted.value;
  const step = stepOf(study);
  const digits = Math.max(0, -Math.floor(Math.log10(step)));
  return (
    <div class="scrolled">
      <table class="coordinates" data-testid="coordinates">
        <thead>
          <tr>
            <th scope="col">Joint</th>
            {AXES.map((axis) => (
              <th scope="col" key={axis}>
                {axis} {study.unit && <small>{study.unit}</small>}
              </th>
            ))}
          </tr>
        </thead>
        {(["platform", "base"] as const).map((body) => (
          <tbody key={body} class={body}>
            <tr class="heads">
              <th colSpan={4} scope="rowgroup">
                {body === "base" ? "Base" : "Platform"}
              </th>
            </tr>
            {study[body].map((name) => (
              <tr key={name} class={name === selected ? "selected" : ""} onFocusCapture={() => select(name)}>
                <th scope="row">
                  <PointName name={name} />
                </th>
                {AXES.map((axis, i) => (
                  <td key={axis}>
                    <NumberField
                      value={placeOf(study, wanted, name)[i] ?? 0}
                      step={step}
                      digits={digits}
                      label={`${axis} of ${name}`}
                      testid={`dimension-${axis}-${name}`}
                      onChange={(value) => resizing.move(name, written(i as 0 | 1 | 2, value))}
                      onDone={resizing.done}
                    />
                  </td>
                ))}
              </tr>
            ))}
          </tbody>
        ))}
      </table>
    </div>
  );
}
