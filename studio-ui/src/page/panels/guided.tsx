// The guided steps: one stage at a time, any of them at once.
import { useEffect, useRef } from "preact/hooks";
import type { StageId } from "../../protocol";
import { Tabs } from "../parts/tabs";
import { StageView } from "../stages/stage-view";
import type { PanelProps } from "./index";

export function Guided({ store }: PanelProps) {
  const study = store.study.value;
  const wanted = store.stage$.value;
  const scroller = useRef<HTMLDivElement>(null);
  const at = Math.max(study?.stages.findIndex(({ id }) => id === wanted) ?? 0, 0);
  const stage = study?.stages[at];
  useEffect(() => scroller.current?.scrollTo(0, 0), [stage]);
  if (!study || !stage) return null;
  return (
    <div class="guided">
      <Tabs<StageId>
        name="Steps"
        class="stepper"
        vertical
        controls="stage"
        current={stage.id}
        onChoose={(id) => store.go({ stage: id })}
        tabs={study.stages.map(({ id, title }, i) => ({
          id,
          title,
          testid: `step-${id}`,
          label: (
            <>
              <span class={i < at ? "dot done" : "dot"} aria-hidden="true">
                {i + 1}
              </span>
              <span class="title">{title}</span>
            </>
          ),
        }))}
      />
      <div class="scroller" ref={scroller}>
        <StageView study={study} stage={stage} number={at + 1} />
      </div>
    </div>
  );
}
