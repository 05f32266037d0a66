// What is said calmly while the server is away: nothing is lost, the page goes on when it is back.
import { useStore } from "../parts/context";

export function Banner() {
  const { client } = useStore();
  const line = client.line.value;
  if (line !== "lost") return <div role="status" class="sr-only" data-testid="line" data-line={line} />;
  return (
    <div class="banner" role="status" data-testid="line" data-line="lost">
      <span class="spinner" aria-hidden="true" />
      <span>
        The studio's server does not answer. Your work is safe in this page; it goes on as soon as <code>gcrules studio</code> runs
        again.
      </span>
      <button type="button" class="quiet" onClick={client.retry}>
        Try now
      </button>
    </div>
  );
}
