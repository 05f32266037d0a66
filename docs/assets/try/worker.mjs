// The engine in a thread of its own, so that the page goes on while it computes; the page ends the thread to stop it.
import { loadPyodide } from "../engine/pyodide.mjs";
import { start } from "./engine.mjs";

const folder = new URL("../engine/", import.meta.url).href;

async function read(name) {
  const found = await fetch(folder + name);
  if (!found.ok) throw new Error(`${name}: ${found.status}`);
  return found.arrayBuffer();
}

const ready = start(loadPyodide, folder, read);
ready.then(
  (engine) => postMessage({ kind: "ready", version: engine.version }),
  (fault) => postMessage({ kind: "fault", text: String(fault) }),
);

addEventListener("message", async ({ data: { id, kind, text } }) => {
  try {
    const engine = await ready;
    const answer = engine[kind](text, (piece, stream) => postMessage({ kind: "piece", id, piece, stream }));
    postMessage({ kind: "answer", id, ...answer });
  } catch (fault) {
    postMessage({ kind: "fault", id, text: String(fault) });
  }
});
