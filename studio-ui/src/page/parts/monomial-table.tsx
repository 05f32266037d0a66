// The monomials of a bracket polynomial as a table of brackets. Long tables scroll and show only the rows in view.
import { useRef, useState } from "preact/hooks";
import type { Entity, Monomial } from "../../protocol";
import { tintOf, tone, type Tint } from "../lib/tint";
import { litPoints, type Target } from "../state/lit";
import { useStore } from "./context";
import { moveInGrid } from "./grid-keys";
import { PointName } from "./point-name";

interface Props {
  monomials: readonly Monomial[];
  /** Entities whose letters take their colours. */
  entities?: readonly Entity[];
  /** Number of a monomial to mark, such as the one that breaks a claim. */
  marked?: number | null;
}

const ROW = 34; // CSS pixels; the style sheet gives rows this height in rem
const ALL = 60; // rows that are shown without scrolling inside
const VIEW = 16;

export function MonomialTable({ monomials, entities = [], marked = null }: Props) {
  const { lit } = useStore();
  const [top, setTop] = useState(0);
  const box = useRef<HTMLDivElement>(null);
  const target = lit.current.value;
  const scale = remScale();
  const long = monomials.length > ALL;
  const first = long ? Math.max(Math.floor(top / (ROW * scale)) - 4, 0) : 0;
  const shown = long ? monomials.slice(first, first + VIEW + 8) : monomials;
  return (
    <div
      ref={box}
      class={long ? "monomials long" : "monomials"}
      role="table"
      aria-label={`${monomials.length} monomials`}
      aria-rowcount={monomials.length}
      data-testid="monomials"
      onScroll={long ? (event) => setTop(event.currentTarget.scrollTop) : undefined}
      onKeyDown={moveInGrid}
    >
      <div class="rows" style={long ? { height: `${(monomials.length * ROW) / 16}rem` } : undefined}>
        {shown.map((monomial, i) => (
          <Row
            key={first + i}
            index={first + i}
            monomial={monomial}
            tint={tintOf(monomial, entities)}
            target={target}
            marked={marked === first + i}
            top={long ? (first + i) * ROW : null}
            entrance={i === 0}
          />
        ))}
      </div>
    </div>
  );
}

interface RowProps {
  index: number;
  monomial: Monomial;
  tint: Tint;
  target: Target | null;
  marked: boolean;
  top: number | null;
  /** Whether the tab key comes in here; the arrow keys lead on. */
  entrance: boolean;
}

function Row({ index, monomial, tint, target, marked, top, entrance }: RowProps) {
  return (
    <div
      class={marked ? "row marked" : "row"}
      role="row"
      aria-rowindex={index + 1}
      style={top === null ? undefined : { position: "absolute", top: `${top / 16}rem` }}
    >
      <span class="count" role="rowheader">
        {index + 1}
      </span>
      <span class="sign" role="cell">
        {monomial.sign > 0 ? "+" : "−"}
        {monomial.coefficient}
      </span>
      {monomial.brackets.map(({ points }, i) => (
        <span role="cell" key={i}>
          <BracketButton points={points} colours={tint[i]} target={target} first={entrance && i === 0} />
        </span>
      ))}
    </div>
  );
}

interface BracketProps {
  points: readonly string[];
  colours?: ReadonlyMap<string, number> | undefined;
  target: Target | null;
  first: boolean;
}

function BracketButton({ points, colours, target, first }: BracketProps) {
  const lit = litPoints(points, target);
  const whole = target !== null && lit.length === points.length;
  return (
    <button
      type="button"
      class={`bracket${whole ? " lit" : ""}`}
      data-bracket={points.join(" ")}
      aria-label={`bracket ${points.join(" ")}`}
      tabIndex={first ? 0 : -1}
    >
      <span class="fence">[</span>
      {points.map((name) => {
        const colour = colours?.get(name);
        return (
          <span
            class={`letter${lit.includes(name) ? " lit" : ""}${colour === undefined ? "" : " toned"}`}
            style={tone(colour === undefined ? undefined : { colour })}
          >
            <PointName name={name} />
          </span>
        );
      })}
      <span class="fence">]</span>
    </button>
  );
}

const remScale = (): number => parseFloat(getComputedStyle(document.documentElement).fontSize) / 16;
