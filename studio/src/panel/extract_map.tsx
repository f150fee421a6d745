// An extract of map data, shaded where it is built up, and the square window on it, to drag and resize.
import { useMemo, useRef, useState } from "preact/hooks";
import { type Extract, type ImportRequest, leastWindow } from "../domain/extract";
import type { Box, Point } from "../domain/geometry";
import { plainName } from "../domain/plain_name";
import { length } from "../domain/units";

interface ExtractMapProps {
  extract: Extract;
  request: ImportRequest;
  onChange: (part: Partial<ImportRequest>) => void;
}

const shadeCount = 5;
const zooms = [1, 2, 4, 8, 16, 32];
const metres = { metric: true, cell: 1, time: "seconds", seconds: 1 } as const;

export function ExtractMap({ extract, request, onChange }: ExtractMapProps) {
  const svg = useRef<SVGSVGElement>(null);
  const grip = useRef<{ what: "move" | "resize"; from: Point; at: Point; side: number } | null>(null);
  const shades = useMemo(() => extract.shades(shadeCount), [extract]);
  const [view, setView] = useState(() => viewOf(extract, extract.toPlane(request.center), 1));
  const [zoom, setZoom] = useState(0);
  const [x, y] = extract.toPlane(request.center);
  const { size } = request;
  const shown = view.right - view.left;
  const least = shown / 28; // of the window: to be seen, and held
  const side = Math.max(size, least);

  const place = (at: Point, to: number) =>
    onChange({ center: extract.toLonLat(extract.placed(at, to)), size: Math.round(to) });
  const resize = (to: number, at: Point = [x, y]) =>
    place(at, Math.min(Math.max(to, leastWindow), extract.mostSide));
  const pointOf = (event: PointerEvent): Point => {
    const matrix = svg.current!.getScreenCTM()!.inverse();
    const { x, y } = new DOMPoint(event.clientX, event.clientY).matrixTransform(matrix);
    return [x, y];
  };
  const hold = (what: "move" | "resize") => (event: PointerEvent) => {
    if (event.button !== 0) return;
    event.stopPropagation();
    svg.current!.setPointerCapture(event.pointerId);
    grip.current = { what, from: pointOf(event), at: [x, y], side: size };
  };
  const drag = (event: PointerEvent) => {
    const held = grip.current;
    if (!held) return;
    const [dx, dy] = pointOf(event).map((to, i) => to - held.from[i]!) as Point;
    if (held.what === "move") return place([held.at[0] + dx, held.at[1] + dy], size);
    // The corner opposite the handle stays.
    const to = Math.min(Math.max(held.side + Math.max(dx, dy), leastWindow), extract.mostSide);
    resize(to, [held.at[0] + (to - held.side) / 2, held.at[1] + (to - held.side) / 2]);
  };
  const press = (event: KeyboardEvent) => {
    const step = (event.shiftKey ? 0.5 : 0.1) * size;
    const by = arrows[event.key];
    if (by) place([x + by[0] * step, y + by[1] * step], size);
    else if (event.key === "+" || event.key === "=") resize(size * 1.1);
    else if (event.key === "-") resize(size / 1.1);
    else return;
    event.preventDefault();
  };
  const zoomTo = (level: number) => {
    setZoom(level);
    setView(viewOf(extract, [x, y], zooms[level]!));
  };

  return (
    <div class="extract">
      <svg
        ref={svg}
        viewBox={`${view.left} ${view.top} ${shown} ${view.bottom - view.top}`}
        role="group"
        aria-label="What the file covers, and where it is built up"
        onPointerDown={(event) => {
          const at = pointOf(event);
          place(at, size); // and drag it from there
          grip.current = { what: "move", from: at, at: extract.placed(at, size), side: size };
          svg.current!.setPointerCapture(event.pointerId);
        }}
        onPointerMove={drag}
        onPointerUp={() => (grip.current = null)}
        onPointerCancel={() => (grip.current = null)}
      >
        <rect class="extract-land" width={extract.size.width} height={extract.size.height} />
        {shades.map((path, i) => (
          <path key={i} class="extract-built" d={path} opacity={(i + 1) / shadeCount} />
        ))}
        {extract.placesIn(view).map(({ name, at }) => (
          <text key={name} class="extract-name" x={at[0]} y={at[1] - shown / 50} font-size={shown / 32}>
            {plainName(name)}
          </text>
        ))}
        <g
          class="extract-window"
          tabindex={0} // SVG knows no tabIndex
          role="button"
          aria-label={`Window of ${length(size, metres)}. Arrow keys move it, plus and minus resize it.`}
          onPointerDown={hold("move")}
          onKeyDown={press}
        >
          <rect x={x - side / 2} y={y - side / 2} width={side} height={side} />
        </g>
        <circle class="extract-handle" cx={x + side / 2} cy={y + side / 2} r={shown / 60} onPointerDown={hold("resize")} />
      </svg>
      <div class="extract-zoom" role="group" aria-label="Zoom">
        <button type="button" aria-label="Zoom in" disabled={zoom === zooms.length - 1} onClick={() => zoomTo(zoom + 1)}>
          +
        </button>
        <button type="button" aria-label="Zoom out" disabled={zoom === 0} onClick={() => zoomTo(zoom - 1)}>
          −
        </button>
      </div>
    </div>
  );
}

const arrows: Record<string, Point> = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };

// All of the extract, or so much of it around a point; a little of what lies around it.
function viewOf({ size }: Extract, [x, y]: Point, zoom: number): Box {
  const whole = Math.max(size.width, size.height) * 1.06;
  const side = whole / zoom;
  const from = (at: number, length: number) => {
    const [least, most] = [(length - whole) / 2, (length + whole) / 2 - side];
    return Math.min(Math.max(at - side / 2, least), most);
  };
  const [left, top] = [from(x, size.width), from(y, size.height)];
  return { left, top, right: left + side, bottom: top + side };
}
