// Protects all obstacles of one use: all theatres, all museums.
import { obstaclesByUse } from "../domain/obstacle_words";
import type { Studio } from "../mission/studio";

export function ProtectAll({ studio }: { studio: Studio }) {
  const shown = studio.shown.value;
  const uses = shown ? [...obstaclesByUse(shown.base.cells.obstacles)] : [];
  if (uses.length === 0) return null;
  const protect = (use: string) => {
    const ids = uses.find(([name]) => name === use)?.[1] ?? [];
    studio.change((old) => ({ ...old, marks: new Map([...old.marks, ...ids.map((id) => [id, "protect"] as const)]) }));
  };
  return (
    <div class="number-field">
      <label for="protect-all">Protect all</label>
      <select
        id="protect-all"
        value=""
        onChange={(event) => {
          protect(event.currentTarget.value);
          event.currentTarget.value = "";
        }}
      >
        <option value="">choose …</option>
        {uses.map(([use, ids]) => (
          <option key={use} value={use}>
            {use} ({ids.length})
          </option>
        ))}
      </select>
    </div>
  );
}
