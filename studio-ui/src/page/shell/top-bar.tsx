// Name of the study, and the actions that are always at hand.
import { useEffect } from "preact/hooks";
import type { Sketch } from "../../protocol";
import { actionOf, canBeDone, titleOf as titled, type Action } from "../actions/table";
import { useStore } from "../parts/context";
import { Icon, type IconName } from "../parts/icon";

export function TopBar() {
  const store = useStore();
  const study = store.study.value;
  const dark = store.taste.theme.value === "dark";
  const drawn = store.panel$.value === "draw";
  const title = drawn ? (store.built.value ?? titleOf(store.sketch$.value)) : study?.title;
  const Title = store.panel$.value === "start" ? "strong" : "h1"; // the start has a heading of its own
  useEffect(() => {
    document.title = title ? `${title} · gcrules studio` : "gcrules studio";
  }, [title]);
  return (
    <header class="top-bar">
      <button type="button" class="brand" onClick={() => store.go({ panel: "start" })} aria-label="gcrules studio, start">
        <Mark /> gcrules <span>studio</span>
      </button>
      <div class="study" data-testid="title">
        {title && (
          <>
            <Title title={title}>{title}</Title>
            {!drawn && study?.invented && (
              <span class="tag" title="No coordinates were given: the picture and the numbers are of a sample shape">
                sample shape
              </span>
            )}
            {!drawn && store.sharing.active.value && (
              <span class="tag" title="Python moves this robot too, and follows its moves here" data-testid="shared">
                shared with Python
              </span>
            )}
          </>
        )}
        {!title && Title === "h1" && <h1 class="sr-only">gcrules studio</h1>}
      </div>
      <div class="tools" role="toolbar" aria-label="Document">
        {TOOLS.map(([id, icon]) => (
          <Tool key={id} action={actionOf(store, id)} icon={id === "theme" && dark ? "sun" : icon} />
        ))}
      </div>
    </header>
  );
}

/** On the sheet it is the drawing that counts, not what was studied before. */
const titleOf = (sketch: Sketch | null): string =>
  sketch && Object.keys(sketch.points).length > 0 ? sketch.title || "Drawing without a title" : "Empty sheet";

const TOOLS: readonly (readonly [string, IconName])[] = [
  ["palette", "search"],
  ["keys", "keys"],
  ["undo", "undo"],
  ["redo", "redo"],
  ["repeat", "terminal"],
  ["copy-link", "link"],
  ["theme", "moon"],
];

function Tool({ action, icon }: { action: Action; icon: IconName }) {
  return (
    <button
      type="button"
      class="tool"
      title={titled(action)}
      aria-label={action.title}
      disabled={!canBeDone(action)}
      onClick={action.act}
      data-testid={action.id}
    >
      <Icon name={icon} />
    </button>
  );
}

/** Four planes through a point. */
function Mark() {
  return (
    <svg class="mark" viewBox="0 0 24 24" width="22" height="22" aria-hidden="true">
      <path d="M12 12L3 6.500l3-3.500z" fill="var(--entity1)" />
      <path d="M12 12l9-5.500-3-3.500z" fill="var(--entity2)" />
      <path d="M12 12l-9 5.500 3 3.500z" fill="var(--entity3)" />
      <path d="M12 12l9 5.500-3 3.500z" fill="var(--entity4)" />
      <circle cx="12" cy="12" r="2.200" fill="var(--ink)" />
    </svg>
  );
}
