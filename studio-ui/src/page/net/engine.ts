// The engine in the page, in place of a server: a worker that answers one request after the other. It hears nothing while it
// computes, so what nobody waits for any more ends it, and another one begins.
import { signal } from "@preact/signals";
import type { Fault } from "../../protocol";
import type { Hearing, Line, Socket } from "./socket";

interface Request {
  id: number;
  do: string;
  args: { target?: number };
  channel?: string;
}

interface Asked extends Request {
  text: string;
}

/** What the worker says; see docs/assets/try/worker.mjs. */
type Said =
  | { kind: "ready" }
  | { kind: "piece"; id: number; piece: string }
  | { kind: "answer"; id: number; reply: string }
  | { kind: "fault"; id?: number; text: string };

const PATIENCE = 2000; // milliseconds in which an answer that nobody waits for may still come: to begin anew takes longer
const SUPERSEDED: Fault = { kind: "superseded", message: "a later request has taken its place" };

export function openEngine(url: URL, on: Hearing): Socket {
  const line = signal<Line>("connecting");
  let worker: Worker | null = null;
  let running: Asked | null = null;
  let waiting: Asked[] = [];

  function start(): void {
    worker?.terminate();
    running = null;
    waiting = []; // what still waits for an answer is asked again when the line is open
    line.value = "connecting";
    const mine = new Worker(url, { type: "module" });
    worker = mine;
    mine.onmessage = ({ data }: MessageEvent<Said>) => void (mine === worker && hear(data));
    mine.onerror = () => void (mine === worker && lose());
  }

  function lose(): void {
    worker?.terminate();
    worker = null;
    line.value = "lost";
  }

  function hear(said: Said): void {
    if (said.kind === "ready") {
      line.value = "open";
      return on.open();
    }
    if (said.kind === "piece") return on.message(said.piece);
    if (said.kind === "answer") {
      running = null;
      on.message(said.reply);
      return next();
    }
    if (said.id === undefined) return lose();
    refuse(said.id, { kind: "fault", message: said.text });
    start(); // after a fault of its own an engine is not to be relied on
  }

  const refuse = (id: number, error: Fault): void => on.message(JSON.stringify({ id, ok: false, error }));

  function next(): void {
    if (running) return;
    running = waiting.shift() ?? null;
    if (running) worker?.postMessage({ id: running.id, kind: "request", text: running.text });
  }

  /** Ends the work on a request, unless it ends soon by itself. */
  function giveUp(asked: Asked, refused: Fault | null): void {
    window.setTimeout(() => {
      if (running !== asked) return;
      if (refused) refuse(asked.id, refused);
      start();
    }, PATIENCE);
  }

  function send(text: string): boolean {
    if (line.peek() !== "open") return false;
    const request = JSON.parse(text) as Request;
    if (request.do === "cancel") {
      waiting = waiting.filter(({ id }) => id !== request.args.target);
      if (running && running.id === request.args.target) giveUp(running, null);
      return true;
    }
    const { channel } = request;
    const later = channel === undefined ? [] : waiting.filter((other) => other.channel === channel);
    waiting = [...waiting.filter((other) => !later.includes(other)), { ...request, text }];
    later.forEach(({ id }) => refuse(id, SUPERSEDED));
    if (channel !== undefined && running?.channel === channel) giveUp(running, SUPERSEDED);
    next();
    return true;
  }

  start();

  return {
    line,
    retryAt: signal(0),
    send,
    retry: () => void (line.peek() === "lost" && start()),
    close: lose,
  };
}
