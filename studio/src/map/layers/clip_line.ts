// The pieces of a line that can be seen. Dashes of what is far outside of the view cost as much as those within.
import type { Box, Point } from "../../domain/geometry";

export interface Piece {
  points: Point[];
  offset: number; // length of the line before the piece, so that dashes stay where they are
}

export function lengthOf(line: readonly Point[]): number {
  return line.reduce((sum, point, i) => (i === 0 ? 0 : sum + distance(line[i - 1]!, point)), 0);
}

export function clipped(line: readonly Point[], box: Box): Piece[] {
  const pieces: Piece[] = [];
  let length = 0;
  let open: Piece | null = null; // ends at the point before
  for (let i = 1; i < line.length; ++i) {
    const [a, b] = [line[i - 1]!, line[i]!];
    const whole = distance(a, b);
    const part = inside(a, b, box);
    if (part) {
      const [from, until] = part;
      if (!open) {
        open = { points: [between(a, b, from)], offset: length + from * whole };
        pieces.push(open);
      }
      open.points.push(between(a, b, until));
      if (until < 1) open = null;
    } else open = null;
    length += whole;
  }
  return pieces;
}

function distance(a: Point, b: Point): number {
  return Math.hypot(b[0] - a[0], b[1] - a[1]);
}

function between([ax, ay]: Point, [bx, by]: Point, share: number): Point {
  if (share === 0) return [ax, ay];
  return share === 1 ? [bx, by] : [ax + share * (bx - ax), ay + share * (by - ay)];
}

// Which share of the way from a to b is in the box (after Liang and Barsky, 1984).
function inside([ax, ay]: Point, [bx, by]: Point, box: Box): [from: number, until: number] | null {
  let from = 0;
  let until = 1;
  // Each side lets pass what is at `room` or less; `step` is how much nearer to it the way comes.
  const sides = [
    [ax - bx, ax - box.left],
    [bx - ax, box.right - ax],
    [ay - by, ay - box.top],
    [by - ay, box.bottom - ay],
  ] as const;
  for (const [step, room] of sides) {
    if (step === 0 && room < 0) return null;
    if (step < 0) from = Math.max(from, room / step);
    if (step > 0) until = Math.min(until, room / step);
  }
  return from <= until ? [from, until] : null;
}
