// The convex hull of places in a plane, its corners one after the other (Andrew's monotone chain).
type Spot = readonly [number, number];

export function hull(points: readonly Spot[]): Spot[] {
  const sorted = [...points].sort((p, q) => p[0] - q[0] || p[1] - q[1]);
  const half = (given: readonly Spot[]) =>
    given.reduce<Spot[]>((chain, p) => {
      while (chain.length > 1 && turn(chain.at(-2) ?? p, chain.at(-1) ?? p, p) <= 0) chain.pop();
      return [...chain, p];
    }, []);
  return [...half(sorted).slice(0, -1), ...half([...sorted].reverse()).slice(0, -1)];
}

const turn = (a: Spot, b: Spot, c: Spot): number => (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
