// What the pointer does on the map.
import type { Tool } from "../domain/scene";
import type { Studio } from "../mission/studio";
import { Segmented } from "./controls";
import type { IconName } from "./icons";

interface ToolChoice {
  value: Tool;
  label: string;
  icon: IconName;
}

const rubble: ToolChoice = { value: "rubble", label: "Rubble", icon: "rubble" };
const tools: ToolChoice[] = [
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
        choices={isPlayed(studio) ? [...tools, rubble] : tools}
        value={studio.editor.tool.value}
        onChange={(tool) => (studio.editor.tool.value = tool)}
      />
    </div>
  );
}

// Whether rubble may fall: while the mission is played.
function isPlayed({ page, rehearsal, editor }: Studio): boolean {
  const isBegun = page.clock.time.value !== null || rehearsal.steps.value.length > 0 || editor.tool.value === "rubble";
  return rehearsal.available.value && isBegun;
}
