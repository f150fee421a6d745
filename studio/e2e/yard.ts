// A map of one's own: a wall in a yard, with a way round each end.
import { writeFileSync } from "node:fs";
import { join } from "node:path";

export function yardFile(folder: string): string {
  const file = join(folder, "yard.map");
  const rows = Array.from({ length: 20 }, (_, y) => (y > 3 && y < 16 ? "........@@@........." : "....................")).join("\n");
  writeFileSync(file, `type octile\nheight 20\nwidth 20\nmap\n${rows}\n`);
  return file;
}
