// Keeps the page alive when a part of it fails: the fault is told, the rest goes on.
import { Component, type ComponentChildren } from "preact";
import { FaultBox } from "./fault-box";

interface Props {
  /** Another value gives the part another try. */
  of: unknown;
  children: ComponentChildren;
}

interface State {
  fault: string | null;
  of: unknown;
}

export class Safe extends Component<Props, State> {
  override state: State = { fault: null, of: this.props.of };

  static getDerivedStateFromError(error: unknown): Partial<State> {
    return { fault: error instanceof Error ? error.message : String(error) };
  }

  static getDerivedStateFromProps(props: Props, state: State): Partial<State> | null {
    return props.of === state.of ? null : { fault: null, of: props.of };
  }

  override componentDidCatch(error: unknown): void {
    console.error(error);
  }

  override render() {
    const { fault } = this.state;
    if (fault === null) return this.props.children;
    const hint = "Undo the last change, or open another panel; the rest of the page works.";
    return <FaultBox fault={{ kind: "fault", message: `This part of the page failed: ${fault}`, hint }} />;
  }
}
