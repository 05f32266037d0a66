// Points and directions: how each is made, and where it is at home.
import type { LimbSheet, NamedPlace, NameRow, SheetEdit } from "../../../protocol";
import { TextField } from "./fields";
import { RowFaults } from "./row-faults";

interface Props {
  sheet: LimbSheet;
  units: readonly string[];
  follow: boolean;
  setFollow(on: boolean): void;
  change(edit: SheetEdit, key?: string): void;
}

const SORTS = [
  ["point", "Points"],
  ["direction", "Directions"],
] as const;

export function NamesTable({ sheet, units, follow, setFollow, change }: Props) {
  const copied = sheet.names.some(({ name }) => name.includes("%"));
  const digits = Math.max(4, ...sheet.names.flatMap(({ places }) => places.flatMap(({ at }) => at.map((text) => text.length))));
  return (
    <section class="names" aria-label="Points and directions" data-testid="names">
      <header>
        <h2>Points and directions</h2>
        <label class="unit">
          Unit of length{" "}
          <select value={sheet.unit} data-testid="limbs-unit" onChange={(event) => change({ do: "unit", text: event.currentTarget.value })}>
            <option value="">none</option>
            {units.map((unit) => (
              <option key={unit}>{unit}</option>
            ))}
          </select>
        </label>
        {copied && sheet.copies > 1 && (
          <label class="copies-follow" title="Coordinates are those of the first copy; the others are turned about z">
            <input type="checkbox" checked={follow} onChange={(event) => setFollow(event.currentTarget.checked)} data-testid="follow" />
            Copies follow the first one, turned about z
          </label>
        )}
      </header>
      <datalist id="relations-point">
        {RELATIONS.point.map((words) => (
          <option key={words} value={words} />
        ))}
      </datalist>
      <datalist id="relations-direction">
        {RELATIONS.direction.map((words) => (
          <option key={words} value={words} />
        ))}
      </datalist>
      <div class="scrolled">
        <table style={{ "--digits": digits }}>
          {SORTS.map(([sort, title]) => {
            const rows = sheet.names.filter((row) => row.sort === sort);
            return (
              rows.length > 0 && (
                <tbody key={sort}>
                  <tr class="heads">
                    <th scope="col">{title}</th>
                    <th scope="col">made as</th>
                    {["x", "y", "z"].slice(0, sheet.plane ? 2 : 3).map((axis) => (
                      <th scope="col" class="coordinate-head" key={axis}>
                        {axis}
                        {sheet.unit && sort === "point" && <small> {sheet.unit}</small>}
                      </th>
                    ))}
                  </tr>
                  {rows.map((row) => (
                    <Row key={row.name} row={row} sheet={sheet} follow={follow} change={change} />
                  ))}
                </tbody>
              )
            );
          })}
        </table>
      </div>
    </section>
  );
}

const RELATIONS = {
  point: ["free", "on line A1 B1", "on line A1 along u1", "in plane A1 B1 C1", "in plane A1 along u1, v1", "in plane A1 perpendicular to u1", "B1 + A2 - A1"],
  direction: ["free", "along A1 B1", "parallel to u1", "perpendicular to u1", "perpendicular to u1, v1", "perpendicular to u1, A1 B1", "in span u1, v1"],
};

function Row({ row, sheet, follow, change }: { row: NameRow } & Pick<Props, "sheet" | "follow" | "change">) {
  const together = follow && row.places.length > 1;
  const places = together ? row.places.slice(0, 1) : row.places;
  const [first, ...others] = places;
  const width = sheet.plane ? 4 : 5;
  const step = row.sort === "direction" ? 0.1 : stepOf(sheet);
  return (
    <>
      <tr class={row.faults.length > 0 ? "wrong" : ""} data-testid={`name-row-${row.name}`}>
        <th scope="row">
          <TextField value={row.name} label={`Name of ${row.sort} ${row.name}`} class="math-name" testid={`rename-${row.name}`} onTake={(text) => change({ do: "name rename", name: row.name, text })} />
        </th>
        <td>
          <TextField value={row.relation} label={`How ${row.name} is made`} list={`relations-${row.sort}`} class="relation" testid={`relation-${row.name}`} onTake={(text) => change({ do: "name relation", name: row.name, text })} />
        </td>
        {first && <Coordinates place={first} step={step} plane={sheet.plane} follow={follow} change={change} />}
      </tr>
      {others.map((place) => (
        <tr key={place.name} class="of-copy">
          <td />
          <td class="copy-name">{place.name}</td>
          <Coordinates place={place} step={step} plane={sheet.plane} follow={false} change={change} />
        </tr>
      ))}
      {row.faults.length > 0 && (
        <tr class="faults">
          <td colSpan={width}>
            <RowFaults faults={row.faults} />
          </td>
        </tr>
      )}
    </>
  );
}

const AXES = ["x", "y", "z"] as const;

/** A fraction or a decimal; null for what is none. */
function numberOf(text: string): number | null {
  const [over = "", under = "1", ...more] = text.split("/");
  const value = text.trim() && more.length === 0 ? Number(over) / Number(under) : NaN;
  return Number.isFinite(value) ? value : null;
}

/** By how much an arrow key shifts a point: a tenth of the power of ten below the largest coordinate. */
function stepOf(sheet: LimbSheet): number {
  const points = sheet.names.filter(({ sort }) => sort === "point");
  const sizes = points.flatMap(({ places }) => places.flatMap(({ at }) => at.map((text) => Math.abs(numberOf(text) ?? 0))));
  return 10 ** (Math.floor(Math.log10(Math.max(...sizes) || 1)) - 1);
}

interface CoordinatesProps extends Pick<Props, "follow" | "change"> {
  place: NamedPlace;
  plane: boolean;
  step: number;
}

function Coordinates({ place, plane, step, follow, change }: CoordinatesProps) {
  const [x = "", y = "", z = ""] = place.at;
  if (place.at.length === 0)
    return (
      <td class="determined" colSpan={plane ? 2 : 3}>
        follows
      </td>
    );
  function put(i: number, text: string, key?: string): void {
    const texts = [x, y, z].map((old, k) => (k === i ? text : old || "0")) as [string, string, string];
    change({ do: "home", name: place.name, texts, follow }, key);
  }
  return (
    <>
      {AXES.slice(0, plane ? 2 : 3).map((axis, i) => (
        <td key={axis}>
          <TextField
            value={[x, y, z][i] ?? ""}
            label={`${axis} of ${place.name} at home`}
            class="coordinate"
            testid={`home-${place.name}-${axis}`}
            onTake={(text) => put(i, text)}
            onStep={(by) => {
              const old = numberOf([x, y, z][i] || "0");
              if (old !== null) put(i, String(Number((old + by * step).toFixed(9))), `limbs ${place.name} ${axis}`);
            }}
          />
        </td>
      ))}
    </>
  );
}
