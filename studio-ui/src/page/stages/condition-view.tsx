// The condition set large: identity, sentence, how sure it is; and the other readings of the same superbracket.
import { useState } from "preact/hooks";
import type { Condition, Study } from "../../protocol";
import { EntityChip } from "../parts/entity-chip";
import { Formula } from "../parts/formula";
import { Icon } from "../parts/icon";
import { Prose } from "../parts/prose";

export function ConditionView({ study, sentence }: { study: Study; sentence: string | undefined }) {
  const [shown, show] = useState(0);
  const all: readonly Condition[] = [study.condition, ...study.readings];
  const condition = all[Math.min(shown, all.length - 1)] ?? study.condition;
  return (
    <section class="condition" data-testid="condition">
      {sentence !== undefined && (
        <blockquote class="sentence" data-testid="statement">
          <Prose text={sentence} />
        </blockquote>
      )}
      <Formula left={condition.left} right={condition.right} display />
      {shown === 0 && study.entities.length > 0 && (
        <div class="chips">
          {study.entities.map((entity) => (
            <EntityChip key={entity.id} entity={entity} />
          ))}
        </div>
      )}
      <p class="certificate">
        <Icon name="ok" size={16} />
        <span>
          {condition.certificate.detail} <span class="tag">{condition.certificate.method}</span>
        </span>
      </p>
      {shown > 0 && (
        <p class="text">
          <Prose text={condition.statement} />
        </p>
      )}
      {all.length > 1 && sentence === undefined && (
        <label class="readings-choice">
          Reading
          <select value={shown} onChange={(event) => show(Number(event.currentTarget.value))}>
            {all.map(({ kind }, i) => (
              <option key={i} value={i}>
                {kind.replaceAll("-", " ")}
                {i === 0 && study.entities.length > 0 ? " (shown in 3D)" : ""}
              </option>
            ))}
          </select>
        </label>
      )}
    </section>
  );
}
