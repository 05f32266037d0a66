// What a file looks like. The report is shown without its scripts: in 3D it opens from the file.
import { useEffect, useState } from "preact/hooks";
import { Drawing } from "../../parts/drawing";
import type { Thing } from "./formats";
import type { Made } from "./making";

const MOST = 20_000; // characters of a text that are shown

export function Preview({ thing, made }: { thing: Thing; made: Made }) {
  const { text, blob, name } = made;
  if (blob.type === "image/png") return <Picture blob={blob} name={name} />;
  if (text === null) return <p class="none">{name} has no preview.</p>;
  if (thing === "html") return <iframe class="preview page" title="The report" sandbox="" srcdoc={still(text)} data-testid="preview-html" />;
  if (thing === "svg" || thing === "view-svg") {
    return (
      <div class="preview picture" data-testid={`preview-${thing}`}>
        <Drawing svg={text} label={name} />
      </div>
    );
  }
  return (
    <pre class="preview text" tabIndex={0} data-testid={`preview-${thing}`}>
      {text.slice(0, MOST)}
      {text.length > MOST && "\n…"}
    </pre>
  );
}

/** A page without its scripts. */
function still(html: string): string {
  const page = new DOMParser().parseFromString(html, "text/html");
  page.querySelectorAll("script").forEach((script) => script.remove());
  return `<!doctype html>${page.documentElement.outerHTML}`;
}

function Picture({ blob, name }: { blob: Blob; name: string }) {
  const [address, point] = useState<string | null>(null);
  useEffect(() => {
    const made = URL.createObjectURL(blob);
    point(made);
    return () => URL.revokeObjectURL(made);
  }, [blob]);
  return <div class="preview picture">{address && <img src={address} alt={name} data-testid="preview-view-png" />}</div>;
}
