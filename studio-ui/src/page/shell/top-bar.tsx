// Name of the study, undo and redo, link, theme.
import { useEffect, useState } from "preact/hooks";
import type { Sketch } from "../../protocol";
import { writeFragment } from "../state/fragment";
import { useStore } from "../parts/context";
import { Icon } from "../parts/icon";

export function TopBar() {
  const store = useStore();
  const study = store.study.value;
  const theme = store.taste.theme.value;
  const dark = theme === "dark";
  const drawn = store.panel$.value === "draw";
  const title = drawn ? titleOf(store.sketch$.value) : study?.title;
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
            <Title>{title}</Title>
            {!drawn && study?.invented && (
              <span class="tag" title="No coordinates were given: the picture and the numbers are of a sample shape">
                sample shape
              </span>
            )}
          </>
        )}
        {!title && Title === "h1" && <h1 class="sr-only">gcrules studio</h1>}
      </div>
      <div class="tools" role="toolbar" aria-label="Document">
        <Tool icon="undo" label="Undo (Ctrl Z)" disabled={!store.canUndo.value} act={store.undo} testid="undo" />
        <Tool icon="redo" label="Redo (Ctrl Shift Z)" disabled={!store.canRedo.value} act={store.redo} testid="redo" />
        <CopyLink />
        <Tool
          icon={dark ? "sun" : "moon"}
          label={dark ? "Light" : "Dark"}
          act={() => (store.taste.chosen.value = dark ? "light" : "dark")}
          testid="theme"
        />
      </div>
    </header>
  );
}

/** On the sheet it is the drawing that counts, not what was studied before. */
const titleOf = (sketch: Sketch | null): string =>
  sketch && Object.keys(sketch.points).length > 0 ? sketch.title || "Drawing without a title" : "Empty sheet";

interface ToolProps {
  icon: "undo" | "redo" | "sun" | "moon" | "link" | "ok";
  label: string;
  disabled?: boolean;
  testid: string;
  act(): void;
}

function Tool({ icon, label, disabled = false, testid, act }: ToolProps) {
  return (
    <button type="button" class="tool" title={label} aria-label={label} disabled={disabled} onClick={act} data-testid={testid}>
      <Icon name={icon} />
    </button>
  );
}

function CopyLink() {
  const { doc } = useStore();
  const [copied, tell] = useState(false);
  async function copy(): Promise<void> {
    const link = location.origin + location.pathname + (await writeFragment(doc.peek()));
    await navigator.clipboard.writeText(link);
    tell(true);
    setTimeout(() => tell(false), 1600);
  }
  return (
    <Tool
      icon={copied ? "ok" : "link"}
      label={copied ? "The link is copied" : "Copy a link that restores this state"}
      act={() => void copy().catch(() => tell(false))}
      testid="copy-link"
    />
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
