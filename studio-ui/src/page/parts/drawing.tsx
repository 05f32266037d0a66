// A drawing made by the server; what is pointed at is lit up in it.
import { useEffect, useRef } from "preact/hooks";
import { useSignalEffect } from "@preact/signals";
import { readSvg } from "../lib/svg";
import { useStore } from "./context";

export function Drawing({ svg, label }: { svg: string; label?: string }) {
  const box = useRef<HTMLDivElement>(null);
  useEffect(() => {
    const drawing = readSvg(svg);
    if (drawing && label) drawing.setAttribute("aria-label", label);
    box.current?.replaceChildren(...(drawing ? [drawing] : []));
  }, [svg, label]);
  return <div ref={box} class="drawing" />;
}

/** The legs as a graph, whose points and legs can be pointed at. */
export function Schematic({ svg }: { svg: string }) {
  const { lit, study } = useStore();
  const box = useRef<HTMLDivElement>(null);
  useSignalEffect(() => {
    const target = lit.current.value;
    const points = target?.points ?? [];
    const legs = (study.value?.legs ?? []).filter((leg) => target?.kind === "leg" && leg.every((p) => points.includes(p)));
    const names = legs.map((leg) => leg.join(""));
    box.current?.querySelectorAll<SVGElement>("[data-point],[data-leg]").forEach((element) => {
      const { point, leg } = element.dataset;
      element.classList.toggle("lit", leg === undefined ? points.includes(point ?? "") : names.includes(leg));
    });
  });
  return (
    <div ref={box} class="schematic" data-testid="schematic">
      <Drawing svg={svg} />
    </div>
  );
}
