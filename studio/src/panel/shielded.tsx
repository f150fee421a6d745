// Shows its children until one of them fails to be shown: then nothing, and whoever put it there is told. Without it, an
// error in one part of the page leaves all of the page dead.
import { Component, type ComponentChildren } from "preact";

interface ShieldedProps {
  onFailure: () => void;
  children: ComponentChildren;
}

export class Shielded extends Component<ShieldedProps, { failed: boolean }> {
  override state = { failed: false };

  override componentDidCatch(error: unknown): void {
    console.error(error);
    this.setState({ failed: true });
    this.props.onFailure();
  }

  override render() {
    return this.state.failed ? null : this.props.children;
  }
}
