// A robot of the project: its name, its note, its poses; opened as it was kept.
import { useStore } from "../../parts/context";
import { Icon } from "../../parts/icon";
import type { KeptRobot } from "../../state/project-file";

export function RobotEntry({ robot, index, open }: { robot: KeptRobot; index: number; open: boolean }) {
  const { projecting } = useStore();
  const { name, note, poses, way, state } = robot;
  const facts = [
    way.length > 1 && `a way of ${way.length} poses`,
    state.commands.length > 0 && `${state.commands.length} ${state.commands.length === 1 ? "step" : "steps"} by hand`,
    state.bench.trim() !== "" && "text of the bench",
  ].filter(Boolean);
  return (
    <li class={open ? "robot open" : "robot"} data-testid={`project-robot-${index}`}>
      <div class="head">
        <input
          type="text"
          value={name}
          aria-label={`Name of robot ${index + 1}`}
          onInput={(event) => projecting.edit(index, { name: event.currentTarget.value })}
        />
        {open && <span class="tag">open</span>}
        <button type="button" onClick={() => projecting.show(index)} data-testid={`project-show-${index}`}>
          Go to it
        </button>
        <button
          type="button"
          class="tool"
          aria-label={`Take ${name} out of the project`}
          title="Take it out"
          onClick={() => projecting.remove(index)}
          data-testid={`project-remove-${index}`}
        >
          <Icon name="close" size={16} />
        </button>
      </div>
      {facts.length > 0 && <p class="facts">With {facts.join(", ")}.</p>}
      {poses.length > 0 && (
        <ul class="poses">
          {poses.map((one, k) => (
            <li key={k}>
              <button type="button" class="quiet" aria-label={`Go to ${one.name}`} title="Go there" onClick={() => projecting.show(index, one.pose)} data-testid={`project-pose-${index}-${k}`}>
                <Icon name="target" size={15} />
              </button>
              <input
                type="text"
                value={one.name}
                aria-label={`Name of pose ${k + 1}`}
                onInput={(event) =>
                  projecting.edit(index, { poses: poses.map((other, j) => (j === k ? { ...other, name: event.currentTarget.value } : other)) })
                }
              />
              <button
                type="button"
                class="quiet"
                aria-label={`Take ${one.name} out`}
                title="Take it out"
                onClick={() => projecting.edit(index, { poses: poses.filter((_, j) => j !== k) })}
              >
                <Icon name="close" size={14} />
              </button>
            </li>
          ))}
        </ul>
      )}
      <textarea
        rows={2}
        placeholder="Note"
        aria-label={`Note on ${name}`}
        value={note}
        data-testid={`project-note-${index}`}
        onInput={(event) => projecting.edit(index, { note: event.currentTarget.value })}
      />
    </li>
  );
}
