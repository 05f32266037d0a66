// A formula in pieces: each stays on one line, lights up with its points and takes the colour of its entity.
import { Fragment } from "preact";
import { useState } from "preact/hooks";
import type { Piece } from "../../protocol";
import { splitBrackets, splitOperator, texToHtml, texToText } from "../lib/tex";
import { tone } from "../lib/tint";
import { litPoints } from "../state/lit";
import { useStore } from "./context";
import { samePoints } from "./pointing";

const LARGE = 5; // pieces that are set large
const MOST = 150; // pieces that are shown unasked: KaTeX takes about a millisecond for each

interface Props {
  left?: readonly Piece[];
  right: readonly Piece[];
  /** Larger, for the condition. */
  display?: boolean;
}

export function Formula({ left = [], right, display = false }: Props) {
  const text = [left, right].filter((side) => side.length).map((side) => side.map((p) => texToText(p.tex)).join(" "));
  return (
    <div class={`formula${display ? " display" : ""}${right.length > LARGE ? " many" : ""}`} role="group" aria-label={text.join(" = ")}>
      {left.length > 0 && (
        <span class="hand left">
          <Pieces pieces={left} />
          <Tex tex="{}={}" />
        </span>
      )}
      <span class="hand">
        <Pieces pieces={right} />
      </span>
    </div>
  );
}

/** Lines break between pieces only. Of very long formulas the beginning is shown until the rest is asked for. */
function Pieces({ pieces }: { pieces: readonly Piece[] }) {
  const [all, showAll] = useState(false);
  const shown = all ? pieces : pieces.slice(0, MOST);
  return (
    <>
      {shown.map((piece, i) => (
        <Fragment key={i}>
          {i > 0 && <wbr />}
          <PieceView piece={piece} />
        </Fragment>
      ))}
      {shown.length < pieces.length && (
        <button type="button" class="quiet" onClick={() => showAll(true)}>
          … {pieces.length - shown.length} more
        </button>
      )}
    </>
  );
}

function PieceView({ piece }: { piece: Piece }) {
  const [operator, rest, after] = splitOperator(piece.tex);
  const parts = piece.brackets.length > 1 ? splitBrackets(rest, piece.brackets.length) : null;
  const before = operator + (parts?.before ?? "");
  const shown = parts?.brackets.map((tex, i) => ({ tex, brackets: [piece.brackets[i] ?? []] }));
  return (
    <span class="piece">
      {before && <Tex tex={before} />}
      {(shown ?? [{ tex: rest, brackets: piece.brackets }]).map(({ tex, brackets }, i) => (
        <Part key={i} tex={tex} together={brackets.length > 0 ? brackets : [piece.points]} whole={brackets.length === 1} />
      ))}
      {after && <Tex tex={after} />}
    </span>
  );
}

/** What lights up as one; where it is a single bracket or join it can be pointed at as well. */
function Part({ tex, together, whole }: { tex: string; together: readonly string[][]; whole: boolean }) {
  const { lit, study } = useStore();
  const target = lit.current.value;
  const points = together[0] ?? [];
  const entity = whole ? study.value?.entities.find((e) => samePoints(e.points, points)) : undefined;
  const on = together.some((group) => litPoints(group, target).length > 0);
  return (
    <span
      class={`of${on ? " lit" : ""}${whole ? " whole" : ""}`}
      {...(whole && { "data-bracket": points.join(" "), role: "button", tabIndex: 0, "aria-label": points.join(" ") })}
      style={tone(entity)}
    >
      <Tex tex={tex} />
    </span>
  );
}

function Tex({ tex }: { tex: string }) {
  return <span aria-hidden="true" dangerouslySetInnerHTML={{ __html: texToHtml(tex) }} />;
}
