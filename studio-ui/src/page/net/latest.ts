// Latest wins: one request under way, and of those asked for meanwhile only the newest is sent after it.
export function latest<A, R>(
  send: (args: A) => Promise<R>,
  arrived: (result: R, args: A) => void,
  failed: (error: unknown, args: A) => void,
): (args: A) => void {
  let busy = false;
  let next: { args: A } | null = null;

  async function run(args: A): Promise<void> {
    busy = true;
    try {
      arrived(await send(args), args);
    } catch (error) {
      failed(error, args);
    } finally {
      busy = false;
      const waiting = next;
      next = null;
      if (waiting) void run(waiting.args);
    }
  }

  return (args) => {
    if (busy) next = { args };
    else void run(args);
  };
}
