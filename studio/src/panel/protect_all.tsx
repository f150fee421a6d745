// Protects all obstacles of one use: all theatres, all museums.
import { useMemo } from "preact/hooks";
import { usesAmong } from "../domain/obstacle_words";
import type { Studio } from "../mission/studio";

export function ProtectAll({ studio }: { studio: Studio }) {
  const shown = studio.page.shown.value;
  const cells = shown?.base.cells;
  const uses = useMemo(() => (cells ? usesAmong(cells.obstacles) : []), [cells]);
  if (uses.length === 0) return null;
  return (
    <div class="number-field">
      <label for="protect-all">Protect all</label>
      <select
        id="protect-all"
        value=""
        onChange={(event) => {
          studio.editor.protectAll(uses.find(({ name }) => name === event.currentTarget.value)?.rules ?? []);
          event.currentTarget.value = "";
        }}
      >
        <option value="">choose …</option>
        {uses.map(({ name, obstacles }) => (
          <option key={name} value={name}>
            {name} ({obstacles})
          </option>
        ))}
      </select>
    </div>
  );
}
