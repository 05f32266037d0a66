// The list of commands: all actions and all structures, found by words and done with Enter.
import { useEffect, useMemo, useRef, useState } from "preact/hooks";
import { actionsOf, canBeDone, GROUPS, structureActions, type Action } from "../actions/table";
import { folded, holds, wordsOf } from "../lib/finding";
import { useStore } from "../parts/context";
import { Icon } from "../parts/icon";
import { Keycaps } from "../parts/keycaps";
import { Modal } from "../parts/modal";
import type { Store } from "../state/store";

const MOST = 60; // rows that are shown at once
const FIRST = 6; // structures that are shown before anything is asked

/** What fits and holds every word: titles that begin with the query first, else in the order of the groups. */
export function matching(store: Store, query: string): Action[] {
  const words = wordsOf(query);
  const structures = structureActions(store);
  const all = [...actionsOf(store).filter(canBeDone), ...(words.length ? structures : structures.slice(0, FIRST))];
  const found = all
    .filter(({ id }) => id !== "palette")
    .filter((action) => words.every((word) => holds(folded(`${action.title} ${action.group} ${action.words ?? ""}`), word)));
  const rank = ({ title }: Action): number => {
    const text = folded(title);
    const [first = ""] = words;
    if (text.startsWith(folded(query.trim()))) return 0;
    return words.every((word) => holds(text, word)) ? (text.startsWith(first) ? 1 : 2) : 3;
  };
  return words.length ? found.sort((a, b) => rank(a) - rank(b) || GROUPS.indexOf(a.group) - GROUPS.indexOf(b.group)) : found.sort(byGroup);
}

const byGroup = (a: Action, b: Action): number => GROUPS.indexOf(a.group) - GROUPS.indexOf(b.group);

export function Palette({ onClose }: { onClose(): void }) {
  const store = useStore();
  const [query, ask] = useState("");
  const [at, goTo] = useState(0);
  const list = useRef<HTMLDivElement>(null);
  const gallery = store.gallery.value;
  const found = useMemo(() => matching(store, query), [store, query, gallery]);
  const shown = found.slice(0, MOST);
  useEffect(() => list.current?.querySelector("[aria-selected=true]")?.scrollIntoView({ block: "nearest" }), [at, query]);

  function run(action: Action | undefined): void {
    if (!action) return;
    onClose();
    action.act();
  }

  function key(event: KeyboardEvent): void {
    const to = { ArrowDown: at + 1, ArrowUp: at - 1, PageDown: at + 8, PageUp: at - 8 }[event.key];
    if (event.key === "Enter") run(shown[at]);
    else if (to !== undefined) goTo(Math.min(Math.max(to, 0), shown.length - 1));
    else return;
    event.preventDefault();
  }

  return (
    <Modal label="Commands" class="palette" testid="commands" onClose={onClose}>
      <label class="asked">
        <Icon name="search" />
        <input
          type="text"
          role="combobox"
          aria-label="What to do, or which structure to open"
          aria-expanded
          aria-autocomplete="list"
          aria-controls="commands"
          aria-activedescendant={shown[at] && `command-${at}`}
          placeholder="What to do, or which structure to open …"
          autocomplete="off"
          spellcheck={false}
          autofocus
          value={query}
          data-testid="command"
          onInput={(event) => (ask(event.currentTarget.value), goTo(0))}
          onKeyDown={key}
        />
      </label>
      <div class="rows" id="commands" role="listbox" aria-label="Commands" ref={list}>
        {shown.map((action, i) => (
          <div
            key={action.id}
            id={`command-${i}`}
            class="row"
            role="option"
            aria-selected={i === at}
            data-testid={`command-${action.id}`}
            onPointerMove={() => goTo(i)}
            onClick={() => run(action)}
          >
            <span class="group">{action.group}</span>
            <span class="title">{action.title}</span>
            {action.isOn && <span class="state">{action.isOn() ? "on" : "off"}</span>}
            {action.keys?.[0] && <Keycaps keys={action.keys[0]} />}
          </div>
        ))}
        {shown.length === 0 && <p class="none">Nothing matches “{query}”.</p>}
      </div>
      <footer>
        <span>
          <Keycaps keys="ArrowUp" /> <Keycaps keys="ArrowDown" /> choose
        </span>
        <span>
          <Keycaps keys="Enter" /> do it
        </span>
        <span class="count" role="status">
          {found.length > shown.length ? `${found.length - shown.length} more: type on` : ""}
        </span>
        <button type="button" class="quiet" onClick={() => void (store.front.dialog.value = "keys")}>
          All keys
        </button>
      </footer>
    </Modal>
  );
}
