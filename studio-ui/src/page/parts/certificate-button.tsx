// The certificate of an answer: made when it is asked for, kept as a file, with what checks it again.
import { useState } from "preact/hooks";
import type { CertificateFile, CertificateFileArgs, Fault } from "../../protocol";
import { download } from "../lib/download";
import { madeOf, sizeOf } from "../panels/take-away/making";
import { faultOf } from "../state/studying";
import { useStore } from "./context";
import { FaultBox } from "./fault-box";
import { Icon } from "./icon";

interface Props {
  what: CertificateFileArgs["what"];
  /** What was asked, with its source. */
  asked: Omit<CertificateFileArgs, "what" | "args"> & object;
}

export function CertificateButton({ what, asked }: Props) {
  const { client } = useStore();
  const [made, keep] = useState<{ of: object; found: CertificateFile } | null>(null);
  const [fault, tell] = useState<{ of: object; fault: Fault } | null>(null);
  const [busy, work] = useState(false);
  const found = made?.of === asked ? made.found : null;

  async function save(): Promise<void> {
    work(true);
    tell(null);
    try {
      const answer = found ?? (await client.ask("certificate", { source: asked.source, what, args: { ...asked } }));
      keep({ of: asked, found: answer });
      download(madeOf(answer.file));
    } catch (error) {
      tell({ of: asked, fault: faultOf(error) });
    }
    work(false);
  }

  return (
    <div class="kept">
      <button type="button" disabled={busy} onClick={() => void save()} data-testid={`${what}-certificate`}>
        {busy ? <span class="spinner" aria-hidden="true" /> : <Icon name="take-away" size={15} />} Certificate{" "}
        {found && <span class="size">{sizeOf(madeOf(found.file).blob.size)}</span>}
      </button>
      <Checked text={found?.check ?? "A file that a program without gcrules checks."} />
      {fault?.of === asked && <FaultBox fault={fault.fault} />}
    </div>
  );
}

/** How a file is checked again, its commands as code. */
export const Checked = ({ text, children }: { text: string; children?: preact.ComponentChildren }) => (
  <p>
    {text.split("`").map((part, i) => (i % 2 ? <code key={i}>{part}</code> : part))}
    {children}
  </p>
);
