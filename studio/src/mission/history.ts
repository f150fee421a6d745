// Undo and redo of immutable values. Changes of one gesture (a drag, a sweep of a slider) are one step.
export interface History<T> {
  past: readonly T[];
  present: T;
  future: readonly T[];
  gesture: string | null; // the gesture the last step belongs to, while it goes on
}

const mostSteps = 200;

export function begin<T>(present: T): History<T> {
  return { past: [], present, future: [], gesture: null };
}

// A step; with the gesture of the last one, a part of it.
export function step<T>(history: History<T>, present: T, gesture: string | null = null): History<T> {
  const goesOn = gesture !== null && gesture === history.gesture;
  const past = goesOn ? history.past : [...history.past, history.present].slice(-mostSteps);
  return { past, present, future: [], gesture };
}

export function endGesture<T>(history: History<T>): History<T> {
  return { ...history, gesture: null };
}

// Changes that are not steps: how the mission is displayed.
export function replace<T>(history: History<T>, present: T): History<T> {
  return { ...history, present };
}

// The same changed in every step: something has another name now.
export function mapped<T>(history: History<T>, how: (value: T) => T): History<T> {
  return { ...history, past: history.past.map(how), present: how(history.present), future: history.future.map(how) };
}

export function undo<T>(history: History<T>): History<T> {
  const present = history.past.at(-1);
  if (present === undefined) return history;
  return {
    past: history.past.slice(0, -1),
    present,
    future: [history.present, ...history.future],
    gesture: null,
  };
}

export function redo<T>(history: History<T>): History<T> {
  const [present, ...future] = history.future;
  if (present === undefined) return history;
  return { past: [...history.past, history.present], present, future, gesture: null };
}
