// A fault in words, with its hint and the place in the text that was sent.
import type { Fault } from "../../protocol";

export function FaultBox({ fault, text }: { fault: Fault; text?: string }) {
  return (
    <div class={`fault ${fault.kind}`} role="alert" data-testid="fault">
      <p class="message">{fault.message}</p>
      {text !== undefined && fault.place && <Place text={text} place={fault.place} />}
      {fault.hint && <p class="hint">{fault.hint}</p>}
      {fault.more?.map((other, i) => (
        <FaultBox key={i} fault={other} {...(text !== undefined && { text })} />
      ))}
    </div>
  );
}

function Place({ text, place }: { text: string; place: { start: number; end: number; line: number } }) {
  const from = text.lastIndexOf("\n", place.start - 1) + 1;
  const until = text.indexOf("\n", place.start);
  const line = text.slice(from, until < 0 ? text.length : until);
  const [start, end] = [place.start - from, Math.max(Math.min(place.end - from, line.length), place.start - from + 1)];
  return (
    <pre class="place" tabIndex={0} aria-label={`line ${place.line}`} data-line={text.includes("\n") ? place.line : undefined}>
      {line.slice(0, start)}
      <mark>{line.slice(start, end) || " "}</mark>
      {line.slice(end)}
    </pre>
  );
}
