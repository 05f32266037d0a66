// The robots at hand with their poses, ways and notes. They stay while this tab is open, and as long as a file that is saved.
import { computed, effect, signal, type ReadonlySignal, type Signal } from "@preact/signals";
import type { Fault, Pose } from "../../protocol";
import { sameSource, type Doc } from "./doc";
import type { Editing } from "./editing";
import { NO_PROJECT, readProject, writeProject, type KeptRobot, type Project } from "./project-file";
import type { Studying } from "./studying";
import { recalled, remember } from "./tab-memory";
import type { Timeline } from "./timeline";

export interface Projecting {
  project: ReadonlySignal<Project>;
  /** The robot of the project that is open. */
  open: ReadonlySignal<KeptRobot | null>;
  fault: Signal<Fault | null>;
  change(part: Partial<Omit<Project, "robots">>): void;
  /** Puts what is open into the project, or brings it up to date there. */
  keep(): void;
  keepPose(): void;
  edit(index: number, part: Partial<Pick<KeptRobot, "name" | "note" | "poses">>): void;
  remove(index: number): void;
  /** Opens a robot of the project as it was kept, or in one of its poses. */
  show(index: number, pose?: Pose): void;
  /** Takes the place of the project; nothing changes where the text has a fault. */
  read(text: string, name: string): boolean;
  text(): string;
}

const KEY = "gcrules-studio-project";

export function createProjecting(editing: Editing, { study }: Studying, timeline: Timeline): Projecting {
  const { doc, source$, pose$ } = editing;
  const kept = recalled(KEY);
  const before = kept === null ? null : readProject(kept, "project");
  const project = signal<Project>(before && "project" in before ? before.project : NO_PROJECT);
  const fault = signal<Fault | null>(null);
  const here = (): number => project.peek().robots.findIndex(({ state }) => sameSource(state.source, source$.peek()));
  effect(() => remember(KEY, project.value === NO_PROJECT ? null : writeProject(project.value)));

  const put = (robots: readonly KeptRobot[]): void => void (project.value = { ...project.peek(), robots });
  const edit = (index: number, part: Partial<KeptRobot>): void =>
    put(project.peek().robots.map((robot, i) => (i === index ? { ...robot, ...part } : robot)));

  function keep(): void {
    if (!study.peek()) return;
    const now = { state: stateOf(doc.peek()), way: timeline.stops.peek().length > 1 ? timeline.stops.peek() : [] };
    const index = here();
    if (index >= 0) return edit(index, now);
    put([...project.peek().robots, { name: study.peek()?.title ?? "", note: "", poses: [], ...now }]);
  }

  return {
    project,
    open: computed(() => project.value.robots.find(({ state }) => sameSource(state.source, source$.value)) ?? null),
    fault,
    change: (part) => void (project.value = { ...project.peek(), ...part }),
    keep,
    keepPose() {
      if (here() < 0) keep();
      const robot = project.peek().robots[here()];
      if (robot) edit(here(), { poses: [...robot.poses, { name: `Pose ${robot.poses.length + 1}`, pose: pose$.peek() }] });
    },
    edit,
    remove: (index) => put(project.peek().robots.filter((_, i) => i !== index)),
    show(index, pose) {
      const robot = project.peek().robots[index];
      if (!robot) return;
      editing.edit({ ...robot.state, way: robot.way, ...(pose && { pose }) });
    },
    read(text, name) {
      const found = readProject(text, name);
      fault.value = "fault" in found ? found.fault : null;
      if ("project" in found) project.value = found.project;
      return "project" in found;
    },
    text: () => writeProject(project.peek()),
  };
}

/** What is shown when it is opened again: the robot, not the list of robots. */
const stateOf = (doc: Doc): Doc => ({ ...doc, way: [], driven: [], ...((doc.panel === "project" || doc.panel === "start") && { panel: "guided" }) });
