// All that was said about obstacles, and what was drawn, each to be taken back.
import { alsoWords, without } from "../domain/also";
import type { CellMap } from "../domain/cell_map";
import type { Choice as Said } from "../domain/mission";
import { filterText, ruledObstacles, type TagFilter } from "../domain/tag_filter";
import { area } from "../domain/units";
import { cellCount } from "../mission/run_set";
import type { Studio } from "../mission/studio";
import { Section } from "./controls";
import { Icon, type IconName } from "./icons";
import { Name } from "./name";
import { nameOfKey } from "./obstacle_words";

const words: Record<Said, string> = {
  protect: "Protected",
  force: "Forced",
  exclude: "Excluded",
  allow: "May be removed",
};

const mostListed = 12;

export function Choices({ studio }: { studio: Studio }) {
  const mission = studio.page.mission.value;
  const shown = studio.page.shown.value;
  if (!mission || !shown) return null;
  const { marks, protectAll, walls, erased } = mission;
  const also = Object.entries(mission.also);
  if ([also, protectAll, walls, erased].every((some) => some.length === 0) && marks.size === 0) return null;
  const units = studio.page.units.value;
  const [listed, others] = [[...marks].slice(0, mostListed), [...marks].slice(mostListed)];
  return (
    <Section title="Your choices">
      <ul class="choices">
        {also.map(([name, value]) => (
          <Choice
            key={name}
            icon="about"
            text={`Also asked: ${alsoWords(name, value)}`}
            onUndo={() => studio.editor.change((old) => ({ ...old, also: without(old.also, name) }))}
          />
        ))}
        {protectAll.map((rule) => (
          <Choice
            key={filterText(rule)}
            icon="protect"
            text={`Protected: ${ruleWords(rule, shown.map.cells)}`}
            onUndo={() => studio.editor.allowAll(rule)}
          />
        ))}
        {listed.map(([key, mark]) => {
          const id = shown.ids.toShown(key);
          const name = nameOfKey(shown, key).text;
          return (
            <Choice
              key={key}
              icon={mark === "allow" ? "wall" : mark}
              text={`${words[mark]}: ${name}`}
              onUndo={() => studio.editor.markKey(key, null)}
              onPoint={(on) => (studio.page.highlighted.value = on && id !== 0 ? id : null)}
              onShow={id === 0 ? undefined : () => studio.page.showObstacle(id)}
            />
          );
        })}
        {others.length > 0 && (
          <Choice
            icon="protect"
            text={`And ${others.length} obstacles more`}
            onUndo={() => studio.editor.change((old) => ({ ...old, marks: new Map([...old.marks].slice(0, mostListed)) }))}
          />
        )}
        {walls.length > 0 && (
          <Choice
            icon="wall"
            text={`Drawn: ${area(cellCount(walls), units)} of walls, which have to stay unless you say otherwise`}
            onUndo={() => studio.editor.change((old) => ({ ...old, walls: [] }))}
          />
        )}
        {erased.length > 0 && (
          <Choice
            icon="erase"
            text={`Erased: ${area(cellCount(erased), units)}`}
            onUndo={() => studio.editor.change((old) => ({ ...old, erased: [] }))}
          />
        )}
      </ul>
    </Section>
  );
}

// "all amenity=theatre, 12 obstacles".
function ruleWords(rule: TagFilter, cells: CellMap): string {
  const count = ruledObstacles([rule], cells).size;
  return `all ${filterText(rule)}, ${count === 1 ? "1 obstacle" : `${count} obstacles`}`;
}

interface ChoiceProps {
  icon: IconName;
  text: string;
  onUndo: () => void;
  onPoint?: (on: boolean) => void;
  onShow?: (() => void) | undefined; // on the map
}

function Choice({ icon, text, onUndo, onPoint, onShow }: ChoiceProps) {
  return (
    <li class="choice" onPointerEnter={() => onPoint?.(true)} onPointerLeave={() => onPoint?.(false)}>
      <Icon name={icon} />
      {onShow ? (
        <button type="button" class="obstacle-name" onClick={onShow}>
          <Name of={text} />
        </button>
      ) : (
        <Name of={text} />
      )}
      <button
        type="button"
        class="icon-button small"
        aria-label={`Take back: ${text}`}
        title="Take back"
        onClick={() => {
          onPoint?.(false);
          onUndo();
        }}
      >
        <Icon name="close" />
      </button>
    </li>
  );
}
