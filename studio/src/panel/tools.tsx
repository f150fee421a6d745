// What the pointer does on the map.
import type { Tool } from "../domain/scene";
import type { Studio } from "../mission/studio";
import { Segmented } from "./controls";
import type { IconName } from "./icons";

const tools: { value: Tool; label: string; icon: IconName }[] = [
  { value: "move", label: "Move", icon: "move" },
  { value: "wall", label: "Draw wall", icon: "wall" },
  { value: "erase", label: "Erase", icon: "erase" },
];

export function Tools({ studio }: { studio: Studio }) {
  if (!studio.page.shown.value) return <div class="tools" />; // keeps their place
  return (
    <div class="tools">
      <Segmented
        legend="Tool"
        choices={tools}
        value={studio.editor.tool.value}
        onChange={(tool) => (studio.editor.tool.value = tool)}
      />
    </div>
  );
}
