// Files and links can be dropped anywhere on the page, and links pasted.
import { useEffect, useState } from "preact/hooks";
import { missionInText } from "../mission/given";
import { openFiles, openMission } from "../mission/opening";
import type { Studio } from "../mission/studio";

export function DropTarget({ studio }: { studio: Studio }) {
  const [over, setOver] = useState(false);
  useEffect(() => {
    const ended = new AbortController();
    const on = <K extends "dragover" | "dragleave" | "drop" | "paste">(name: K, act: (event: WindowEventMap[K]) => void) =>
      addEventListener(name, act, { signal: ended.signal });
    on("dragover", (event) => {
      if (!event.dataTransfer || !isTaken(event.dataTransfer)) return;
      event.preventDefault();
      setOver(true);
    });
    on("dragleave", (event) => event.relatedTarget === null && setOver(false));
    on("drop", (event) => {
      event.preventDefault();
      setOver(false);
      if (event.dataTransfer) take(studio, event.dataTransfer);
    });
    on("paste", (event) => {
      const typing = (event.target as Element | null)?.closest?.("input, textarea, select");
      if (!typing && event.clipboardData) take(studio, event.clipboardData);
    });
    return () => ended.abort();
  }, [studio]);
  return over ? (
    <div class="drop-target">
      <p>
        {studio.client.imports
          ? "Drop it anywhere: a map, map data of a city (.osm.pbf), a flood (.geojson), both files of a ROS map, a plan, a mission or a link"
          : "Drop it anywhere: a map of MovingAI's format, a plan, a mission or a link"}
      </p>
    </div>
  ) : null;
}

function isTaken(data: DataTransfer): boolean {
  return data.types.includes("Files") || data.types.includes("text/uri-list");
}

function take(studio: Studio, data: DataTransfer): void {
  const files = [...data.files];
  if (files.length > 0) return void openFiles(studio, files);
  const text = data.getData("text/uri-list") || data.getData("text/plain");
  void missionInText(text).then((query) => {
    if (query) void openMission(studio, query);
    else if (/^\s*https?:/.test(text)) studio.page.notify("bad", "There is no mission in this link.");
  });
}
