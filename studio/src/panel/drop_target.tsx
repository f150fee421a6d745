// A map file can be dropped anywhere on the page.
import { useEffect, useState } from "preact/hooks";
import type { Studio } from "../mission/studio";

export function DropTarget({ studio }: { studio: Studio }) {
  const [over, setOver] = useState(false);
  useEffect(() => {
    const ended = new AbortController();
    const on = (name: "dragover" | "dragleave" | "drop", act: (event: DragEvent) => void) =>
      addEventListener(name, act, { signal: ended.signal });
    on("dragover", (event) => {
      if (!event.dataTransfer?.types.includes("Files")) return;
      event.preventDefault();
      setOver(true);
    });
    on("dragleave", (event) => event.relatedTarget === null && setOver(false));
    on("drop", (event) => {
      event.preventDefault();
      setOver(false);
      const file = event.dataTransfer?.files[0];
      if (file) void studio.upload(file);
    });
    return () => ended.abort();
  }, [studio]);
  return over ? (
    <div class="drop-target">
      <p>Drop the map file anywhere</p>
    </div>
  ) : null;
}
