// What a tab keeps over a reload; bounded, and gone with the tab.
const LONGEST = 2_000_000; // characters of one thing

/** Keeps a text; null, or a text that is too long, forgets it. */
export function remember(key: string, text: string | null): void {
  try {
    if (text === null || text.length > LONGEST) sessionStorage.removeItem(key);
    else sessionStorage.setItem(key, text);
  } catch {
    // storage may be forbidden or full: it is then lost with a reload
  }
}

export function recalled(key: string): string | null {
  try {
    return sessionStorage.getItem(key);
  } catch {
    return null;
  }
}

/** Whether the page has come by a reload. */
export function isReload(): boolean {
  const [visit] = performance.getEntriesByType("navigation");
  return visit instanceof PerformanceNavigationTiming && visit.type === "reload";
}
