import { expect, it } from "vitest";
import { begin, endGesture, redo, replace, step, undo } from "../../src/mission/history";

it("goes back and forth", () => {
  let history = step(step(begin("a"), "b"), "c");
  history = undo(history);
  expect(history.present).toBe("b");
  history = undo(undo(history));
  expect(history.present).toBe("a");
  history = redo(redo(redo(history)));
  expect(history.present).toBe("c");
});

it("forgets what was undone when something else is done", () => {
  const history = step(undo(step(begin("a"), "b")), "c");
  expect(redo(history).present).toBe("c");
  expect(undo(history).present).toBe("a");
});

it("takes a gesture back as one step", () => {
  let history = begin(0);
  for (const n of [1, 2, 3]) history = step(history, n, "drag start");
  history = endGesture(history);
  for (const n of [4, 5]) history = step(history, n, "drag start");
  history = step(history, 6, "removals");
  const seen = [];
  for (let h = history; h.past.length > 0;) seen.push((h = undo(h)).present);
  expect(seen).toEqual([5, 3, 0]);
});

it("does not count what is only looked at differently", () => {
  const history = replace(step(begin("a"), "b"), "B");
  expect(history.present).toBe("B");
  expect(undo(history).present).toBe("a");
});

it("does not grow for ever", () => {
  let history = begin(0);
  for (let n = 1; n < 1000; ++n) history = step(history, n);
  expect(history.past.length).toBeLessThanOrEqual(200);
});
