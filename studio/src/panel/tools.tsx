// What the pointer does on the map.
import type { Tool } from "../domain/scene";
import type { Studio } from "../mission/studio";
import { nameOf } from "../play/story";
import { Segmented } from "./controls";
import type { IconName } from "./icons";

interface ToolChoice {
  value: Tool;
  label: string;
  icon: IconName;
}

const rubble: ToolChoice = { value: "rubble", label: "Rubble", icon: "rubble" };
const base: ToolChoice = { value: "base", label: "Base", icon: "base" };
const tools: ToolChoice[] = [
  { value: "move", label: "Move", icon: "move" },
  { value: "wall", label: "Draw wall", icon: "wall" },
  { value: "erase", label: "Erase", icon: "erase" },
  { value: "zone", label: "Zone", icon: "zone" },
];

export function Tools({ studio }: { studio: Studio }) {
  const tool = studio.editor.tool.value;
  if (!studio.page.shown.value) return <div class="tools" />; // keeps their place
  return (
    <div class="tools">
      <Segmented
        legend="Tool"
        choices={[...tools, ...(isPlayed(studio) ? [rubble] : []), ...(tool === "base" ? [base] : [])]}
        value={tool}
        onChange={(chosen) => (studio.editor.tool.value = chosen)}
      />
      {tool === "zone" && <ZoneTool studio={studio} />}
      {tool === "base" && <BaseTool studio={studio} />}
    </div>
  );
}

// Whom the zone is for that is drawn next, and how it is drawn.
function ZoneTool({ studio }: { studio: Studio }) {
  const { kind, corners } = studio.zones;
  const count = corners.value;
  const begun = count < 3 ? "corner by corner" : "click the first corner again to close it";
  return (
    <div class="zone-tool">
      <Segmented
        legend="Who keeps out"
        choices={[
          { value: "no_fly", label: "Aircraft keep out" },
          { value: "keep_out", label: "Vehicles keep out" },
        ]}
        value={kind.value}
        onChange={(chosen) => (kind.value = chosen)}
      />
      <p role="status">
        {count === 0 ? "Click the corners of the zone." : `${count === 1 ? "1 corner" : `${count} corners`}: ${begun}.`}
      </p>
    </div>
  );
}

// Whose base is set next.
function BaseTool({ studio }: { studio: Studio }) {
  const aircraft = studio.bases.aircraft.value;
  return (
    <div class="zone-tool">
      <p role="status">{aircraft ? `Click where ${nameOf(aircraft)} can recharge.` : "No aircraft recharges."}</p>
    </div>
  );
}

// Whether rubble may fall: while the mission is played.
function isPlayed({ page, rehearsal, editor }: Studio): boolean {
  const isBegun = page.clock.time.value !== null || rehearsal.steps.value.length > 0 || editor.tool.value === "rubble";
  return rehearsal.available.value && isBegun;
}
