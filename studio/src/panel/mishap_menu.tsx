// The menu of what can go wrong at a place of the map, opened by a right click, a long press or the keyboard.
import type { Signal } from "@preact/signals";
import { useLayoutEffect, useRef } from "preact/hooks";
import type { Point } from "../domain/geometry";
import type { Pointed } from "../domain/scene";
import type { Studio } from "../mission/studio";
import { mishapsAt } from "./mishaps";

export interface Asked {
  what: Pointed;
  at: Point; // pixels of the map
}

export function MishapMenu({ studio, asked }: { studio: Studio; asked: Signal<Asked | null> }) {
  const open = asked.value;
  const menu = useRef<HTMLDivElement>(null);
  // Before anybody can press a key: the arrows are the menu's as soon as it is there.
  useLayoutEffect(() => {
    if (!open || !menu.current) return;
    // It stays on the map. Where it is, is set here: the page's security policy forbids styles in elements.
    const { offsetWidth: width, offsetHeight: height, offsetParent, style } = menu.current;
    const [x, y] = open.at;
    style.left = `${Math.max(4, Math.min(x, (offsetParent?.clientWidth ?? width) - width - 4))}px`;
    style.top = `${Math.max(4, Math.min(y, (offsetParent?.clientHeight ?? height) - height - 4))}px`;
    const before = document.activeElement as HTMLElement | null;
    menu.current.querySelector("button")?.focus();
    const away = (event: Event) => menu.current?.contains(event.target as Node) || (asked.value = null);
    addEventListener("pointerdown", away, true);
    return () => {
      removeEventListener("pointerdown", away, true);
      before?.focus();
    };
  }, [open]);
  if (!open) return null;
  return (
    <div ref={menu} class="mishap-menu" role="menu" aria-label="What goes wrong here" onKeyDown={(event) => onKey(event, asked)}>
      {mishapsAt(studio, open.what).map(({ told, act }) => (
        <button
          key={told}
          type="button"
          role="menuitem"
          tabIndex={-1}
          onClick={() => {
            asked.value = null;
            act();
          }}
        >
          {told}
        </button>
      ))}
    </div>
  );
}

const steps: Record<string, number> = { ArrowDown: 1, ArrowUp: -1 };

function onKey(event: KeyboardEvent, asked: Signal<Asked | null>): void {
  const items = [...(event.currentTarget as HTMLElement).querySelectorAll("button")];
  const now = items.indexOf(document.activeElement as HTMLButtonElement);
  const step = steps[event.key];
  if (step) items[(now + step + items.length) % items.length]!.focus();
  else if (event.key === "Home") items[0]!.focus();
  else if (event.key === "End") items.at(-1)!.focus();
  else if (event.key === "Escape" || event.key === "Tab") asked.value = null;
  else return;
  event.preventDefault();
  event.stopPropagation();
}
