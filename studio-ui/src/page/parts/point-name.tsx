// The name of a point as it stands in formulas: a slanted letter, numbers below the line, stars and primes above.
import { Fragment } from "preact";

const PARTS = /^([A-Za-z]+?)_?(\d+)?('*)(\**)$/;

export function PointName({ name }: { name: string }) {
  const found = PARTS.exec(name);
  if (!found) return <i class="pt word">{breakable(name)}</i>;
  const [, letters = "", number, primes, stars] = found;
  return (
    <i class={letters.length > 1 ? "pt word" : "pt"}>
      {letters}
      {number && <sub>{number}</sub>}
      {(primes || stars) && <sup>{"′".repeat(primes?.length ?? 0) + (stars ?? "")}</sup>}
    </i>
  );
}

/** Lines may break after an underscore. */
const breakable = (name: string) =>
  name.split(/(?<=_)/).map((part, i) => (
    <Fragment key={i}>
      {i > 0 && <wbr />}
      {part}
    </Fragment>
  ));

/** The points of a label such as A*bd or S1A1B1, stars kept; words stand apart, and lines break between them. */
export function PointNames({ label }: { label: string }) {
  return (
    <>
      {letters(label).map((name, i) => (name === " " ? " " : <PointName key={i} name={name} />))}
    </>
  );
}

export const letters = (label: string): string[] =>
  label.includes(" ") ? label.split(/( )/) : (label.match(/[A-Za-z](?:_?\d+)?'*\**|[^A-Za-z]/g) ?? [label]);
