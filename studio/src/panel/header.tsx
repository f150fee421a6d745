// Name, undo and redo, link, help; and the keys that work everywhere.
import { useEffect, useState } from "preact/hooks";
import type { Tool } from "../domain/scene";
import type { Studio } from "../mission/studio";
import { copyLink } from "../mission/taken";
import { IconButton } from "./controls";
import { HelpDialog } from "./dialogs";
import { Sign } from "./icons";

const toolKeys: Record<string, Tool> = { m: "move", w: "wall", e: "erase", z: "zone", r: "rubble" };

export function Header({ studio }: { studio: Studio | null }) {
  const [help, setHelp] = useState(false);
  useEffect(() => {
    if (!studio) return;
    const press = (event: KeyboardEvent) => onKey(event, studio, () => setHelp(true));
    addEventListener("keydown", press);
    return () => removeEventListener("keydown", press);
  }, [studio]);
  return (
    <header class="header">
      <Sign />
      <h1>waybreaker</h1>
      {studio && (
        <div class="header-buttons" role="group" aria-label="Mission">
          <IconButton icon="undo" label="Undo" disabled={!studio.canUndo.value} onClick={() => studio.undo()} />
          <IconButton icon="redo" label="Redo" disabled={!studio.editor.canRedo.value} onClick={() => studio.editor.redo()} />
          <IconButton icon="link" label="Copy link to this mission" onClick={() => void copyLink(studio)} />
          <IconButton icon="help" label="Help" onClick={() => setHelp(true)} />
        </div>
      )}
      <HelpDialog open={help} onClose={() => setHelp(false)} />
    </header>
  );
}

function onKey(event: KeyboardEvent, studio: Studio, openHelp: () => void): void {
  if (event.defaultPrevented) return;
  const target = event.target as Element | null;
  const typing = target?.closest("input:not([type=range], [type=checkbox], [type=radio]), textarea, select, dialog");
  if (typing) return;
  const key = event.key.toLowerCase();
  if (event.ctrlKey || event.metaKey) {
    if (event.altKey || (key !== "z" && key !== "y")) return;
    event.preventDefault();
    if (key === "y" || event.shiftKey) studio.editor.redo();
    else studio.undo();
    return;
  }
  if (event.altKey) return;
  const tool = toolKeys[key];
  if (tool && (tool !== "rubble" || studio.rehearsal.available.value)) studio.editor.tool.value = tool;
  else if (key === "?") openHelp();
  else if (key === "/") document.getElementById("search")?.focus();
  else if (key === "escape") studio.page.selected.value = null;
  else if (key === " " && !target?.closest("button, a, summary, input, [role=button]")) studio.page.clock.toggle();
  else return;
  event.preventDefault();
}
