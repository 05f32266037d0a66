// The readings of the condition at the pose: numbers that have a meaning in the geometry.
import { short } from "../lib/format";
import { useStore } from "../parts/context";

const inWords = (expression: string): string => expression.replaceAll("/\\", "∧").replaceAll("\\/", "∨");

export function ReadingsTable() {
  const { posing } = useStore();
  const readings = posing.numbers.value?.readings ?? [];
  if (readings.length === 0) return <p class="none">This condition has no readings at a pose.</p>;
  const parts = [...new Set(readings.map(({ part }) => part))];
  return (
    <table class="readings" data-testid="readings">
      {parts.map((part) => (
        <tbody key={part}>
          <tr>
            <th colSpan={2} scope="rowgroup">
              {inWords(part)}
            </th>
          </tr>
          {readings
            .filter((r) => r.part === part)
            .map(({ name, meaning, value, unit, why }) => (
              <tr key={name} title={meaning}>
                <th scope="row">{name}</th>
                <td>{value === null ? <em>{why}</em> : `${short(value)} ${unit}`}</td>
              </tr>
            ))}
        </tbody>
      ))}
    </table>
  );
}
