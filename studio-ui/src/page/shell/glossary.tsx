// All terms with their meanings.
import { useEffect, useRef, useState } from "preact/hooks";
import { GLOSSARY } from "../../protocol";
import { folded, holds, wordsOf } from "../lib/finding";
import { useStore } from "../parts/context";
import { Icon } from "../parts/icon";
import { Modal } from "../parts/modal";

export function Glossary({ onClose }: { onClose(): void }) {
  const { front } = useStore();
  const [query, ask] = useState("");
  const list = useRef<HTMLDListElement>(null);
  const words = wordsOf(query);
  const found = GLOSSARY.filter(({ term, forms, meaning }) => words.every((word) => holds(folded(`${term} ${forms} ${meaning}`), word)));
  useEffect(() => list.current?.querySelector("[data-wanted=true]")?.scrollIntoView({ block: "center" }), []);
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
        {found.map(({ term, meaning, guide }) => (
          <div key={term} data-wanted={front.wanted.value === term} data-testid={`entry-${term.replaceAll(" ", "-")}`}>
            <dt>{term}</dt>
            <dd>
              {meaning} <span class="guide">In the guide: {guide}</span>
            </dd>
          </div>
        ))}
      </dl>
      {found.length === 0 && <p class="none">Nothing matches “{query}”.</p>}
    </Modal>
  );
}
