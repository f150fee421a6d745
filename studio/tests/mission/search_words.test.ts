import { expect, it } from "vitest";
import type { Units } from "../../src/domain/units";
import { knownText, searchSteps, searchText } from "../../src/mission/search_words";
import type { SearchState } from "../../src/planning/search_state";

const city: Units = { metric: true, cell: 1, time: "seconds", seconds: 1 };
const plain = (text: string | null) => text && text.replaceAll(/[\u00a0\u202f]/g, " ");
const state = (more: Partial<SearchState>): SearchState => ({ stage: "looking", queued: false, seconds: null, best: null, bound: null, ...more });

it("the steps of a search say no more than is known", () => {
  const steps = (...of: Parameters<typeof searchSteps>) => searchSteps(...of).map(({ name, state }) => `${name}: ${state}`);
  expect(steps("waiting", false, false)).toEqual(["Quick answer: now", "Looking: open", "Proven: open"]);
  expect(steps("looking", true, true)).toEqual(["Quick answer: done", "Looking: now", "Proven: open"]);
  expect(steps("looking", false, false)[0]).toBe("Quick answer: open"); // it found nothing
  expect(steps("stopped", true, true)).toEqual(["Quick answer: done", "Looking: open", "Proven: open"]);
  expect(steps("ended", true, false)).toEqual(["Quick answer: done", "Looked: done", "Proven: open"]);
  expect(steps("ended", true, true)[2]).toBe("Proven: done");
});

it("what goes on is said with its time, and nothing where it has ended", () => {
  expect(plain(searchText(state({ stage: "waiting", seconds: 1.2 })))).toBe("Planning, 1 s");
  expect(plain(searchText(state({ seconds: 12.4 })))).toBe("Looking for a better plan, 12 s");
  expect(plain(searchText(state({ queued: true, seconds: 3 })))).toBe("Waiting for the planner, 3 s");
  expect(searchText(state({ stage: "stopped" }))).toBe("Stopped: there may be a better plan.");
  expect(searchText(state({ stage: "ended", seconds: 3 }))).toBeNull();
});

it("says the best so far, and how much there is to gain at most", () => {
  expect(plain(knownText(state({ best: 200, bound: 190 }), city))).toBe(
    "Best so far 3 min 20 s; none is below 3 min 10 s: at most 5 % to gain",
  );
  expect(plain(knownText(state({ best: 200, bound: 200 }), city))).toBe("Best so far 3 min 20 s; none is below 3 min 20 s");
  expect(plain(knownText(state({ best: 200 }), city))).toBe("Best so far 3 min 20 s");
  expect(plain(knownText(state({ bound: 190 }), city))).toBe("No plan is below 3 min 10 s");
  expect(knownText(state({}), city)).toBeNull();
});
