// The frame of the page: bar, rail, the panel that is open, and beside it the robot in 3D with its pose.
import { useEffect, useLayoutEffect, useRef } from "preact/hooks";
import { panelsOf } from "../panels";
import { listen } from "../parts/pointing";
import { Safe } from "../parts/safe";
import type { Store } from "../state/store";
import { NoNumbers } from "../pose/no-numbers";
import { PosePanel } from "../pose/pose-panel";
import { Banner } from "./banner";
import { Front } from "./front";
import { keepFocus } from "./kept-focus";
import { useKeys } from "./keys";
import { Opening } from "./opening";
import { Rail } from "./rail";
import { Splitter } from "./splitter";
import { TopBar } from "./top-bar";
import { ViewerPane } from "./viewer-pane";

export function Shell({ store }: { store: Store }) {
  const root = useRef<HTMLDivElement>(null);
  const body = useRef<HTMLDivElement>(null);
  const content = useRef<HTMLElement>(null);
  const below = useRef<HTMLDivElement>(null);
  const drawn = useRef(false);
  const opened = useRef<string | null>(null);
  const { across, down } = store.taste;
  const study = store.study.value;
  const robot = study && `${study.kind} ${study.title}`;
  useEffect(() => (root.current ? listen(root.current, store) : undefined), [store]);
  useEffect(() => (root.current ? keepFocus(root.current, () => document.getElementById("content")) : undefined), [store]);
  useEffect(() => {
    if (robot === null || robot === opened.current) return;
    opened.current = robot;
    below.current?.scrollTo(0, 0); // another robot begins with its verdict
  }, [robot]);
  useKeys(store);

  const panels = panelsOf(store);
  const panel = panels.find(({ id }) => id === store.panel$.value) ?? panels[0];
  useLayoutEffect(() => {
    for (const scroller of [body, content]) scroller.current?.scrollTo(0, 0); // a panel, and a step, begins at its top
  }, [panel?.id, store.stage$.value]);
  if (!panel) return null;
  const waits = panel.needs === "study" && !study;
  const beside = panel.layout === "beside" && study !== null;
  drawn.current ||= beside; // the viewer is made when it is first needed, and then kept
  const Content = panel.component;
  return (
    <div class="shell" ref={root}>
      <a class="skip" href="#content" onClick={(event) => (event.preventDefault(), document.getElementById("content")?.focus())}>
        To the content
      </a>
      <TopBar />
      <Banner />
      <div class="body" ref={body}>
        <Rail />
        <main
          class={beside ? "split" : "split single"}
          style={{ "--across": `${100 * across.value}%`, "--down": `${100 * down.value}%` }}
        >
          <section id="content" ref={content} class={`content ${panel.layout}`} tabIndex={-1} aria-label={panel.title}>
            <Safe of={`${panel.id} ${store.stage$.value} ${study?.title}`}>{waits ? <Opening /> : <Content store={store} />}</Safe>
          </section>
          {beside && <Splitter share={across} direction="across" label="Width of the steps" />}
          <aside class="side" hidden={!beside} aria-label="Robot and pose">
            {drawn.current && <ViewerPane />}
            {beside && <Splitter share={down} direction="down" label="Height of the picture" />}
            <div class="lower" ref={below}>{beside && <Safe of={study}>{store.client.alone ? <NoNumbers /> : <PosePanel />}</Safe>}</div>
          </aside>
        </main>
      </div>
      <Front />
    </div>
  );
}
