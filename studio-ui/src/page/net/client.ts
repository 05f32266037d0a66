// Requests as promises. Those without an answer are asked again when the line is back: the server keeps no state, so a
// restarted one answers them as well.
import type { Fault, Method, Methods, Reply } from "../../protocol";
import type { Hearing, Line, Socket } from "./socket";
import type { ReadonlySignal } from "@preact/signals";

/** What a refused request throws. */
export class Refused extends Error {
  constructor(readonly fault: Fault) {
    super(fault.message);
  }
}

export interface Ask<M extends Method> {
  /** The server works on the latest request of a channel only. */
  channel?: string;
  progress?(words: string): void;
  /** Hears the parts of the answer that are there already; where it is asked again they come again. */
  part?(part: Methods[M]["part"]): void;
  signal?: AbortSignal;
}

export interface Client {
  line: ReadonlySignal<Line>;
  /** Whether the page itself answers, without a server: what exact algebra can tell, and no numbers of poses. */
  alone: boolean;
  ask<M extends Method>(method: M, args: Methods[M]["args"], options?: Ask<M>): Promise<Methods[M]["result"]>;
  retry(): void;
}

interface Waiting {
  text: string;
  done(reply: Reply): void;
  progress?(words: string): void;
  part?(part: unknown): void;
}

export function openClient(open: (on: Hearing) => Socket, alone = false): Client {
  const waiting = new Map<number, Waiting>();
  let last = 0;

  const socket = open({
    open: () => waiting.forEach((request) => socket.send(request.text)),
    message: (text) => answer(JSON.parse(text) as Reply),
  });

  function answer(reply: Reply): void {
    const request = waiting.get(reply.id);
    if (!request) return;
    if ("progress" in reply) return request.progress?.(reply.progress);
    if ("part" in reply) return request.part?.(reply.part);
    waiting.delete(reply.id);
    request.done(reply);
  }

  function ask<M extends Method>(method: M, args: Methods[M]["args"], options: Ask<M> = {}): Promise<Methods[M]["result"]> {
    const id = (last += 1);
    const { channel, progress, part, signal } = options;
    const text = JSON.stringify({ id, do: method, args, ...(channel && { channel }) });
    return new Promise((resolve, reject) => {
      const done = (reply: Reply) => {
        if (!("ok" in reply)) return;
        if (reply.ok) resolve(reply.result as Methods[M]["result"]);
        else reject(new Refused(reply.error));
      };
      waiting.set(id, { text, done, ...(progress && { progress }), ...(part && { part: (found) => part(found as Methods[M]["part"]) }) });
      socket.send(text);
      signal?.addEventListener("abort", () => {
        if (!waiting.delete(id)) return;
        last += 1;
        socket.send(JSON.stringify({ id: last, do: "cancel", args: { target: id } }));
        reject(new Refused({ kind: "cancelled", message: "Cancelled." }));
      });
    });
  }

  return { line: socket.line, alone, ask, retry: socket.retry };
}
