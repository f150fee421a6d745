// Moves, zooms and plays the map of a large city. `node bench/frames.mjs` runs it and measures the frames.
import type { Scene } from "../src/domain/scene";
import { MapView } from "../src/map/map_view";
import { city, withTeam } from "./city";

declare global {
  interface Window {
    done?: boolean;
  }
}

// Marks for the measuring script what comes next.
async function frames(name: string, count: number, step: (i: number) => void): Promise<void> {
  performance.mark(`bench: ${name}`);
  for (let i = 0; i < count; ++i) {
    step(i);
    await new Promise(requestAnimationFrame);
  }
}

const scene = city();
const canvas = document.querySelector("canvas")!;
const nothing = (): void => {};
const view = new MapView(canvas, { drag: nothing, select: nothing, hover: nothing, choose: nothing, draw: nothing });
const middle: [number, number] = [canvas.clientWidth / 2, canvas.clientHeight / 2];
const show = (change: Partial<Scene>): void => view.show({ ...scene, ...change });
const pan = (i: number): void => view.panBy(i % 120 < 60 ? 24 : -24, i % 60 < 30 ? 14 : -14);

await frames("first pictures", 60, (i) => i === 0 && view.show(scene));
await frames("zoom in 200 times", 180, () => view.zoomBy(1.03, middle, false));
await frames("zoom out", 180, () => view.zoomBy(1 / 1.03, middle, false));
await frames("glide nearer", 40, (i) => i === 0 && view.zoom(5, middle));
await frames("pan, 1 pixel a cell", 180, pan);
await frames("glide nearer again", 40, (i) => i === 0 && view.zoom(6, middle));
await frames("pan, 6 pixels a cell", 180, pan);
await frames("glide back to all", 40, (i) => i === 0 && view.fit());
await frames("play, whole city", 180, (i) => show({ time: 33 * i }));
await frames("glide to the agents", 40, (i) => i === 0 && view.zoom(4, middle));
await frames("play, near", 180, (i) => show({ time: 33 * i }));
const team = withTeam(scene, 100);
await frames("glide back again", 40, (i) => i === 0 && view.fit());
await frames("play 100 vehicles", 180, (i) => view.show({ ...team, time: 33 * i }));
await frames("glide to some", 40, (i) => i === 0 && view.zoom(4, middle));
await frames("play them, near", 180, (i) => view.show({ ...team, time: 33 * i }));
performance.mark("bench: end");
window.done = true;
