// The plan and the map as files, and the mission as a link.
import type { ExportFormat } from "../api/client";
import type { Studio } from "../mission/studio";
import { copyLink, downloadMap, downloadMission, downloadPlan } from "../mission/taken";
import { Section } from "./controls";
import { Icon } from "./icons";

const formats: { format: ExportFormat; label: string; hint?: string }[] = [
  { format: "html", label: "Page (HTML)", hint: "One file that shows and plays the plan in any browser" },
  { format: "png", label: "Picture (PNG)" },
  { format: "svg", label: "SVG" },
  { format: "json", label: "Plan (JSON)" },
  { format: "geojson", label: "GeoJSON" },
  { format: "csv", label: "CSV" },
];

export function TakeAlong({ studio }: { studio: Studio }) {
  const plan = studio.page.results.plans.value.after?.plan;
  const shown = studio.page.shown.value;
  if (!plan || !shown) return null;
  const held = studio.held.value;
  const solved = held !== null && held.agents.length > 0;
  const placed = shown.map.description.georeference !== null;
  return (
    <Section title="Take it along" kind="take-along">
      <div class="downloads">
        <button type="button" class="button" onClick={() => void copyLink(studio)}>
          <Icon name="link" /> Copy link
        </button>
        {formats.filter(({ format }) => studio.client.imports || format !== "html").map(({ format, label, hint }) => (
          <button
            key={format}
            type="button"
            class="button"
            disabled={!solved || studio.page.old.value || (format === "geojson" && !placed)}
            title={format === "geojson" && !placed ? "The map does not say where on earth it lies" : hint}
            onClick={() => void downloadPlan(studio, format)}
          >
            <Icon name="download" /> {label}
          </button>
        ))}
        <button type="button" class="button" onClick={() => downloadMission(studio)}>
          <Icon name="download" /> Mission
        </button>
        {studio.client.hasFile(shown.map.description.id) && (
          <button type="button" class="button" onClick={() => void downloadMap(studio)}>
            <Icon name="download" /> Map file
          </button>
        )}
      </div>
      {solved && held !== plan && (
        <p class="hint">Plans and pictures are of the plan as revised last; link, mission and map stay as they were.</p>
      )}
      {!studio.client.imports && (
        <p class="hint">
          This page plans by itself, without a server. To write maps as files after drawing on them, and pages of plans, start{" "}
          <code>waybreaker serve</code>.
        </p>
      )}
    </Section>
  );
}
