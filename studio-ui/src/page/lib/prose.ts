// Sentences in which names of entities stand ("the planes abc and a*ef meet") and sources, told apart from plain words.
import type { Entity } from "../../protocol";

export type Word = { text: string; entity?: Entity; source?: true };

const SOURCE = /(\[[A-Z][A-Za-z]+\d{4}[a-z]?\])/; // a key of the bibliography

/** Splits a sentence at the names of the entities, which must not stand inside of longer words. */
export function wordsOf(sentence: string, entities: readonly Entity[]): Word[] {
  const names = new Map<string, Entity>();
  for (const entity of entities) {
    if (entity.kind === "point") continue;
    [entity.starred, entity.label].forEach((name) => names.has(name) || names.set(name, entity));
  }
  const longest = [...names.keys()].sort((a, b) => b.length - a.length).map(escaped);
  const named = longest.length ? new RegExp(`(?<![\\w*])(${longest.join("|")})(?![\\w*])`) : /(?!)/;
  return sentence.split(SOURCE).flatMap((part): Word[] => {
    if (SOURCE.test(part)) return [{ text: part.slice(1, -1), source: true }];
    return part
      .split(named)
      .filter((text) => text !== "")
      .map((text) => {
        const entity = names.get(text);
        return entity ? { text, entity } : { text };
      });
  });
}

const escaped = (text: string): string => text.replace(/[.*+?^${}()|[\]\\]/g, "\\$&");
