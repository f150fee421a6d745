// Runs as text for an address: differences between neighbours as numbers of 7 bits a byte, in base64 for addresses.
import type { Run } from "../domain/geometry";

const mostRuns = 100_000;

export function encodeRuns(runs: readonly Run[]): string {
  const bytes: number[] = [];
  let [x, y] = [0, 0];
  for (const [from, row, length] of runs) {
    if (row !== y) x = 0;
    push(bytes, row - y);
    push(bytes, from - x);
    push(bytes, length);
    y = row;
    x = from + length;
  }
  const text = btoa(bytes.map((byte) => String.fromCharCode(byte)).join(""));
  return text.replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "");
}

// Throws where the text is no such runs.
export function decodeRuns(text: string): Run[] {
  const bytes = atob(text.replaceAll("-", "+").replaceAll("_", "/"));
  const runs: Run[] = [];
  let at = 0;
  let [x, y] = [0, 0];
  const next = () => {
    let value = 0;
    for (let shift = 0; shift < 35; shift += 7) {
      if (at >= bytes.length) break;
      const byte = bytes.charCodeAt(at++);
      value += (byte & 127) * 2 ** shift;
      if (byte < 128) return value;
    }
    throw new Error("the runs are cut off");
  };
  while (at < bytes.length && runs.length < mostRuns) {
    const down = next();
    if (down > 0) x = 0;
    y += down;
    x += next();
    const length = next();
    runs.push([x, y, length]);
    x += length;
  }
  return runs;
}

function push(bytes: number[], value: number): void {
  let left = value;
  for (; left >= 128; left = Math.floor(left / 128)) bytes.push((left % 128) + 128);
  bytes.push(left);
}
