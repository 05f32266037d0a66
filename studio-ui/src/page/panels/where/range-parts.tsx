// What maps of whole ranges and certificates show alike: the parts of the volume, and the boxes as a picture.
import type { BoxesAnswer } from "../../../protocol";

interface Props {
  result: BoxesAnswer;
}

/** How much of the volume is what, as one bar and in words. */
export function Shares({ result: { shares, decided, so_much } }: Props) {
  return (
    <div class="shares">
      <div class="volume" aria-hidden="true">
        {shares.map(({ kind, share }) => (
          <span key={kind} class={kind} style={{ width: `${100 * share}%` }} />
        ))}
      </div>
      <ul aria-label="Parts of the volume">
        {shares.map(({ kind, words }) => (
          <li key={kind} class={kind} data-testid="boxes-share" data-kind={kind}>
            {words}
          </li>
        ))}
      </ul>
      <p class="tip" data-testid="boxes-decided" data-decided={decided}>
        {so_much}
      </p>
    </div>
  );
}

export const BoxesPicture = ({ result: { picture, seen } }: Props) =>
  picture ? (
    <div class="plot">
      <img src={`data:image/svg+xml;base64,${picture}`} alt={seen} data-testid="boxes-picture" />
    </div>
  ) : null;

export const Moved = () => (
  <p class="tip">The robot has moved since: the coordinates without a range are those of the pose that was asked about.</p>
);
