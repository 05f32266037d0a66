// What a stage shows, one part for each kind of item.
import { Fragment, type ComponentChildren } from "preact";
import type { Entity, Item } from "../../protocol";
import { useStore } from "../parts/context";
import { EntityChip } from "../parts/entity-chip";
import { Formula } from "../parts/formula";
import { MonomialTable } from "../parts/monomial-table";
import { Prose } from "../parts/prose";
import { Orders } from "./orders";
import { Steps } from "./steps";

type Fact = Extract<Item, { kind: "fact" }>;
type Other = Exclude<Item, Fact>;
type Views = { [K in Other["kind"]]: (item: Extract<Other, { kind: K }>, found: readonly Entity[]) => ComponentChildren };

const VIEWS: Views = {
  text: ({ text }) => (
    <p class="text">
      <Prose text={text} />
    </p>
  ),
  formula: ({ left, right }) => <Formula left={left} right={right} />,
  monomials: ({ monomials }, found) => <MonomialTable monomials={monomials} entities={found} />,
  orders: ({ tried, counts, best }) => <Orders tried={tried} counts={counts} best={best} />,
  entities: ({ entities }) => <Chips ids={entities} />,
  steps: ({ steps }) => <Steps steps={steps} />,
};

/** The items of a stage one after the other; facts side by side are one list. */
export function Items({ items, found }: { items: readonly Item[]; found: readonly Entity[] }) {
  return (
    <>
      {runs(items).map((run, i) =>
        Array.isArray(run) ? <Facts key={i} facts={run} /> : <OneItem key={i} item={run} found={found} />,
      )}
    </>
  );
}

function runs(items: readonly Item[]): (Fact[] | Other)[] {
  const found: (Fact[] | Other)[] = [];
  for (const item of items) {
    const last = found.at(-1);
    if (item.kind !== "fact") found.push(item);
    else if (Array.isArray(last)) last.push(item);
    else found.push([item]);
  }
  return found;
}

function OneItem<K extends Other["kind"]>({ item, found }: { item: Extract<Other, { kind: K }>; found: readonly Entity[] }) {
  const view = VIEWS[item.kind] as (item: Other, found: readonly Entity[]) => ComponentChildren;
  return <>{view(item, found)}</>;
}

function Facts({ facts }: { facts: readonly Fact[] }) {
  return (
    <dl class="fact">
      {facts.map(({ key, value }, i) => (
        <Fragment key={i}>
          <dt>{key}</dt>
          <dd>
            <Prose text={value} />
          </dd>
        </Fragment>
      ))}
    </dl>
  );
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
