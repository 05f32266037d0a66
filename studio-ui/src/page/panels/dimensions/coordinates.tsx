// The coordinates of all joints as a table; of a robot of joints those of its directions too, all at home.
import type { ShapeGroup, ShapeRow, Study } from "../../../protocol";
import { useStore } from "../../parts/context";
import { NumberField } from "../../parts/number-field";
import { PointName } from "../../parts/point-name";
import { placeOf, stepOf, written } from "../../state/joint-places";

interface Props {
  study: Study;
  selected: string | null;
  select(name: string | null): void;
}

export function Coordinates({ study, selected, select }: Props) {
  return (
    <div class="scrolled">
      <table class="coordinates" data-testid="coordinates">
        {study.shape.groups.map((group) => (
          <tbody key={group.title}>
            <tr class="heads">
              <th scope="col">{group.title}</th>
              {group.axes.map((axis) => (
                <th scope="col" key={axis}>
                  {axis} {study.unit && group.sort === "point" && <small>{study.unit}</small>}
                </th>
              ))}
            </tr>
            {group.rows.map((row) => (
              <tr key={row.name} class={row.name === selected ? "selected" : ""} onFocusCapture={() => select(row.name)}>
                <th scope="row" title={row.name.length > 4 ? row.name : undefined}>
                  <PointName name={row.name} />
                </th>
                <Fields study={study} group={group} row={row} />
              </tr>
            ))}
          </tbody>
        ))}
      </table>
    </div>
  );
}

function Fields({ study, group, row: { name, at } }: { study: Study; group: ShapeGroup; row: ShapeRow }) {
  const { resizing } = useStore();
  if (at === null)
    return (
      <td class="determined" colSpan={group.axes.length}>
        follows from others
      </td>
    );
  const place = placeOf(study, resizing.wanted.value, name);
  const step = group.sort === "direction" ? 0.1 : stepOf(study);
  return (
    <>
      {group.axes.map((axis, i) => (
        <td key={axis}>
          <NumberField
            value={place[i] ?? 0}
            step={step}
            digits={Math.max(group.sort === "direction" ? 2 : 0, -Math.floor(Math.log10(step)))}
            label={`${axis} of ${name}`}
            testid={`dimension-${axis}-${name}`}
            onChange={(value) => resizing.move(name, written(i as 0 | 1 | 2, value))}
            onDone={resizing.done}
          />
        </td>
      ))}
    </>
  );
}
