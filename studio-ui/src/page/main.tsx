// The page of `gcrules studio`.
import { render } from "preact";
import { openClient, type Client } from "./net/client";
import { openEngine } from "./net/engine";
import { openSocket } from "./net/socket";
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

/** The server that has sent the page, or the engine that a page without a server names: `data-engine` is its worker. */
function clientOf({ dataset: { engine } }: HTMLElement): Client {
  if (engine === undefined) return openClient((on) => openSocket(`ws://${location.host}/ws`, on));
  return openClient((on) => openEngine(new URL(engine, location.href), on), true);
}

async function start(root: HTMLElement): Promise<void> {
  const store = createStore(clientOf(root), await readFragment(arriving()));
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
