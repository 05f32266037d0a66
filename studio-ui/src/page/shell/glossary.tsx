// All terms with their meanings, in which other terms lead to theirs.
import { useEffect, useRef, useState } from "preact/hooks";
import { GLOSSARY } from "../../protocol";
import { folded, holds, wordsOf } from "../lib/finding";
import { inTerms, type GlossaryTerm } from "../lib/terms";
import { useStore } from "../parts/context";
import { GuideLink } from "../parts/guide-link";
import { Icon } from "../parts/icon";
import { Modal } from "../parts/modal";

export function Glossary({ onClose }: { onClose(): void }) {
  const { front } = useStore();
  const [query, ask] = useState("");
  const list = useRef<HTMLDListElement>(null);
  const words = wordsOf(query);
  const found = GLOSSARY.filter(({ term, forms, meaning }) => words.every((word) => holds(folded(`${term} ${forms} ${meaning}`), word)));
  const wanted = front.wanted.value;
  useEffect(() => list.current?.querySelector("[data-wanted=true]")?.scrollIntoView({ block: "center" }), [wanted]);
  const lead = (term: string): void => {
    ask("");
    front.glossary(term);
  };
  return (
    <Modal label="Glossary" class="glossary" testid="glossary" onClose={onClose}>
      <header>
        <h2>Glossary</h2>
        <input type="search" placeholder="Search" aria-label="Search the glossary" value={query} onInput={(event) => ask(event.currentTarget.value)} data-testid="glossary-search" />
        <button type="button" class="tool" aria-label="Close" title="Close" onClick={onClose} data-testid="glossary-close">
          <Icon name="close" />
        </button>
      </header>
      <dl ref={list} tabIndex={0} aria-label="Terms">
        {found.map((entry) => (
          <div key={entry.term} data-wanted={wanted === entry.term} data-testid={`entry-${entry.term.replaceAll(" ", "-")}`}>
            <dt>{entry.term}</dt>
            <dd>
              <Meaning entry={entry} lead={lead} />
              <span class="guide">
                <GuideLink entry={entry} />
              </span>
            </dd>
          </div>
        ))}
      </dl>
      {found.length === 0 && <p class="none">Nothing matches “{query}”.</p>}
    </Modal>
  );
}

function Meaning({ entry, lead }: { entry: GlossaryTerm; lead(term: string): void }) {
  const pieces = inTerms(entry.meaning, new Set([entry.term]));
  return (
    <>
      {pieces.map(({ text, entry: other }) =>
        other ? (
          <button type="button" class="term" onClick={() => lead(other.term)}>
            {text}
          </button>
        ) : (
          text
        ),
      )}
    </>
  );
}
