// Small matrices: singular values by one-sided rotations (Hestenes), determinants by elimination.

export interface Singular {
  /** Largest first. */
  values: number[];
  /** The right singular vectors, in the same sequence. */
  vectors: number[][];
}

/** Singular values and right vectors of a matrix given by its rows; accurate for small values too. */
export function singular(rows: readonly (readonly number[])[]): Singular {
  const n = rows[0]!.length;
  const columns = Array.from({ length: n }, (_, j) => rows.map((row) => row[j]!));
  const right = columns.map((_, j) => columns.map((_, i) => (i === j ? 1 : 0)));
  const dot = (a: number[], b: number[]) => a.reduce((sum, c, i) => sum + c * b[i]!, 0);
  const turn = (a: number[], b: number[], c: number, s: number) => {
    for (let i = 0; i < a.length; i++) [a[i], b[i]] = [c * a[i]! - s * b[i]!, s * a[i]! + c * b[i]!];
  };
  for (let sweep = 0; sweep < 40; sweep++) {
    let largest = 0;
    for (let p = 0; p < n; p++)
      for (let q = p + 1; q < n; q++) {
        const [alpha, beta, gamma] = [dot(columns[p]!, columns[p]!), dot(columns[q]!, columns[q]!), dot(columns[p]!, columns[q]!)];
        const size = Math.sqrt(alpha * beta);
        if (!(Math.abs(gamma) > 1e-16 * size)) continue;
        largest = Math.max(largest, Math.abs(gamma) / size);
        const zeta = (beta - alpha) / (2 * gamma);
        const t = (zeta < 0 ? -1 : 1) / (Math.abs(zeta) + Math.hypot(1, zeta));
        const c = 1 / Math.hypot(1, t);
        turn(columns[p]!, columns[q]!, c, c * t);
        turn(right[p]!, right[q]!, c, c * t);
      }
    if (largest < 1e-15) break;
  }
  const sizes = columns.map((column) => Math.sqrt(dot(column, column)));
  const order = sizes.map((_, i) => i).sort((i, j) => sizes[j]! - sizes[i]!);
  return { values: order.map((i) => sizes[i]!), vectors: order.map((i) => right[i]!) };
}

/** The determinant of a square matrix. */
export function determinant(rows: readonly (readonly number[])[]): number {
  const m = rows.map((row) => [...row]);
  let value = 1;
  for (let k = 0; k < m.length; k++) {
    let pivot = k;
    for (let i = k + 1; i < m.length; i++) if (Math.abs(m[i]![k]!) > Math.abs(m[pivot]![k]!)) pivot = i;
    if (!m[pivot]![k]) return 0;
    if (pivot !== k) {
      [m[k], m[pivot]] = [m[pivot]!, m[k]!];
      value = -value;
    }
    value *= m[k]![k]!;
    for (let i = k + 1; i < m.length; i++) {
      const factor = m[i]![k]! / m[k]![k]!;
      for (let j = k; j < m.length; j++) m[i]![j]! -= factor * m[k]![j]!;
    }
  }
  return value;
}

/** The lower triangle L with L·Lᵀ = m of a symmetric matrix with three rows; null unless it is positive definite. */
export function cholesky(m: readonly (readonly number[])[]): number[][] | null {
  const lower = m.map((row) => row.map(() => 0));
  for (let i = 0; i < m.length; i++)
    for (let j = 0; j <= i; j++) {
      let sum = m[i]![j]!;
      for (let k = 0; k < j; k++) sum -= lower[i]![k]! * lower[j]![k]!;
      if (i === j && sum <= 1e-14) return null;
      lower[i]![j] = i === j ? Math.sqrt(sum) : sum / lower[j]![j]!;
    }
  return lower;
}

/** x with L·x = b. */
export function forwards(lower: readonly (readonly number[])[], b: readonly number[]): number[] {
  const x: number[] = [];
  b.forEach((c, i) => x.push((c - x.reduce((sum, v, k) => sum + lower[i]![k]! * v, 0)) / lower[i]![i]!));
  return x;
}

/** x with Lᵀ·x = b. */
export function backwards(lower: readonly (readonly number[])[], b: readonly number[]): number[] {
  const x = b.map(() => 0);
  for (let i = b.length - 1; i >= 0; i--) {
    let sum = b[i]!;
    for (let k = i + 1; k < b.length; k++) sum -= lower[k]![i]! * x[k]!;
    x[i] = sum / lower[i]![i]!;
  }
  return x;
}
