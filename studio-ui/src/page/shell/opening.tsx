// While a structure is opened, or when it cannot be.
import { useStore } from "../parts/context";
import { FaultBox } from "../parts/fault-box";

export function Opening() {
  const { loaded, again, go } = useStore();
  const now = loaded.value;
  if (now.state === "loading") {
    return (
      <div class="opening" role="status" data-testid="opening">
        <span class="spinner large" aria-hidden="true" />
        <p>{now.words} …</p>
        <button type="button" onClick={now.stop} data-testid="open-stop">
          Stop
        </button>
      </div>
    );
  }
  if (now.state === "failed") {
    const text = now.source.kind === "legs" ? now.source.legs : now.source.kind === "file" ? now.source.text : undefined;
    return (
      <div class="opening">
        <FaultBox fault={now.fault} {...(text !== undefined && { text })} />
        <p class="buttons">
          <button type="button" onClick={again}>
            Try again
          </button>
          <button type="button" class="primary" onClick={() => go({ panel: "start" })}>
            Choose another
          </button>
        </p>
      </div>
    );
  }
  return (
    <div class="opening">
      <p>Nothing is open yet.</p>
      <button type="button" class="primary" onClick={() => go({ panel: "start" })}>
        Choose a structure
      </button>
    </div>
  );
}
