import { describe, expect, it } from "vitest";
import { Clock, type Frames } from "../../src/play/clock";

// Frames that come when the test says so.
class Hand implements Frames {
  #pending: ((milliseconds: number) => void) | null = null;
  #now = 1000;

  request(callback: (milliseconds: number) => void): number {
    this.#pending = callback;
    return 1;
  }

  cancel(): void {
    this.#pending = null;
  }

  frame(milliseconds: number): void {
    this.#now += milliseconds;
    const callback = this.#pending;
    this.#pending = null;
    callback?.(this.#now);
  }
}

function started(duration: number): { clock: Clock; hand: Hand } {
  const hand = new Hand();
  const clock = new Clock(hand);
  clock.load(duration);
  clock.play();
  hand.frame(16);
  return { clock, hand };
}

describe("the clock", () => {
  it("plays a mission of any length in twelve seconds, then stands at the end", () => {
    for (const duration of [1, 400, 123456]) {
      const { clock, hand } = started(duration);
      for (let i = 0; i < 600; ++i) hand.frame(10);
      expect(clock.time.value).toBeCloseTo(duration / 2);
      for (let i = 0; i < 601; ++i) hand.frame(10);
      expect(clock.time.value).toBe(duration);
      expect(clock.playing.value).toBe(false);
    }
  });

  it("goes at its speed, and begins anew after the end", () => {
    const { clock, hand } = started(120);
    clock.speed.value = 4;
    hand.frame(1000);
    expect(clock.time.value).toBeCloseTo(40);
    hand.frame(5000);
    expect(clock.time.value).toBe(120);
    clock.play();
    expect(clock.time.value).toBe(0);
  });

  it("pauses, and does not count the pause", () => {
    const { clock, hand } = started(120);
    hand.frame(1000);
    clock.toggle();
    hand.frame(5000);
    expect(clock.time.value).toBeCloseTo(10);
    clock.toggle();
    hand.frame(5000);
    hand.frame(1000);
    expect(clock.time.value).toBeCloseTo(20);
  });

  it("keeps to the mission when it is scrubbed", () => {
    const clock = new Clock(new Hand());
    clock.load(100);
    clock.seek(250);
    expect(clock.time.value).toBe(100);
    clock.seek(-3);
    expect(clock.time.value).toBe(0);
  });

  it("goes on from the same share of another plan", () => {
    const { clock } = started(100);
    clock.seek(30);
    clock.load(200);
    expect(clock.time.value).toBe(60);
    expect(clock.playing.value).toBe(true);
    clock.load(0);
    expect(clock.time.value).toBeNull();
    expect(clock.playing.value).toBe(false);
  });

  it("leaves playback when it is stopped, and does not play nothing", () => {
    const { clock } = started(100);
    clock.stop();
    expect(clock.time.value).toBeNull();
    const idle = new Clock(new Hand());
    idle.play();
    expect(idle.playing.value).toBe(false);
  });
});
