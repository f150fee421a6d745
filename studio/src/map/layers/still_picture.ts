// What does not change from one frame of playback to the next: painted once, copied faintly.
import type { Frame } from "../viewport/frame";

const strength = 0.35;

export class StillPicture {
  readonly #canvas = document.createElement("canvas");
  #key: readonly unknown[] = [];

  // Paints again for another part of the map, other colours, or other subjects.
  draw(frame: Frame, subjects: readonly unknown[], paint: (frame: Frame) => void): void {
    const { camera, view, pixelRatio, theme } = frame;
    const key = [camera.x, camera.y, camera.scale, view.width, view.height, pixelRatio, theme, ...subjects];
    if (key.length !== this.#key.length || key.some((part, i) => part !== this.#key[i])) {
      this.#key = key;
      this.#canvas.width = Math.round(view.width * pixelRatio);
      this.#canvas.height = Math.round(view.height * pixelRatio);
      const context = this.#canvas.getContext("2d")!;
      context.setTransform(pixelRatio, 0, 0, pixelRatio, 0, 0);
      paint({ ...frame, context });
    }
    frame.context.globalAlpha = strength;
    frame.context.drawImage(this.#canvas, 0, 0, view.width, view.height);
    frame.context.globalAlpha = 1;
  }
}
