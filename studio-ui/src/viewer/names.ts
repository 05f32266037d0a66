// Names of points as they are set in formulas: an italic letter, digits below, primes and stars as they are.

export interface Run {
  text: string;
  style: "italic" | "sub" | "plain";
}

/** "S1*bd" → S, ₁, *, b, d. Words ("common point", "3 mm") stay upright. */
export function runs(label: string): Run[] {
  const found: Run[] = [];
  for (const [, stem, digits, rest] of label.matchAll(/([A-Za-z])(\d*)|([^A-Za-z]+)/g)) {
    if (stem) found.push({ text: stem, style: "italic" });
    if (digits) found.push({ text: digits, style: "sub" });
    if (rest) found.push({ text: rest.replaceAll("'", "′"), style: "plain" });
  }
  return found;
}

/** Names side by side; words are set apart, as `entity_label` of the engine does it. */
export const sideBySide = (names: readonly string[]): string =>
  names.join(names.every((name) => name.replace(/['*]+$/, "").length <= 2) ? "" : " ");

/** The same as plain text for pictures' titles and screen readers. */
export const spoken = (label: string): string => label.replaceAll("*", " star").replaceAll("'", " prime");
