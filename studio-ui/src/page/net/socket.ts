// A websocket that comes back by itself. What waits for an answer when the line drops is the client's concern.
import { signal, type ReadonlySignal } from "@preact/signals";

export type Line = "connecting" | "open" | "lost";

export interface Socket {
  line: ReadonlySignal<Line>;
  /** When the next attempt is made (performance.now), while the line is lost. */
  retryAt: ReadonlySignal<number>;
  send(text: string): boolean;
  retry(): void;
  close(): void;
}

const FIRST = 300; // milliseconds before the first new attempt; doubles up to LAST
const LAST = 5000;

/** What hears of a line: it is open (again), and what comes over it. */
export interface Hearing {
  open(): void;
  message(text: string): void;
}

export function openSocket(url: string, on: Hearing): Socket {
  const line = signal<Line>("connecting");
  const retryAt = signal(0);
  let socket: WebSocket | null = null;
  let wait = FIRST;
  let timer = 0;
  let ended = false;

  function connect(): void {
    window.clearTimeout(timer);
    const mine = new WebSocket(url);
    socket = mine;
    mine.onopen = () => {
      wait = FIRST;
      line.value = "open";
      on.open();
    };
    mine.onmessage = (event) => on.message(String(event.data));
    mine.onclose = () => {
      if (ended || socket !== mine) return;
      line.value = "lost";
      retryAt.value = performance.now() + wait;
      timer = window.setTimeout(connect, wait);
      wait = Math.min(2 * wait, LAST);
    };
  }

  function retry(): void {
    if (line.value === "open" || ended) return;
    wait = FIRST;
    connect();
  }

  connect();
  window.addEventListener("online", retry);
  document.addEventListener("visibilitychange", () => document.hidden || retry());

  return {
    line,
    retryAt,
    send(text) {
      if (socket?.readyState !== WebSocket.OPEN) return false;
      socket.send(text);
      return true;
    },
    retry,
    close() {
      ended = true;
      window.clearTimeout(timer);
      socket?.close();
    },
  };
}
