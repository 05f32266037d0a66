// Where the robot can go without a singularity, and in how many ways it can be assembled.
import type { PanelProps } from "./index";
import { AspectsSection } from "./where/aspects";
import { AssembliesSection } from "./where/assemblies";
import { BoxesSection } from "./where/boxes";
import { FreeSection } from "./where/free";
import "./motion/motion.css";
import "./where/where.css";

export function Where({ store }: PanelProps) {
  const study = store.study.value;
  if (!study) return null;
  return (
    <div class="motion where">
      <header>
        <h2>Where can it go</h2>
        <p class="why">Its assembly modes, the parts into which singularities divide its poses, and the room around the pose on show, or in ranges that you name.</p>
      </header>
      {study.axes.length === 0 ? (
        <p class="none">This structure has no numbers in other poses.</p>
      ) : (
        <>
          <AssembliesSection study={study} />
          <AspectsSection />
          <FreeSection />
          {study.wholes.length > 0 && <BoxesSection study={study} />}
        </>
      )}
    </div>
  );
}
