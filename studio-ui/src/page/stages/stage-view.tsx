// One stage: its question, its reason, what it found, and the theory for those who ask.
import type { Item, Piece, Stage, Study } from "../../protocol";
import { useStore } from "../parts/context";
import { Schematic } from "../parts/drawing";
import { EntityChip } from "../parts/entity-chip";
import { Icon } from "../parts/icon";
import { Prose } from "../parts/prose";
import { Termed } from "../parts/term";
import { Zoom } from "../parts/zoom";
import { foundBy } from "../state/scene";
import { ConditionView } from "./condition-view";
import { Limbs } from "./limbs";
import { Items } from "./item-view";
import { ModelView } from "./model-view";
import { PointList } from "./point-list";

/** The items of a stage without those that the page shows in a way of its own. */
function itemsOf({ id, items }: Stage, { condition }: Study): Item[] {
  return items.filter((item) => {
    if (id === "structure" && item.kind === "fact") return !["legs", "base", "platform"].includes(item.key);
    if (id === "condition" && item.kind === "formula") return texOf(item.right) !== texOf(condition.right);
    return !(id === "statement" && item === sentenceOf(items));
  });
}

/** The sentence that is set large: of a robot with limbs that of the robot, not that of its lines. */
const sentenceOf = (items: readonly Item[]) => items.find((item) => item.kind === "text");

const texOf = (pieces: readonly Piece[]): string => pieces.map(({ tex }) => tex).join(" ");

const WITH_CONDITION = ["condition", "statement"];
const WITH_FIGURE = ["limbs", "equivalent"];

/** Where one goes on after the last step. */
const NEXT = [
  ["motion", "Move it"],
  ["manual", "Try by hand"],
  ["take-away", "Take away"],
] as const;

export function StageView({ study, stage, number }: { study: Study; stage: Stage; number: number }) {
  const { go } = useStore();
  const listed = foundBy(study.stages, stage.id);
  const found = study.entities.filter(({ id }) => listed === null || listed.includes(id));
  const at = study.stages.indexOf(stage);
  const [before, after] = [study.stages[at - 1], study.stages[at + 1]];
  return (
    <section class="stage" id="stage" role="tabpanel" aria-labelledby="stage-title" data-testid={`stage-${stage.id}`}>
      <header>
        <p class="over">
          Step {number} of {study.stages.length}
        </p>
        <h2 id="stage-title">
          <Termed text={stage.title} />
        </h2>
        <p class="why">
          <Prose text={stage.why} />
        </p>
      </header>
      {at === 0 && study.note && <p class="note">{study.note}</p>}
      {at === 0 && study.model && <ModelView model={study.model} />}
      {WITH_FIGURE.includes(stage.id) && study.robot?.figure && (
        <Zoom
          svg={study.robot.figure}
          label="The robot with the wrenches of its limbs, and the six lines that stand for them"
          testid="robot-figure"
        />
      )}
      {stage.id === "structure" && study.schematic && <Schematic svg={study.schematic} />}
      {stage.id === "structure" && <PointList study={study} />}
      {stage.id === "limbs" && study.robot && <Limbs robot={study.robot} />}
      {WITH_CONDITION.includes(stage.id) && <ConditionView study={study} sentence={stage.id === "statement" ? sentenceOf(stage.items)?.text : undefined} />}
      <Items key={stage.id} items={itemsOf(stage, study)} found={found} />
      {stage.id === "left-over" && found.length > 0 && !stage.items.some(({ kind }) => kind === "entities") && (
        <div class="chips">
          {found.map((entity) => (
            <EntityChip key={entity.id} entity={entity} starred />
          ))}
        </div>
      )}
      {stage.more.length > 0 && (
        <details class="more" key={stage.id}>
          <summary data-testid="more">
            <Icon name="more" /> More: the theory
          </summary>
          {stage.more.map((text, i) => (
            <p key={i}>
              <Prose text={text} />
            </p>
          ))}
        </details>
      )}
      <nav class="steps-nav" aria-label="steps">
        <button type="button" class="quiet" disabled={!before} data-testid="stage-back" onClick={() => before && go({ stage: before.id })}>
          <Icon name="back" size={16} /> {before?.title ?? "Back"}
        </button>
        {after ? (
          <button type="button" class="primary" data-testid="stage-next" onClick={() => go({ stage: after.id })}>
            {after.title} <Icon name="next" size={16} />
          </button>
        ) : (
          NEXT.map(([panel, words]) => (
            <button type="button" class="onward" key={panel} data-testid={`go-${panel}`} onClick={() => go({ panel })}>
              <Icon name={panel === "motion" ? "map" : panel} size={16} /> {words}
            </button>
          ))
        )}
      </nav>
    </section>
  );
}
