// The robots at hand, with their poses, ways and notes: one file to save and to open.
import { download } from "../lib/download";
import { FaultBox } from "../parts/fault-box";
import { Icon } from "../parts/icon";
import { OpenFile } from "../parts/open-file";
import { projectFileName } from "./project/file-name";
import { RobotEntry } from "./project/robot-entry";
import type { PanelProps } from "./index";
import "./project/project.css";

export function ProjectPanel({ store }: PanelProps) {
  const { projecting, study, front } = store;
  const { title, note, robots } = projecting.project.value;
  const open = projecting.open.value;
  const shown = study.value;

  async function take(file: File): Promise<void> {
    if (projecting.read(await file.text(), file.name)) front.tell("The project is open");
  }

  function save(): void {
    download({ name: projectFileName(title), blob: new Blob([projecting.text()], { type: "application/json" }) });
  }

  return (
    <div class="project">
      <header>
        <h2>Project</h2>
        <p class="why">Robots, poses, ways and notes, as one file. Until it is saved it stays in this tab only.</p>
      </header>
      <div class="whole">
        <input
          type="text"
          class="title"
          placeholder="Title"
          aria-label="Title of the project"
          value={title}
          data-testid="project-title"
          onInput={(event) => projecting.change({ title: event.currentTarget.value })}
        />
        <OpenFile accept=".json" testid="project-file" take={(file) => void take(file)}>
          Open
        </OpenFile>
        <button type="button" class="primary" disabled={robots.length === 0 && !note} onClick={save} data-testid="project-save">
          <Icon name="take-away" size={16} /> Save
        </button>
      </div>
      {projecting.fault.value && <FaultBox fault={projecting.fault.value} />}
      <textarea
        rows={3}
        placeholder="Notes"
        aria-label="Notes of the project"
        value={note}
        data-testid="project-note"
        onInput={(event) => projecting.change({ note: event.currentTarget.value })}
      />
      {shown && (
        <div class="keep">
          <p>
            Open now: <b>{shown.title}</b>
          </p>
          <button type="button" class={open ? "" : "primary"} onClick={projecting.keep} data-testid="project-keep">
            {open ? "Bring up to date" : "Add it"}
          </button>
          {shown.axes.length > 0 && (
            <button type="button" onClick={projecting.keepPose} data-testid="project-keep-pose">
              Add its pose
            </button>
          )}
        </div>
      )}
      {robots.length === 0 && !shown && <p class="none">Open a robot, and add it here.</p>}
      <ul class="robots">
        {robots.map((robot, i) => (
          <RobotEntry key={i} robot={robot} index={i} open={robot === open} />
        ))}
      </ul>
    </div>
  );
}
