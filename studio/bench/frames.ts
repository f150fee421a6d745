// Measures the frames of the map view while the map is moved, zoomed and played. `node bench/frames.mjs` runs it.
import { MapView } from "../src/map/map_view";
import type { Scene } from "../src/map/scene";
import { city } from "./city";

interface Figures {
  frames: number;
  work: string; // milliseconds of the main thread in a frame's callbacks: median, 95 %, worst
  interval: string; // milliseconds from frame to frame, likewise
}

// Every callback of a frame is timed, whoever asked for it.
let work = 0;
const request = window.requestAnimationFrame.bind(window);
window.requestAnimationFrame = (callback) =>
  request((now) => {
    const begin = performance.now();
    callback(now);
    work += performance.now() - begin;
  });

const nextFrame = (): Promise<number> => new Promise((resolve) => request(resolve));

async function measured(frames: number, step: (i: number) => void): Promise<Figures> {
  const works: number[] = [];
  const intervals: number[] = [];
  let last = await nextFrame();
  for (let i = 0; i < frames; ++i) {
    work = 0;
    const begin = performance.now();
    step(i);
    const asked = performance.now() - begin;
    const now = await nextFrame(); // its callback comes after the view's
    works.push(asked + work);
    intervals.push(now - last);
    last = now;
  }
  return { frames, work: figures(works), interval: figures(intervals) };
}

function figures(values: number[]): string {
  const sorted = [...values].sort((a, b) => a - b);
  const at = (share: number): string => sorted[Math.min(sorted.length - 1, Math.floor(share * sorted.length))]!.toFixed(1);
  return `${at(0.5)} / ${at(0.95)} / ${at(1)}`;
}

async function run(): Promise<Record<string, Figures | string>> {
  const scene = city();
  const canvas = document.querySelector("canvas")!;
  const nothing = (): void => {};
  const view = new MapView(canvas, { drag: nothing, select: nothing, hover: nothing, draw: nothing });
  const begin = performance.now();
  view.show(scene);
  await nextFrame();
  const first = `${(performance.now() - begin).toFixed(0)} ms`;
  const settle = await measured(60, nothing);
  const middle: [number, number] = [canvas.clientWidth / 2, canvas.clientHeight / 2];
  const show = (change: Partial<Scene>): void => view.show({ ...scene, ...change });
  const results: Record<string, Figures | string> = { "first picture": first, "whole city, until sharp": settle };
  results["zoom in by 200"] = await measured(180, () => view.zoomBy(1.03, middle, false));
  results["zoom out by 200"] = await measured(180, () => view.zoomBy(1 / 1.03, middle, false));
  view.zoomBy(5, middle, false);
  await measured(30, nothing);
  results["pan fast, 1 pixel a cell"] = await measured(180, (i) => view.panBy(i % 120 < 60 ? 24 : -24, i % 60 < 30 ? 14 : -14));
  view.zoomBy(6, middle, false);
  await measured(30, nothing);
  results["pan fast, 6 pixels a cell"] = await measured(180, (i) => view.panBy(i % 120 < 60 ? 24 : -24, 10));
  view.fit();
  await measured(60, nothing);
  results["play, whole city"] = await measured(180, (i) => show({ time: 33 * i }));
  view.zoomBy(4, middle, false);
  await measured(30, nothing);
  results["play, near"] = await measured(180, (i) => show({ time: 33 * i }));
  return results;
}

declare global {
  interface Window {
    figures?: Record<string, Figures | string>;
  }
}

window.figures = await run();
