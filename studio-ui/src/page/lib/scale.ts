// The scale of the margin: logarithmic, for a robot near a singularity has lost most of it.
export const LEAST = 1e-4;

/** 0 … 1 along the gauge; what is below LEAST stands at its start. */
export const along = (sigma: number): number =>
  sigma <= LEAST ? 0 : Math.min(1 - Math.log10(sigma) / Math.log10(LEAST), 1);

const DEGREE = Math.PI / 180;

/** The threshold angle that warns below a margin: no leg has turned by θ before a singular pose if σ > sin θ. */
export const degreesOf = (sigma: number): number => Math.asin(Math.min(sigma, 1)) / DEGREE;
