// Keys, drawn as on a keyboard.
import { namesOf } from "../actions/keys";

export function Keycaps({ keys }: { keys: string }) {
  return (
    <span class="keycaps">
      {namesOf(keys).map((name) => (
        <kbd key={name}>{name}</kbd>
      ))}
    </span>
  );
}
