// Points are picked here, in the schematic or in 3D; what they make is proposed.
import { useEffect, useState } from "preact/hooks";
import type { Manual, Study } from "../../../protocol";
import { useStore } from "../../parts/context";
import { Icon } from "../../parts/icon";
import { PointName } from "../../parts/point-name";
import { bracketTarget } from "../../state/lit";
import { commandOf, draftOf, ownEntities, picked, PROPOSALS, proposalOf, type Kind } from "./proposals";
import type { Hand } from "./session";

interface Props {
  study: Study;
  manual: Manual;
  hand: Hand;
}

export function Proposing({ study, manual, hand }: Props) {
  const { space, lit } = useStore();
  const [kind, choose] = useState<Kind>("plane");
  const [picks, pick] = useState<readonly string[]>([]);
  const { size, words } = proposalOf(kind);
  const full = picks.length === size;
  const picking = space.mode.value === "pick";

  useEffect(() => space.onPick((name) => pick((now) => picked(now, name, size))), [space, size]);
  useEffect(() => pick([]), [manual]);
  useEffect(() => {
    const entities = [...ownEntities(manual), ...draftOf(kind, picks)];
    space.overlay.value = { entities, alone: true };
  }, [space, manual, kind, picks]);
  useEffect(() => {
    lit.pin(null);
    if (picks.length > 0) lit.pin(bracketTarget([...picks]));
    return () => lit.pin(null);
  }, [lit, picks]);

  function become(next: Kind): void {
    choose(next);
    pick(picks.slice(0, proposalOf(next).size));
  }

  const slots = Array.from({ length: size }, (_, i) => picks[i]);
  const left = (name: string) => manual.left.filter((p) => p === name).length;
  return (
    <section class="proposing" aria-label="Proposal">
      <div class="segments wrap" role="group" aria-label="What to propose">
        {PROPOSALS.map((p) => (
          <button type="button" key={p.kind} aria-pressed={p.kind === kind} onClick={() => become(p.kind)} data-testid={`propose-${p.kind}`}>
            {p.title}
          </button>
        ))}
      </div>
      <p class="words">{words}</p>
      <div class="letters" role="group" aria-label="Points">
        {rowsOf(study, manual).map(([title, names]) => (
          <div key={title}>
            <span class="where">{title}</span>
            {names.map((name) => (
              <button
                type="button"
                key={name}
                class="letter"
                data-point={name}
                aria-pressed={picks.includes(name)}
                aria-label={`point ${name}, ${left(name)} left over`}
                data-testid={`pick-${name}`}
              >
                <PointName name={name} />
                <span class="left" aria-hidden="true">
                  {"•".repeat(left(name))}
                </span>
              </button>
            ))}
          </div>
        ))}
        <button
          type="button"
          class="small in-3d"
          aria-pressed={picking}
          title="A click on a joint in 3D takes it; the platform's handles are put away"
          onClick={() => (space.mode.value = picking ? "orbit" : "pick")}
          data-testid="manual-pick"
        >
          <Icon name="target" size={15} /> Pick in 3D
        </button>
      </div>
      <form
        class="line"
        onSubmit={(event) => {
          event.preventDefault();
          if (full) hand.propose(commandOf(kind, picks));
        }}
      >
        <output class="slots" aria-label="Points of the proposal" data-testid="manual-slots">
          {slots.map((name, i) => (
            <span key={i} class={`${name ? "slot" : "slot empty"}${kind === "lines" && i === 2 ? " apart" : ""}`}>
              {name ? <PointName name={name} /> : "·"}
            </span>
          ))}
        </output>
        <button type="submit" class="primary" disabled={!full} data-testid="manual-propose">
          Propose
        </button>
        <button type="button" class="quiet" disabled={picks.length === 0} onClick={() => pick([])} data-testid="manual-clear">
          Clear
        </button>
      </form>
    </section>
  );
}

/** The points of the monomials, by bodies; lines that stand for limbs have points of neither. */
function rowsOf({ platform, base }: Study, { form }: Manual): [string, string[]][] {
  const all = new Set(form.monomials.flatMap(({ brackets }) => brackets.flatMap(({ points }) => points)));
  const rows: [string, string[]][] = [
    ["Platform", platform.filter((name) => all.has(name))],
    ["Base", base.filter((name) => all.has(name))],
    ["Others", [...all].filter((name) => !platform.includes(name) && !base.includes(name)).sort()],
  ];
  return rows.filter(([, names]) => names.length > 0);
}
