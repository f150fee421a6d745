// Writes names on the map. Texts are drawn once each and then copied, since writing with a halo is slow.
import { type Box, grown, intersection, mapBox } from "../../domain/geometry";
import type { Scene } from "../../domain/scene";
import { visibleBox } from "../viewport/camera";
import { type Frame, place, typeface } from "../viewport/frame";
import type { Theme } from "../viewport/theme";
import { boxesAlong, type Label, placed, type TextSize } from "./labels";
import { type Name, namesOf } from "./names";

interface Lettering {
  font: string;
  lineHeight: number;
  spacing: string;
  colour: (theme: Theme) => string;
}

const lettering: Record<Name["kind"], Lettering> = {
  place: { font: `600 13px ${typeface}`, lineHeight: 16, spacing: "0.6px", colour: (theme) => theme.fadedInk },
  street: { font: `500 11px ${typeface}`, lineHeight: 13, spacing: "0px", colour: (theme) => theme.fadedInk },
  water: { font: `italic 500 12px ${typeface}`, lineHeight: 14, spacing: "0.5px", colour: (theme) => theme.waterName },
  green: { font: `500 11px ${typeface}`, lineHeight: 13, spacing: "0px", colour: (theme) => theme.greenName },
  building: { font: `500 10.5px ${typeface}`, lineHeight: 12.5, spacing: "0px", colour: (theme) => theme.ink },
};

const halo = 2; // pixels around letters
const mostSprites = 600;
const partSide = 2048; // pixels
const mostParts = 100;

interface Sprite {
  picture: OffscreenCanvas;
  width: number;
  height: number;
}

export class LabelLayer {
  #background: Scene["background"] | null = null;
  #names: Name[] | null = null;
  #cells: Scene["cells"] | null = null;
  readonly #parts = new Map<string, Label[]>();
  #placed = 0; // parts, in this frame
  #lacking = 0;
  readonly #sizes = new Map<Name, TextSize>();
  readonly #sprites = new Map<string, Sprite>();

  // Names where nothing else is to stand (`isFree`, in pixels). Whether there are more to come: a new map is drawn before its
  // names are gathered, and in each frame those of one part of the map at most are given their places.
  draw(frame: Frame, scene: Scene, isFree: (box: Box) => boolean): boolean {
    if (scene.background !== this.#background || scene.cells !== this.#cells) {
      this.#background = scene.background;
      this.#cells = scene.cells;
      this.#names = null;
      this.#parts.clear();
      this.#sizes.clear();
      return true;
    }
    this.#names ??= namesOf(scene.background, scene.cells);
    if (this.#names.length === 0) return false;
    this.#placed = 0;
    this.#lacking = 0;
    const { context, camera, view } = frame;
    const seen = grown(visibleBox(camera, view), 120 / camera.scale);
    for (const { name, at, angle } of this.#labels(frame, scene)) {
      if (at[0] < seen.left || at[0] > seen.right || at[1] < seen.top || at[1] > seen.bottom) continue;
      const sprite = this.#sprite(frame, name);
      const [x, y] = place(frame, at);
      if (!boxesAlong([x, y], angle, sprite).every(isFree)) continue;
      context.save();
      context.translate(x, y);
      context.rotate(angle);
      context.drawImage(sprite.picture, -sprite.width / 2, -sprite.height / 2, sprite.width, sprite.height);
      context.restore();
    }
    return this.#lacking > 0;
  }

  // Labels of the parts of the map that are seen. They are worked out once for each half step of zoom, for the farthest
  // of it: nearer, there is only more room.
  *#labels(frame: Frame, scene: Scene): Generator<Label> {
    const { camera, view, context } = frame;
    const step = Math.floor(2 * Math.log2(camera.scale));
    const scale = 2 ** (step / 2);
    const cells = partSide / scale;
    const seen = intersection(visibleBox(camera, view), mapBox(scene.map));
    for (let row = Math.floor((seen.top + 0.5) / cells); row * cells < seen.bottom + 0.5; ++row) {
      for (let column = Math.floor((seen.left + 0.5) / cells); column * cells < seen.right + 0.5; ++column) {
        const key = `${step} ${column} ${row}`;
        let labels = this.#parts.get(key);
        if (!labels && this.#placed > 0) {
          ++this.#lacking;
          continue;
        }
        if (!labels) {
          ++this.#placed;
          if (this.#parts.size >= mostParts) this.#parts.clear();
          const [left, top] = [column * cells - 0.5, row * cells - 0.5];
          const part = intersection({ left, top, right: left + cells, bottom: top + cells }, mapBox(scene.map));
          labels = placed(this.#names!, scale, scene.map.cell_size, part, (name) => this.#sizeOf(context, name));
          this.#parts.set(key, labels);
        }
        yield* labels;
      }
    }
  }

  #sizeOf(context: CanvasRenderingContext2D, name: Name): TextSize {
    let size = this.#sizes.get(name);
    if (size) return size;
    const { font, lineHeight, spacing } = lettering[name.kind];
    context.font = font;
    context.letterSpacing = spacing;
    size = {
      width: Math.max(...name.lines.map((line) => context.measureText(line).width)),
      height: name.lines.length * lineHeight,
    };
    context.letterSpacing = "0px";
    this.#sizes.set(name, size);
    return size;
  }

  #sprite(frame: Frame, name: Name): Sprite {
    const key = `${name.kind} ${frame.pixelRatio} ${frame.theme.ink} ${name.lines.join("\n")}`;
    let sprite = this.#sprites.get(key);
    if (sprite) return sprite;
    if (this.#sprites.size >= mostSprites) this.#sprites.clear();
    sprite = written(frame, name, this.#sizeOf(frame.context, name));
    this.#sprites.set(key, sprite);
    return sprite;
  }
}

function written({ pixelRatio, theme }: Frame, name: Name, size: TextSize): Sprite {
  const { font, lineHeight, spacing, colour } = lettering[name.kind];
  const width = Math.ceil(size.width) + 2 * halo + 2;
  const height = Math.ceil(size.height) + 2 * halo + 2;
  const picture = new OffscreenCanvas(Math.ceil(width * pixelRatio), Math.ceil(height * pixelRatio));
  const context = picture.getContext("2d")!;
  context.scale(pixelRatio, pixelRatio);
  context.font = font;
  context.letterSpacing = spacing;
  context.textAlign = "center";
  context.textBaseline = "middle";
  context.lineJoin = "round";
  context.lineWidth = 2 * halo;
  context.strokeStyle = name.kind === "building" ? theme.obstacles.removable.fill : theme.halo;
  context.fillStyle = colour(theme);
  const top = height / 2 - ((name.lines.length - 1) * lineHeight) / 2;
  name.lines.forEach((line, i) => context.strokeText(line, width / 2, top + i * lineHeight));
  name.lines.forEach((line, i) => context.fillText(line, width / 2, top + i * lineHeight));
  return { picture, width: picture.width / pixelRatio, height: picture.height / pixelRatio };
}
