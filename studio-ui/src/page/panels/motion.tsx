// Every singular pose between two poses, over two coordinates and over x, y and z, of any robot.
import type { PanelProps } from "./index";
import { LocusSection } from "./motion/locus";
import { MapSection } from "./motion/map";
import { PathSection } from "./motion/path";
import { SurfaceSection } from "./motion/surface";
import "./motion/motion.css";

export function Motion({ store }: PanelProps) {
  const study = store.study.value;
  if (!study) return null;
  const still = study.axes.length === 0 || study.ranges.length === 0;
  return (
    <div class="motion">
      <header>
        <h2>Path and map</h2>
        <p class="why">Every singular pose between two poses, over two coordinates, and over x, y and z: proved free, crossed, or said to be undecided.</p>
      </header>
      {still ? (
        <p class="none">This structure has no numbers in other poses.</p>
      ) : (
        <>
          <PathSection />
          <MapSection study={study} />
          <SurfaceSection study={study} />
          <LocusSection study={study} />
        </>
      )}
    </div>
  );
}
