// Whether a reader that leaves out what it does not understand has understood all.

/** The first place in `given` that did not come out of the reader as it is; null where all of it did. */
export function leftOut(given: unknown, read: unknown, at: string): string | null {
  if (Array.isArray(given)) {
    if (!Array.isArray(read) || read.length !== given.length) return at;
    return first(given, (part, i) => leftOut(part, read[i], `${at}[${i + 1}]`));
  }
  if (typeof given === "object" && given !== null) {
    if (typeof read !== "object" || read === null) return at;
    return first(Object.entries(given), ([key, part]) => leftOut(part, (read as Record<string, unknown>)[key], `${at}.${key}`));
  }
  if (typeof given === "number" && typeof read === "number") {
    return Math.abs(given - read) <= 1e-9 * Math.max(1, Math.abs(given)) ? null : at;
  }
  return given === read ? null : at;
}

function first<T>(parts: readonly T[], of: (part: T, index: number) => string | null): string | null {
  for (const [i, part] of parts.entries()) {
    const found = of(part, i);
    if (found !== null) return found;
  }
  return null;
}
