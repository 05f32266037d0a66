// Report, figures and files to take away.
import type { PanelProps } from "./index";

export function TakeAway({ store }: PanelProps) {
  return <p class="none">This panel is not built yet ({store.panel$.value}).</p>;
}
