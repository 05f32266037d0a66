// What is said calmly above all panels: the server is away, or the link by which the page came cannot be read.
import { useStore } from "../parts/context";

export function Banner() {
  const { client, unread } = useStore();
  const line = client.line.value;
  return (
    <>
      {line === "lost" ? (
        <div class="banner" role="status" data-testid="line" data-line="lost">
          <span class="spinner" aria-hidden="true" />
          <span>
            The studio's server does not answer. Your work is safe in this page; it goes on as soon as <code>gcrules studio</code>{" "}
            runs again.
          </span>
          <button type="button" class="quiet" onClick={client.retry}>
            Try now
          </button>
        </div>
      ) : (
        <div role="status" class="sr-only" data-testid="line" data-line={line} />
      )}
      {unread.value && (
        <div class="banner" role="alert" data-testid="unread">
          <span>
            The link of this page cannot be read: a part of it is missing, or it holds more than a link may. Ask for it again, or for
            the robot's file.
          </span>
          <button type="button" class="quiet" onClick={() => (unread.value = false)}>
            Close
          </button>
        </div>
      )}
    </>
  );
}
