// A sentence whose entities take their colours and can be pointed at.
import { wordsOf } from "../lib/prose";
import { tone } from "../lib/tint";
import { useStore } from "./context";
import { PointNames } from "./point-name";
import { Termed } from "./term";

export function Prose({ text }: { text: string }) {
  const { study, lit } = useStore();
  const seen = new Set<string>();
  const on = lit.current.value?.entity;
  return (
    <>
      {wordsOf(text, study.value?.entities ?? []).map(({ text: word, entity, source }) =>
        source ? (
          <cite>{word}</cite>
        ) : entity ? (
          <span class={entity.id === on ? "entity-word lit" : "entity-word"} data-entity={entity.id} style={tone(entity)}>
            <PointNames label={word} />
          </span>
        ) : (
          <Termed text={word} seen={seen} />
        ),
      )}
    </>
  );
}
