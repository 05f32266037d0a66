// The scale of closeness: logarithmic, for a robot near a singularity has lost most of it.
export const LEAST = 1e-4;

/** 0 … 1 along the gauge; what is below LEAST stands at its start. */
export const along = (sigma: number): number =>
  sigma <= LEAST ? 0 : Math.min(1 - Math.log10(sigma) / Math.log10(LEAST), 1);

const DEGREE = Math.PI / 180;
const ANGLE = /^\s*([\d.]+(?:e[+-]?\d+)?)\s*(deg|°|rad)\s*$/i;

/** The closeness below which a threshold angle warns: no leg has turned by θ before a singular pose if σ > 2 sin(θ/2). */
export function sigmaOf(threshold: string): number | null {
  const found = ANGLE.exec(threshold);
  if (!found) return null; // a length: what it means for σ depends on the pose
  const angle = Number(found[1]) * (found[2]?.toLowerCase() === "rad" ? 1 : DEGREE);
  return 2 * Math.sin(Math.min(angle, Math.PI) / 2);
}

export const degreesOf = (sigma: number): number => (2 * Math.asin(Math.min(sigma, 2) / 2)) / DEGREE;
