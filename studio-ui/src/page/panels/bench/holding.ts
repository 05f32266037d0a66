// Whether what was said of a statement is true of a text that has been changed since.

/** The rest of the line, and whether the next one is indented, so that it may go on with the statement. */
const after = (text: string, end: number): string => /^[^\n]*(?:\n[ \t])?/.exec(text.slice(end))?.[0] ?? "";

/** Whether a statement that ended here in one text is the same in another one, and all before it, too. */
export const holds = (end: number, before: string, now: string): boolean =>
  before === now || (now.slice(0, end) === before.slice(0, end) && after(now, end) === after(before, end));
