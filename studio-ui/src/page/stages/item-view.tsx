// What a stage shows, one part for each kind of item.
import type { ComponentChildren } from "preact";
import type { Entity, Item } from "../../protocol";
import { useStore } from "../parts/context";
import { EntityChip } from "../parts/entity-chip";
import { Formula } from "../parts/formula";
import { MonomialTable } from "../parts/monomial-table";
import { Prose } from "../parts/prose";
import { Orders } from "./orders";
import { Steps } from "./steps";

type Views = { [K in Item["kind"]]: (item: Extract<Item, { kind: K }>, found: readonly Entity[]) => ComponentChildren };

const VIEWS: Views = {
  text: ({ text }) => (
    <p class="text">
      <Prose text={text} />
    </p>
  ),
  fact: ({ key, value }) => (
    <dl class="fact">
      <dt>{key}</dt>
      <dd>
        <Prose text={value} />
      </dd>
    </dl>
  ),
  formula: ({ left, right }) => <Formula left={left} right={right} />,
  monomials: ({ monomials }, found) => <MonomialTable monomials={monomials} entities={found} />,
  orders: ({ tried, counts, best }) => <Orders tried={tried} counts={counts} best={best} />,
  entities: ({ entities }) => <Chips ids={entities} />,
  steps: ({ steps }) => <Steps steps={steps} />,
};

export function ItemView<K extends Item["kind"]>({ item, found }: { item: Extract<Item, { kind: K }>; found: readonly Entity[] }) {
  const view = VIEWS[item.kind] as (item: Item, found: readonly Entity[]) => ComponentChildren;
  return <>{view(item, found)}</>;
}

function Chips({ ids }: { ids: readonly string[] }) {
  const { study } = useStore();
  const entities = study.value?.entities.filter(({ id }) => ids.includes(id)) ?? [];
  if (entities.length === 0) return <p class="none">None here.</p>;
  return (
    <div class="chips">
      {entities.map((entity) => (
        <EntityChip key={entity.id} entity={entity} starred />
      ))}
    </div>
  );
}
