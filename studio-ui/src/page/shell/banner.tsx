// What is said calmly above all panels: the server is away, or the link by which the page came cannot be read.
import type { Line } from "../net/socket";
import { useStore } from "../parts/context";

export function Banner() {
  const { client, unread } = useStore();
  const line = client.line.value;
  if (client.alone && line !== "open") return <Engine line={line} retry={client.retry} />;
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

/** Of the engine in the page: it is being loaded, or cannot be. */
function Engine({ line, retry }: { line: Line; retry(): void }) {
  return (
    <div class="banner" role="status" data-testid="line" data-line={line}>
      {line === "connecting" ? (
        <>
          <span class="spinner" aria-hidden="true" />
          <span>The engine is being started in this page; the first time about 20 MB are loaded.</span>
        </>
      ) : (
        <>
          <span>The engine cannot be started here: the browser or the place that this page comes from does not allow it.</span>
          <button type="button" class="quiet" onClick={retry}>
            Try again
          </button>
        </>
      )}
    </div>
  );
}
