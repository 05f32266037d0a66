// Pictures at the pace of the machine, numbers first: a picture is made after the text of its frame has been painted,
// and where pictures are slow (software rendering) half of the time is left free of them.
const QUICK = 40; // milliseconds from one picture to the next that need no care

export interface Pace {
  /** A picture soon; `patience` milliseconds may pass for numbers to come first. */
  ask(patience: number): void;
  stop(): void;
}

export function createPace(draw: () => void): Pace {
  const channel = new MessageChannel();
  let timer = 0;
  let frame = 0;
  let due = Infinity;
  let free = 0; // no picture before
  let ended = false;

  channel.port1.onmessage = () => {
    if (ended) return;
    due = Infinity;
    const start = performance.now();
    draw();
    requestAnimationFrame(() =>
      requestAnimationFrame((now) => {
        const cost = now - start;
        free = cost > QUICK ? now + cost : 0;
      }),
    );
  };

  function begin(): void {
    frame = requestAnimationFrame(() => channel.port2.postMessage(null));
  }

  function ask(patience: number): void {
    const now = performance.now();
    const at = Math.max(now + patience, free);
    if (at >= due) return;
    due = at;
    cancelAnimationFrame(frame);
    window.clearTimeout(timer);
    if (at <= now) begin();
    else timer = window.setTimeout(begin, at - now);
  }

  return {
    ask,
    stop() {
      ended = true;
      window.clearTimeout(timer);
      cancelAnimationFrame(frame);
    },
  };
}
