// What a person may say about an obstacle.
import type { Mark } from "../domain/mission";
import { filterText } from "../domain/tag_filter";
import type { Studio } from "../mission/studio";
import { Icon, type IconName } from "./icons";

const marks: { mark: Mark; verb: string; icon: IconName; hint: string }[] = [
  { mark: "protect", verb: "Protect", icon: "protect", hint: "never remove it" },
  { mark: "force", verb: "Force", icon: "force", hint: "always remove it" },
  { mark: "exclude", verb: "Exclude", icon: "exclude", hint: "plan as if it were not there" },
];

interface Props {
  studio: Studio;
  id: number;
  name: string;
  large?: boolean;
}

export function MarkButtons({ studio, id, name, large = false }: Props) {
  const has = studio.page.markOf(id);
  const rule = studio.page.ruleOf(id);
  if (rule) return <p class="mark-rule">It has to stay, as all {filterText(rule)}: see “Your choices”.</p>;
  return (
    <span class={`mark-buttons ${large ? "large" : ""}`} role="group" aria-label={`Your choice for ${name}`}>
      {marks.map(({ mark, verb, icon, hint }) => (
        <button
          key={mark}
          type="button"
          class={`mark-button ${mark}`}
          aria-pressed={has === mark}
          aria-label={`${verb} ${name}`}
          title={`${verb}: ${hint}`}
          onClick={() => studio.editor.mark(id, has === mark ? null : mark)}
        >
          <Icon name={icon} />
          <span>{verb}</span>
        </button>
      ))}
    </span>
  );
}
