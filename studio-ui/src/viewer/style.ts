// The looks of the explorer; it takes the colours of the page that holds it where that has some.
export const STYLE = `
.gcx { --gx-ink: var(--ink, #1b1f24); --gx-soft: var(--soft, #5b6470); --gx-line: var(--line, #d9dee4);
  --gx-card: var(--card, #f4f6f8); --gx-accent: var(--accent, #0072b2); --gx-warn: var(--warn, #b45309); --gx-bad: var(--bad, #b3261e);
  display: grid; grid-template-columns: minmax(0, 1fr) 17.5rem; gap: .6rem 1.1rem; color: var(--gx-ink);
  font: .875rem/1.45 system-ui, "Segoe UI", "Liberation Sans", sans-serif; text-align: left; }
@media (prefers-color-scheme: dark) { .gcx { --gx-ink: var(--ink, #e6e9ed); --gx-soft: var(--soft, #9aa5b1); --gx-line: var(--line, #333b44);
  --gx-card: var(--card, #1d2228); --gx-accent: var(--accent, #56b4e9); --gx-warn: var(--warn, #f0b35a); --gx-bad: var(--bad, #ff8a80); } }
.gcx-bar { grid-column: 1 / -1; display: flex; flex-wrap: wrap; gap: .4rem 1.2rem; }
.gcx-bar > span { display: inline-flex; }
.gcx button { font: inherit; color: inherit; background: none; border: 1px solid var(--gx-line); padding: .25rem .75rem; cursor: pointer; border-radius: .35rem; }
.gcx-bar button { border-radius: 0; margin-left: -1px; }
.gcx-bar button:first-child { border-radius: .35rem 0 0 .35rem; margin-left: 0; } .gcx-bar button:last-child { border-radius: 0 .35rem .35rem 0; }
.gcx button:hover { background: var(--gx-card); }
.gcx button[aria-pressed=true] { background: var(--gx-accent); border-color: var(--gx-accent); color: var(--paper, Canvas); }
.gcx-view { height: clamp(20rem, 62vh, 34rem); border: 1px solid var(--gx-line); border-radius: .5rem; overflow: hidden; }
.gcx :focus-visible { outline: 2px solid var(--gx-accent); outline-offset: 2px; } .gcx-view :focus-visible { outline-offset: -3px; }
.gcx-side { display: flex; flex-direction: column; gap: .7rem; min-width: 0; }
.gcx-side > button { align-self: flex-start; }
.gcx-verdict { margin: 0; padding: .5rem .7rem; border-left: 4px solid var(--gx-accent); background: var(--gx-card); border-radius: 0 .35rem .35rem 0; font-weight: 600; min-height: 3.4rem; }
.gcx-verdict[data-verdict=close] { border-color: var(--gx-warn); color: var(--gx-warn); }
.gcx-verdict[data-verdict=singular] { border-color: var(--gx-bad); color: var(--gx-bad); }
.gcx .gcx-numbers :is(dt, dd) { float: none; width: auto; padding: 0; font-weight: 400; } .gcx p.gcx-meaning { margin: 0; color: var(--gx-soft); font-size: .8rem; }
.gcx .gcx-numbers { display: grid; grid-template-columns: auto 1fr; gap: .1rem .8rem; margin: 0; }
.gcx-numbers dt { color: var(--gx-soft); } .gcx .gcx-numbers dd { margin: 0; font-variant-numeric: tabular-nums; }
.gcx-motion[hidden] { display: none; } .gcx-numbers sup { line-height: 0; }
.gcx.gcx-still :is(.gcx-verdict, .gcx-numbers, .gcx-meaning, .gcx-motion, .gcx-sliders, .gcx-side > button, .gcx-modes) { display: none; }
.gcx-driven :is(.gcx-sliders, .gcx-side > button, .gcx-modes) { display: none; } .gcx-driven .gcx-row { grid-template-columns: 1.6rem minmax(0, 1fr) 5.2rem 1.9rem; }
.gcx-drives > p { margin: 0 0 .3rem; } .gcx-drives > button { margin-top: .3rem; } .gcx-drives > .gcx-unit { margin-left: 0; } .gcx-drives > .gcx-note { margin: .4rem 0; color: var(--gx-warn); } .gcx-note:empty { display: none; }
.gcx-row { display: grid; grid-template-columns: 3.6rem minmax(0, 1fr) 5.2rem 1.9rem; gap: .5rem; align-items: center; margin: .15rem 0; }
.gcx-row input { min-width: 0; font: inherit; accent-color: var(--gx-accent); }
.gcx-row input[type=number] { color: inherit; background: none; border: 1px solid var(--gx-line); border-radius: .3rem; padding: .1rem .3rem; text-align: right; font-variant-numeric: tabular-nums; }
.gcx-unit { color: var(--gx-soft); margin-left: -.2rem; }
.gcx-legend { list-style: none; margin: 0; padding: 0; display: flex; flex-wrap: wrap; gap: .25rem .9rem; }
.gcx-legend li { border-left: .9rem solid var(--own); padding-left: .45rem; line-height: 1.2; cursor: default; }
.gcx-name { font-family: "STIX Two Text", Cambria, "Liberation Serif", Georgia, serif; font-size: 1.08em; } .gcx-name sub { line-height: 0; }
@media (max-width: 46rem) { .gcx { grid-template-columns: minmax(0, 1fr); } }
@media print { .gcx-bar, .gcx-sliders, .gcx-drives, .gcx-side > button { display: none; } .gcx { grid-template-columns: 1fr; } }
`;
