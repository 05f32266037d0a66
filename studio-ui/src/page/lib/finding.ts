// Finding by words that people type.

/** In small letters, without accents. */
export const folded = (text: string): string => text.toLowerCase().normalize("NFD").replace(/\p{M}/gu, "");

/** Words without the signs inside them: "3-rp*s" is "3rps". */
const joined = (text: string): string => text.replace(/[^\p{L}\p{N}\s]/gu, "");

export const wordsOf = (query: string): string[] => folded(query).split(/\s+/).filter(Boolean);

/** Whether a word stands in a folded text; "3rps" and "3-RPS" are the same. */
export function holds(text: string, word: string): boolean {
  const bare = word.replace(/[^\p{L}\p{N}]/gu, "");
  return text.includes(word) || (bare !== "" && joined(text).includes(bare));
}
