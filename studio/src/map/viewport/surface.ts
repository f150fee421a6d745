// The canvas that is drawn on: as large and as fine as the screen has it, light or dark as the reader wants it, and
// drawn anew when asked to, once a frame.
import type { Size } from "../../domain/geometry";
import { onPrinting } from "./printing";
import { dark, light, type Theme } from "./theme";

export interface SurfaceUser {
  resized(): void;
  themed(): void; // other colours, or other pixels
  draw(now: number, whole: boolean): void; // whole: with all that otherwise comes in later frames
}

export class Surface {
  readonly context: CanvasRenderingContext2D;
  view: Size = { width: 0, height: 0 }; // CSS pixels
  pixelRatio = devicePixelRatio;

  readonly #darkness = matchMedia("screen and (prefers-color-scheme: dark)");
  readonly #stillness = matchMedia("(prefers-reduced-motion: reduce)");
  readonly #resizing: ResizeObserver;
  readonly #listening = new AbortController();
  readonly #unprinted: () => void;
  #printing = false;
  #frame: number | null = null;

  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly user: SurfaceUser,
  ) {
    this.context = canvas.getContext("2d", { alpha: false })!;
    this.#resizing = new ResizeObserver(() => this.#resize());
    this.#resizing.observe(canvas);
    const signal = this.#listening.signal;
    this.#darkness.addEventListener("change", () => user.themed(), { signal });
    this.#stillness.addEventListener("change", () => this.ask(), { signal });
    canvas.addEventListener("focus", () => this.ask(), { signal });
    canvas.addEventListener("blur", () => this.ask(), { signal });
    this.#unprinted = onPrinting((printing) => this.#print(printing));
  }

  // On the page.
  get bottom(): number {
    return this.canvas.getBoundingClientRect().bottom;
  }

  get theme(): Theme {
    return this.#darkness.matches && !this.#printing ? dark : light;
  }

  // Whether the reader asked for less motion.
  get still(): boolean {
    return this.#stillness.matches;
  }

  get hasKeyboard(): boolean {
    return this.canvas.matches(":focus-visible");
  }

  takeKeys(): void {
    this.canvas.focus();
  }

  set cursor(cursor: string) {
    this.canvas.style.cursor = cursor;
  }

  ask(): void {
    this.#frame ??= requestAnimationFrame((now) => {
      this.#frame = null;
      this.#draw(now);
    });
  }

  destroy(): void {
    this.#resizing.disconnect();
    this.#listening.abort();
    this.#unprinted();
    if (this.#frame !== null) cancelAnimationFrame(this.#frame);
  }

  #resize(): void {
    const box = this.canvas.getBoundingClientRect();
    this.view = { width: box.width, height: box.height };
    const finer = this.pixelRatio !== devicePixelRatio;
    this.pixelRatio = devicePixelRatio;
    this.canvas.width = Math.round(box.width * this.pixelRatio);
    this.canvas.height = Math.round(box.height * this.pixelRatio);
    if (finer) this.user.themed();
    this.user.resized();
    this.#draw(performance.now()); // at once: a resized canvas is blank
  }

  // At once: there are no frames on paper. What the paper gives the canvas is no other view.
  #print(printing: boolean): void {
    if (printing === this.#printing) return;
    this.#printing = printing;
    if (printing) this.#resizing.disconnect();
    else this.#resizing.observe(this.canvas);
    this.user.themed();
    this.#draw(performance.now(), printing);
  }

  #draw(now: number, whole = false): void {
    if (this.view.width === 0 || this.view.height === 0) return;
    this.context.setTransform(this.pixelRatio, 0, 0, this.pixelRatio, 0, 0);
    this.user.draw(now, whole);
  }
}
