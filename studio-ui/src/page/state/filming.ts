// Films of the picture in 3D: the way played once, or the gained motion to and fro. On a slow machine a film has fewer frames, and lasts as long.
import { Refused } from "../net/client";
import { samePose } from "./doc";
import type { Store } from "./store";

export type Film = "way" | "motion";

const TYPES = ["video/webm;codecs=vp8", "video/webm;codecs=vp9", "video/webm"];
const RATE = 30; // frames a second
const LASTS: Record<Film, number> = { way: 5, motion: 4.8 }; // seconds
const SWING = 2.4; // seconds for a swing to and fro
const PATIENCE = 300; // milliseconds that a frame waits for the numbers of its pose

/** Raises where there is nothing to film, or no means. */
export async function filmed(store: Store, what: Film, signal: AbortSignal, tell: (words: string) => void): Promise<Blob> {
  const viewer = store.space.viewer.peek();
  const type = typeof MediaRecorder === "undefined" ? undefined : TYPES.find((one) => MediaRecorder.isTypeSupported(one));
  const canvas = document.createElement("canvas");
  const frameAt = FRAMES[what](store);
  if (!viewer || !type || !viewer.film(canvas, null)) throw new Error("this browser cannot record films of the picture");

  const stream = canvas.captureStream(RATE);
  const recorder = new MediaRecorder(stream, { mimeType: type, videoBitsPerSecond: 8e6 });
  const parts: Blob[] = [];
  const ended = new Promise<void>((done) => (recorder.onstop = () => done()));
  recorder.ondataavailable = ({ data }) => void parts.push(data);
  recorder.start();
  const start = performance.now();
  try {
    for (let share = 0, shown = -1; shown < 1; share = Math.min((performance.now() - start) / (1000 * LASTS[what]), 1)) {
      if (signal.aborted) throw new Refused({ kind: "cancelled", message: "Cancelled." });
      const due = performance.now() + 1000 / RATE;
      viewer.film(canvas, await frameAt(share));
      shown = share;
      tell(`Filming, ${Math.round(100 * share)} %`);
      await rested(due - performance.now());
    }
  } finally {
    recorder.stop();
    await ended;
    stream.getTracks().forEach((track) => track.stop());
    await frameAt(null);
  }
  return new Blob(parts, { type: "video/webm" });
}

/** Brings the page to a share of the film and tells how far the gained motion has swung; null puts it back. */
type FrameAt = (share: number | null) => Promise<number | null>;

const FRAMES: Record<Film, (store: Store) => FrameAt> = {
  way({ timeline, posing, pose$ }) {
    const end = timeline.proof.peek()?.end;
    if (!end || !timeline.proof.peek()?.samples.some(({ pose }) => pose !== null)) {
      throw new Error("there is no way to play: move the robot, or give waypoints");
    }
    const before = timeline.at.peek();
    timeline.pause();
    return async (share) => {
      timeline.lead(share === null ? before : share * end);
      const until = performance.now() + PATIENCE;
      const there = () => posing.numbers.peek() !== null && samePose(posing.numbers.peek()!.pose, pose$.peek());
      while (!there() && performance.now() < until) await rested(5);
      await painted();
      return null;
    };
  },
  motion({ posing }) {
    if (!posing.numbers.peek()?.motion) throw new Error("the platform gains no motion in this pose: go to a singular one");
    return async (share) => {
      await painted();
      return share === null ? null : Math.sin((2 * Math.PI * share * LASTS.motion) / SWING);
    };
  },
};

const rested = (wait: number): Promise<void> => new Promise((done) => setTimeout(done, Math.max(wait, 0)));
const painted = (): Promise<void> => new Promise((done) => requestAnimationFrame(() => done()));
