// σ along the path, along which the robot can be led by hand; its singular places; what is not decided.
import { useSignal } from "@preact/signals";
import type { Detour, PathAnswer, PathArgs, Pose } from "../../../protocol";
import { short } from "../../lib/format";
import { CertificateButton } from "../../parts/certificate-button";
import { useStore } from "../../parts/context";
import { Drawing } from "../../parts/drawing";
import { Icon } from "../../parts/icon";
import { Facts } from "./facts";
import { Plot } from "./plot";
import { nearest } from "./samples";

const ICONS = { regular: "ok", close: "warn", singular: "stop" } as const;

export function PathResult({ asked, result }: { asked: PathArgs; result: PathAnswer }) {
  const { edit, settle, moving, timeline } = useStore();
  const { samples, places, stretches, end, frame, verdict, more, detour } = result;
  const at = useSignal(asked.to === undefined ? samples.length - 1 : 0); // where the robot was when it was asked
  const shown = samples[at.value];
  const stops = samples.flatMap(({ parameter, pose }) => (pose && Number.isInteger(parameter) ? [pose] : []));

  function lead(index: number): void {
    at.value = index;
    const pose = samples[index]?.pose;
    if (!pose) return;
    moving.stop();
    edit({ pose }, "path");
  }

  function go(parameter: number, pose: Pose): void {
    at.value = nearest(samples, parameter);
    moving.to(pose);
  }

  function key(event: KeyboardEvent): void {
    const by = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1 }[event.key];
    if (by === undefined) return;
    event.preventDefault();
    lead(Math.min(Math.max(at.value + by, 0), samples.length - 1));
  }

  const move = ([x]: readonly [number, number]) => lead(nearest(samples, x * end));
  return (
    <div class={`answer ${verdict}`}>
      <p class="word" role="status" data-testid="path-verdict" data-verdict={verdict}>
        <Icon name={ICONS[verdict]} size={18} /> {verdict === "close" ? "Close to singular" : verdict === "singular" ? "Singular" : "Regular"}
      </p>
      {detour && <DetourNote detour={detour} show={(k) => lead(nearest(samples, k))} />}
      {detour?.outcome === "none" && <CertificateButton what="path" asked={asked} />}
      <p class="reason">{result.reason}</p>
      <Plot
        frame={frame}
        picture={<Drawing svg={result.svg} label="Margin along the path" />}
        testid="path-plot"
        onPress={move}
        onRelease={settle}
      >
        {shown && <span class="cursor" style={{ left: `${(100 * shown.parameter) / end}%` }} />}
      </Plot>
      {shown && (
        <div class="lead" style={{ "--left": frame.left, "--width": frame.right - frame.left }}>
          <input
            type="range"
            class="slider"
            min={0}
            max={end}
            step="any"
            value={shown.parameter}
            aria-label="Place on the path"
            aria-valuetext={`parameter ${short(shown.parameter, 3)}`}
            data-testid="path-lead"
            style={{ "--from": "0%", "--to": `${(100 * shown.parameter) / end}%` }}
            onInput={(event) => lead(nearest(samples, Number(event.currentTarget.value)))}
            onKeyDown={key}
            onPointerUp={settle}
            onBlur={settle}
          />
          <p class="readout" data-testid="path-readout">
            parameter <b>{shown.parameter.toFixed(3)}</b> · σ <b>{short(shown.margin, 3)}</b>
            {!shown.pose && <em> · the sliders are not known to lead here from home</em>}
          </p>
        </div>
      )}
      {(places.length > 0 || stretches.length > 0) && (
        <ol class="places">
          {stretches.map((s, i) => (
            <li key={`s${i}`} class={s.singular ? "singular" : "undecided"} data-testid="path-stretch">
              <div class="head">
                <b>{s.end > s.start ? `${short(s.start, 5)} to ${short(s.end, 5)}` : short(s.start, 6)}</b>
                <span class="tag">{s.singular ? "singular throughout" : "not decided"}</span>
              </div>
              <Sentences words={s.words} />
            </li>
          ))}
          {places.map((p, i) => (
            <li key={i} class="singular" data-testid="path-place">
              <div class="head">
                <span class="number">{i + 1}</span>
                <b>
                  {short(p.parameter, 6)} {p.exactly}
                </b>
                <code>{p.at}</code>
                {p.pose && (
                  <button type="button" onClick={() => p.pose && go(p.parameter, p.pose)} data-testid="path-place-go">
                    Go there
                  </button>
                )}
              </div>
              <Sentences words={p.words} />
              {p.sure && <p class="sure">{p.sure}</p>}
            </li>
          ))}
        </ol>
      )}
      {more > 0 && (
        <p class="tip">And {more} more, which are not listed here.</p>
      )}
      {stops.length === end + 1 && (
        <p>
          <button type="button" class="small" title="To play it, to change its waypoints, to save them" data-testid="path-keep" onClick={() => timeline.take(stops)}>
            Take it as the way
          </button>
        </p>
      )}
      <Facts facts={result.facts} title="What was computed, and the proof" />
    </div>
  );
}

// What came of looking for a way around singular poses, and the poses it goes through.
function DetourNote({ detour, show }: { detour: Detour; show: (parameter: number) => void }) {
  return (
    <div class={`detour ${detour.outcome}`} role="status" data-testid="path-detour" data-outcome={detour.outcome}>
      <p>{detour.words}</p>
      {detour.outcome !== "way" && <p class="sure">Shown below is the straight way.</p>}
      {detour.poses.length > 2 && (
        <ol>
          {detour.poses.map((pose, k) => (
            <li key={k}>
              <code>{pose}</code>
              <button type="button" onClick={() => show(k)} data-testid="path-detour-show">
                Show
              </button>
            </li>
          ))}
        </ol>
      )}
    </div>
  );
}

function Sentences({ words }: { words: readonly string[] }) {
  return (
    <>
      {words.map((one, i) => (
        <p key={i}>{one}</p>
      ))}
    </>
  );
}
