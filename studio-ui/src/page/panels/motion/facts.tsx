// What was computed and how it is proved, folded away.
import type { FactItem } from "../../../protocol";

export function Facts({ facts, title }: { facts: readonly FactItem[]; title: string }) {
  return (
    <details class="facts">
      <summary>{title}</summary>
      <dl>
        {facts.map(({ key, value }, i) => (
          <div key={i}>
            <dt>{facts[i - 1]?.key === key ? "" : key}</dt>
            <dd>{value}</dd>
          </div>
        ))}
      </dl>
    </details>
  );
}
