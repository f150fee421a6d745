// Turns pointer, wheel and key events over the canvas into gestures: pan, zoom, click, drag, stroke.
import type { Point } from "../../domain/geometry";

export interface GestureTarget {
  // What a pointer set down at a place does: moves the map, drags something, or draws.
  grab(at: Point): "pan" | "drag" | "draw";
  panBy(dx: number, dy: number): void;
  zoomBy(factor: number, at: Point | null, gliding: boolean): void;
  fit(): void;
  point(at: Point | null): void; // hovers there; null: has left
  click(at: Point): void;
  dragTo(at: Point, done: boolean): void;
  drawTo(at: Point, done: boolean): void;
  abandon(): void; // the drag or the stroke was not meant
  doubleClick(at: Point, outwards: boolean): void;
  choose(): void; // what is in the middle
  takeBack(): void; // the last step of what is being drawn
  escape(): void;
  ask(at: Point | null): boolean; // what can be done with what is there, or in the middle; whether anything can
}

const clickSlack = 5; // pixels that a hand shakes
const keyStep = 80;

export class Gestures {
  readonly #pointers = new Map<number, Point>();
  readonly #listening = new AbortController();
  #doing: "pan" | "drag" | "draw" | "pinch" | null = null;
  #down: Point = [0, 0];
  #moved = false;

  constructor(
    private readonly element: HTMLElement,
    private readonly target: GestureTarget,
  ) {
    element.style.touchAction = "none";
    const on = <K extends keyof HTMLElementEventMap>(
      type: K,
      handle: (event: HTMLElementEventMap[K]) => void,
    ): void => element.addEventListener(type, handle, { signal: this.#listening.signal, passive: false });
    on("pointerdown", (event) => this.#pointerDown(event));
    on("pointermove", (event) => this.#pointerMove(event));
    on("pointerrawupdate", (event) => this.#pointerRaw(event as PointerEvent));
    on("pointerup", (event) => this.#pointerUp(event));
    on("pointercancel", (event) => this.#pointerCancel(event));
    on("pointerleave", () => this.#pointers.size === 0 && target.point(null));
    on("mousedown", (event) => event.button === 1 && event.preventDefault()); // else the middle button scrolls
    on("wheel", (event) => this.#wheel(event));
    on("keydown", (event) => this.#key(event));
    on("contextmenu", (event) => {
      const byKey = event.button !== 2 && !(event as PointerEvent).pointerType;
      if (target.ask(byKey ? null : this.#at(event))) event.preventDefault();
    });
    on("dblclick", (event) => target.doubleClick(this.#at(event), event.shiftKey));
  }

  destroy(): void {
    this.#listening.abort();
  }

  #at(event: MouseEvent): Point {
    const box = this.element.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  }

  #pointerDown(event: PointerEvent): void {
    if (event.button > 1) return;
    this.element.setPointerCapture(event.pointerId);
    const at = this.#at(event);
    this.#pointers.set(event.pointerId, at);
    if (this.#pointers.size === 1) {
      this.#down = at;
      this.#moved = false;
      this.#doing = event.button === 1 ? "pan" : this.target.grab(at);
      if (this.#doing === "draw") this.target.drawTo(at, false);
    } else {
      if (this.#doing === "drag" || this.#doing === "draw") this.target.abandon();
      this.#doing = "pinch";
      this.#moved = true;
    }
  }

  #pointerMove(event: PointerEvent): void {
    const before = this.#pointers.get(event.pointerId);
    const at = this.#at(event);
    if (!before) {
      this.target.point(at);
      return;
    }
    if (this.#doing === "pinch") this.#pinch(event.pointerId, at);
    this.#pointers.set(event.pointerId, at);
    if (this.#doing === "draw") {
      for (const part of event.getCoalescedEvents?.() ?? [event]) this.target.drawTo(this.#at(part), false);
      return;
    }
    if (!this.#moved && Math.hypot(at[0] - this.#down[0], at[1] - this.#down[1]) < clickSlack) return;
    const from = this.#moved ? before : this.#down;
    this.#moved = true;
    if (this.#doing === "drag") this.target.dragTo(at, false);
    else if (this.#doing === "pan") this.target.panBy(at[0] - from[0], at[1] - from[1]);
  }

  // Before the frame that "pointermove" waits for, where the browser tells: what follows the drag may be there with it.
  #pointerRaw(event: PointerEvent): void {
    if (this.#doing === "drag" && this.#moved && this.#pointers.has(event.pointerId)) this.target.dragTo(this.#at(event), false);
  }

  #pinch(moving: number, at: Point): void {
    const [first, second] = [...this.#pointers.keys()];
    const other = this.#pointers.get(moving === first ? second! : first!);
    const before = this.#pointers.get(moving)!;
    if (!other) return;
    const spread = (point: Point): number => Math.max(10, Math.hypot(point[0] - other[0], point[1] - other[1]));
    this.target.panBy((at[0] - before[0]) / 2, (at[1] - before[1]) / 2);
    this.target.zoomBy(spread(at) / spread(before), [(at[0] + other[0]) / 2, (at[1] + other[1]) / 2], false);
  }

  #pointerUp(event: PointerEvent): void {
    if (!this.#pointers.delete(event.pointerId)) return;
    const at = this.#at(event);
    if (this.#pointers.size > 0) {
      this.#doing = "pan"; // the finger that stays moves on
      return;
    }
    if (this.#doing === "draw") this.target.drawTo(at, true);
    else if (this.#doing === "drag" && this.#moved) this.target.dragTo(at, true);
    else if (!this.#moved && event.button === 0) this.target.click(at);
    if (this.#doing === "drag" && !this.#moved) this.target.abandon();
    this.#doing = null;
    if (event.pointerType !== "mouse") this.target.point(null);
  }

  #pointerCancel(event: PointerEvent): void {
    this.#pointers.delete(event.pointerId);
    if (this.#doing === "drag" || this.#doing === "draw") this.target.abandon();
    this.#doing = this.#pointers.size > 0 ? "pan" : null;
  }

  #wheel(event: WheelEvent): void {
    event.preventDefault();
    const pixels = event.deltaY * [1, 16, 400][event.deltaMode]!;
    // A pinch on a touchpad comes as a wheel with Ctrl, in small steps.
    const factor = Math.exp(-Math.max(-300, Math.min(300, pixels)) * (event.ctrlKey ? 0.01 : 0.0018));
    this.target.zoomBy(factor, this.#at(event), false);
  }

  #key(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const step = event.shiftKey ? 3 * keyStep : keyStep;
    const actions: Record<string, () => void> = {
      ArrowLeft: () => this.target.panBy(step, 0),
      ArrowRight: () => this.target.panBy(-step, 0),
      ArrowUp: () => this.target.panBy(0, step),
      ArrowDown: () => this.target.panBy(0, -step),
      "+": () => this.target.zoomBy(1.5, null, true),
      "=": () => this.target.zoomBy(1.5, null, true),
      "-": () => this.target.zoomBy(1 / 1.5, null, true),
      "0": () => this.target.fit(),
      Enter: () => this.target.choose(),
      Backspace: () => this.target.takeBack(),
      Escape: () => this.target.escape(),
    };
    if (event.key === "ContextMenu" || (event.key === "F10" && event.shiftKey)) {
      if (this.target.ask(null)) event.preventDefault();
      return;
    }
    const action = actions[event.key];
    if (!action) return;
    event.preventDefault();
    action();
  }
}
