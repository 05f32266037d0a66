// The link that restores all of this: the state is in its fragment, which is never sent to anyone.
import { useEffect, useState } from "preact/hooks";
import { useStore } from "../../parts/context";
import { Icon } from "../../parts/icon";
import { LONGEST_LINK } from "../../../protocol";
import { linkOf } from "../../state/fragment";

export function Link() {
  const { doc } = useStore();
  const [link, write] = useState("");
  const [short, shorten] = useState(false);
  const [said, say] = useState("");
  const now = doc.value;
  useEffect(() => {
    let current = true;
    void linkOf(now).then((found) => {
      if (!current) return;
      write(location.origin + location.pathname + found.fragment);
      shorten(found.short);
    });
    return () => void (current = false);
  }, [now]);

  async function copy(): Promise<void> {
    try {
      await navigator.clipboard.writeText(link);
      say("The link is copied.");
    } catch {
      say("The browser does not allow copying: select the link and copy it.");
    }
    setTimeout(() => say(""), 2500);
  }

  return (
    <section class="take-link">
      <h3>Link</h3>
      <p>Restores robot, pose, way, commands, expressions and drawing in a studio on this machine. The state is in the link itself.</p>
      <div class="line">
        <input type="text" class="mono" readOnly value={link} aria-label="Link" onFocus={(event) => event.currentTarget.select()} data-testid="link" />
        <button type="button" class="primary" onClick={() => void copy()} data-testid="link-copy">
          <Icon name="link" size={15} /> Copy
        </button>
      </div>
      {(short || link.length > LONGEST_LINK) && (
        <p class="tip" data-testid="link-long">
          {short
            ? `The way is not in the link, which would be longer than ${LONGEST_LINK.toLocaleString("en")} characters with it: a project keeps it, and so does a table (Along the way, Save CSV).`
            : `The link has ${link.length.toLocaleString("en")} characters; programs may cut one of more than ${LONGEST_LINK.toLocaleString("en")}. A project keeps the same.`}
        </p>
      )}
      <p class="said" role="status">
        {said}
      </p>
    </section>
  );
}
