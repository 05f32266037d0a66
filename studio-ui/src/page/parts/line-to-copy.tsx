// Lines to copy, with the files that they name.
import type { Repeated } from "../../protocol";
import { download } from "../lib/download";
import { useStore } from "./context";
import { Icon } from "./icon";
import "./line-to-copy.css";

interface Props {
  /** What the lines repeat, and in which language. */
  title: string;
  language: string;
  text: string;
  files: Repeated["files"];
  /** Ending of the names by which the buttons are found. */
  name: string;
}

export function LineToCopy({ title, language, text, files, name }: Props) {
  const copy = useCopy();
  return (
    <div class="line-to-copy">
      <div class="line">
        <pre class="mono" tabIndex={0} aria-label={`${title}, ${language}`}>
          {text}
        </pre>
        <button type="button" onClick={() => copy(text, title)} aria-label={`Copy: ${title}`} data-testid={`repeat-copy-${name}`}>
          Copy
        </button>
      </div>
      {files.map((file) => (
        <p class="tip" key={file.name}>
          It reads <code>{file.name}</code>.{" "}
          <button
            type="button"
            class="quiet"
            onClick={() => download({ name: file.name, blob: new Blob([file.text], { type: "text/plain" }) })}
            data-testid={`repeat-file-${name}`}
          >
            <Icon name="take-away" size={14} /> Save this file
          </button>
        </p>
      ))}
    </div>
  );
}

/** Puts a text where it can be pasted, and tells. */
export function useCopy(): (text: string, title: string) => void {
  const { front } = useStore();
  return (text, title) =>
    void navigator.clipboard.writeText(text).then(
      () => front.tell(`${title}: copied`),
      () => front.tell("The browser does not allow copying: select the lines and copy them"),
    );
}
