// Opens a platform or robot file, or a model: by the button, or dropped anywhere on the page. Its text goes to the server, not its path.
import { useEffect, useState } from "preact/hooks";
import type { Fault } from "../../protocol";
import { useStore } from "../parts/context";
import { FaultBox } from "../parts/fault-box";
import { OpenFile, ROBOT_FILES } from "../parts/open-file";
import { isProject } from "../state/project-file";

const LARGEST = 400_000; // characters that the server takes

export function FileButton() {
  const { open, go, projecting } = useStore();
  const [fault, tell] = useState<Fault | null>(null);

  async function take(file: File | undefined): Promise<void> {
    if (!file) return;
    tell(null);
    if (file.size > LARGEST && !file.name.endsWith(".json")) {
      return tell({ kind: "input", message: `${file.name} is too large`, hint: `at most ${LARGEST / 1000} kB are read` });
    }
    const text = await file.text();
    if (isProject(text)) {
      projecting.read(text, file.name);
      return go({ panel: "project" });
    }
    open({ kind: "file", text, name: file.name });
  }

  useEffect(() => {
    const over = (event: DragEvent) => event.preventDefault();
    const drop = (event: DragEvent) => {
      event.preventDefault();
      void take(event.dataTransfer?.files[0]);
    };
    addEventListener("dragover", over);
    addEventListener("drop", drop);
    return () => {
      removeEventListener("dragover", over);
      removeEventListener("drop", drop);
    };
  }, []);

  return (
    <>
      <OpenFile accept={ROBOT_FILES} testid="file" title="A platform or robot file (YAML), or a model (URDF, SDF, MJCF); it can also be dropped here" take={(file) => void take(file)}>
        Open a file
      </OpenFile>
      {fault && <FaultBox fault={fault} />}
    </>
  );
}
