// Where a study begins: six legs typed, a file, a drawing, or a card of the gallery.
import { useMemo, useState } from "preact/hooks";
import { Icon } from "../parts/icon";
import { Card } from "../start/card";
import { FileButton } from "../start/file-button";
import { SECTIONS, chosen, type Section } from "../start/filter";
import { TypeLegs } from "../start/type-legs";
import type { PanelProps } from "./index";

export function Start({ store }: PanelProps) {
  const [query, search] = useState("");
  const [section, only] = useState<Section>("all");
  const { alone } = store.client;
  const gallery = store.gallery.value;
  const groups = useMemo(() => (gallery ? chosen(gallery, section, query) : []), [gallery, section, query]);
  return (
    <div class="start">
      <section class="hero">
        <div class="words">
          <h1>When is this robot singular, and why?</h1>
          <p>
            {alone ? "Type its six legs, or choose a structure." : "Type its six legs, choose a structure, draw one or build it joint by joint."} You get the condition as algebra, as a sentence and in 3D, with the
            proof.
          </p>
          <div class="ways">
            {!alone && <Served store={store} />}
            <button type="button" onClick={() => store.go({ panel: "bench" })} data-testid="start-bench">
              <Icon name="bench" size={16} /> Expression bench
            </button>
          </div>
          {alone && <p class="hint" data-testid="alone">All of it is computed in this page. Robots with dimensions, poses, paths and maps need an installation.</p>}
        </div>
        <TypeLegs />
      </section>
      <div class="filter" role="search">
        <label class="search">
          <Icon name="search" size={16} />
          <input
            type="search"
            placeholder={alone ? "Search: 3-3, four planes, transversals …" : "Search: octahedral, four planes, 3-RPS …"}
            aria-label="Search the gallery"
            data-testid="gallery-search"
            value={query}
            onInput={(event) => search(event.currentTarget.value)}
          />
        </label>
        {!alone && <div class="segments" role="group" aria-label="Show">
          {SECTIONS.map(({ id, title }) => (
            <button type="button" key={id} aria-pressed={section === id} onClick={() => only(id)} data-testid={`gallery-${id}`}>
              {title}
            </button>
          ))}
        </div>}
      </div>
      {!gallery && <p class="busy"><span class="spinner" aria-hidden="true" /> Loading the gallery …</p>}
      {gallery && groups.length === 0 && <p class="none">Nothing matches “{query}”.</p>}
      <div class="groups">
        {groups.map(({ title, items }) => (
          <section class="group" key={title} style={{ "--count": items.length }}>
            <h2>
              {title} <span>{items.length}</span>
            </h2>
            <ul class="cards">
              {items.map((item) => (
                <Card key={`${item.source.kind}${item.id}`} item={item} />
              ))}
            </ul>
          </section>
        ))}
      </div>
    </div>
  );
}

/** Ways that need a server. */
function Served({ store }: PanelProps) {
  return (
    <>
      <FileButton />
      <button type="button" onClick={() => store.go({ panel: "draw", making: "legs" })} data-testid="start-draw">
        <Icon name="draw" size={16} /> Draw six legs
      </button>
      <button type="button" onClick={() => store.go({ panel: "draw", making: "limbs" })} data-testid="start-build">
        <Icon name="build" size={16} /> Build limbs
      </button>
      <button type="button" onClick={() => void (store.front.tour.value = 0)} data-testid="start-tour">
        <Icon name="play" size={14} /> A tour, three minutes
      </button>
    </>
  );
}
