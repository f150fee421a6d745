// The clock of playback. Its time is the plan's; how fast it runs follows from the mission's length, so that a short
// and a long one are both seen in about twelve seconds.
import { signal } from "@preact/signals";

export const speeds = [0.25, 0.5, 1, 2, 4, 8] as const;

const secondsAtSpeedOne = 12;

// Where frames come from: the browser, or a test.
export interface Frames {
  request(callback: (milliseconds: number) => void): number;
  cancel(handle: number): void;
}

const browserFrames: Frames = {
  request: (callback) => requestAnimationFrame(callback),
  cancel: (handle) => cancelAnimationFrame(handle),
};

export class Clock {
  readonly time = signal<number | null>(null); // null: not in playback, the whole plan is shown
  readonly playing = signal(false);
  readonly speed = signal(1);
  readonly duration = signal(0);
  readonly follows = signal(false); // whether the map goes along with the agent

  #frame: number | null = null;
  #last: number | null = null;

  constructor(private readonly frames: Frames = browserFrames) {}

  // Another plan: its time goes on from the same share of the way, so that plans can be compared while they play.
  load(duration: number): void {
    const before = this.duration.value;
    if (duration === before) return;
    this.duration.value = duration;
    if (duration <= 0) this.stop();
    else if (this.time.value !== null && before > 0) this.time.value = (this.time.value / before) * duration;
  }

  // A plan that goes on as the one before did until then.
  goOn(time: number, duration: number): void {
    this.pause();
    this.duration.value = duration;
    this.seek(time);
  }

  play(): void {
    if (this.playing.value || this.duration.value <= 0) return;
    if (this.time.value === null || this.time.value >= this.duration.value) this.time.value = 0;
    this.playing.value = true;
    this.#last = null;
    this.#frame = this.frames.request(this.#tick);
  }

  pause(): void {
    this.playing.value = false;
    if (this.#frame !== null) this.frames.cancel(this.#frame);
    this.#frame = null;
  }

  toggle(): void {
    if (this.playing.value) this.pause();
    else this.play();
  }

  seek(time: number): void {
    this.time.value = Math.min(Math.max(time, 0), this.duration.value);
  }

  // Leaves playback: the map shows whole paths again.
  stop(): void {
    this.pause();
    this.time.value = null;
  }

  readonly #tick = (milliseconds: number): void => {
    const passed = this.#last === null ? 0 : (milliseconds - this.#last) / 1000;
    this.#last = milliseconds;
    this.seek((this.time.value ?? 0) + (passed * this.speed.value * this.duration.value) / secondsAtSpeedOne);
    if (this.time.value! >= this.duration.value) this.pause();
    else this.#frame = this.frames.request(this.#tick);
  };
}
