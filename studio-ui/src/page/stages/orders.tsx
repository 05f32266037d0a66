// The orders of the legs that were tried, by the number of monomials that each leaves.
interface Props {
  tried: number;
  counts: readonly { terms: number; orders: number }[];
  best: string;
}

const FORMS = 2; // the superbracket has two expansions, of 16 and of 24 terms

export function Orders({ tried, counts, best }: Props) {
  const most = Math.max(...counts.map(({ orders }) => orders), 1);
  const least = Math.min(...counts.map(({ terms }) => terms));
  return (
    <figure class="orders" data-testid="orders">
      <figcaption>
        <strong>{(tried / FORMS).toLocaleString("en")}</strong> orders tried, each in {FORMS} forms
      </figcaption>
      <div class="bars" role="table" aria-label="orders by the number of monomials they leave">
        {counts.map(({ terms, orders }) => (
          <div class={terms === least ? "bar best" : "bar"} role="row" key={terms}>
            <span class="terms" role="rowheader">
              {terms} {terms === 1 ? "monomial" : "monomials"}
            </span>
            <span class="track" aria-hidden="true">
              <span style={{ width: `${(100 * orders) / most}%` }} />
            </span>
            <span class="number" role="cell">
              {orders.toLocaleString("en")}
            </span>
          </div>
        ))}
      </div>
      {best && (
        <p class="best-order">
          Shortest with the legs in the order <span class="math">{best}</span>
        </p>
      )}
    </figure>
  );
}
