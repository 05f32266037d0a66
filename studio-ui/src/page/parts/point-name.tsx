// The name of a point as it stands in formulas: a slanted letter, numbers below the line, stars and primes above.
const PARTS = /^([A-Za-z]+?)_?(\d+)?('*)(\**)$/;

export function PointName({ name }: { name: string }) {
  const found = PARTS.exec(name);
  if (!found) return <i class="pt">{name}</i>;
  const [, letters = "", number, primes, stars] = found;
  return (
    <i class={letters.length > 1 ? "pt word" : "pt"}>
      {letters}
      {number && <sub>{number}</sub>}
      {(primes || stars) && <sup>{"′".repeat(primes?.length ?? 0) + (stars ?? "")}</sup>}
    </i>
  );
}
