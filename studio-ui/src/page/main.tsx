// The page of `gcrules studio`.
import { render } from "preact";
import { openClient } from "./net/client";
import { StoreProvider } from "./parts/context";
import { Shell } from "./shell/shell";
import { arriving, readFragment } from "./state/fragment";
import { createStore, type Store } from "./state/store";
import "katex/dist/katex.min.css";
import "./styles/index.css";

declare global {
  interface Window {
    /** For tests: the store, whose `space.viewer` tells where points are seen. */
    gcrules?: Store;
  }
}

async function start(root: HTMLElement): Promise<void> {
  const store = createStore(openClient(`ws://${location.host}/ws`), await readFragment(arriving()));
  window.gcrules = store;
  root.replaceChildren();
  render(
    <StoreProvider value={store}>
      <Shell store={store} />
    </StoreProvider>,
    root,
  );
}

const root = document.getElementById("studio");
if (root) void start(root);
