// All keys, in groups.
import { PARTS } from "../actions/parts-keys";
import { actionsOf, GROUPS } from "../actions/table";
import { useStore } from "../parts/context";
import { Icon } from "../parts/icon";
import { Keycaps } from "../parts/keycaps";
import { Modal } from "../parts/modal";

export function KeyList({ onClose }: { onClose(): void }) {
  const store = useStore();
  const { single } = store.taste;
  const actions = actionsOf(store).filter(({ keys }) => keys);
  return (
    <Modal label="Keys" class="key-list" testid="key-list" onClose={onClose}>
      <header>
        <h2>Keys</h2>
        <label>
          <input type="checkbox" checked={single.value} data-testid="single-keys" onChange={(event) => (single.value = event.currentTarget.checked)} />
          Keys without Ctrl act
        </label>
        <button type="button" class="tool" aria-label="Close" title="Close" onClick={onClose} data-testid="key-list-close">
          <Icon name="close" />
        </button>
      </header>
      <div class="groups" tabIndex={0} role="group" aria-label="Keys in groups">
        {GROUPS.map((group) => (
          <Group
            key={group}
            title={group}
            rows={actions.filter((action) => action.group === group).map(({ keys = [], title }) => [keys, title])}
          />
        ))}
        {PARTS.map(({ part, rows }) => (
          <Group key={part} title={part} rows={rows.map(([keys, words]) => [[keys], words])} />
        ))}
      </div>
    </Modal>
  );
}

function Group({ title, rows }: { title: string; rows: readonly (readonly [readonly string[], string])[] }) {
  if (rows.length === 0) return null;
  return (
    <section>
      <h3>{title}</h3>
      <dl>
        {rows.map(([keys, words]) => (
          <div key={words} data-keys={keys.join(", ")}>
            <dt>{words}</dt>
            <dd>
              {keys.map((one) => (
                <Keycaps key={one} keys={one} />
              ))}
            </dd>
          </div>
        ))}
      </dl>
    </section>
  );
}
