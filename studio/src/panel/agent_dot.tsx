// The colour of an agent, as on the map. A class says it: the page's security policy forbids styles in elements.
import type { AgentLook } from "../domain/agents";

export function AgentDot({ look }: { look: AgentLook | undefined }) {
  if (!look) return null;
  return (
    <svg class={`agent-dot agent-${look.kind}-${look.colour}`} width="14" height="14" aria-hidden="true">
      {look.kind === "ground" ? <circle cx="7" cy="7" r="6" /> : <rect x="1.5" y="1.5" width="11" height="11" rx="2.5" />}
    </svg>
  );
}
