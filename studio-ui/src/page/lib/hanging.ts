// Where the parts of a line of plain text begin.

const FACT = /^ *\S+(?: \S+)*? {2,}(?=\S)/; // a name and, in a column of its own, what is said of it
const MOST = 18;

/** The characters that stand before what goes on when a line is broken. */
export function hangOf(line: string): number {
  const fact = FACT.exec(line)?.[0].length ?? 0;
  return fact > 0 && fact <= MOST ? fact : line.length - line.trimStart().length + 2;
}
