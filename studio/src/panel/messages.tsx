// What the page says by itself: the server is gone, something went wrong, where to begin, whose data this is.
import { useEffect, useState } from "preact/hooks";
import type { PageState } from "../mission/page_state";
import type { Studio } from "../mission/studio";
import { IconButton } from "./controls";
import { Icon } from "./icons";

export function Gone({ studio }: { studio: Studio }) {
  return (
    <div class="gone-place" role="status">
      {studio.gone.value && (
        <p class="gone">
          <Icon name="warning" />
          <span>
            <strong>The server does not answer.</strong> What you see stays; the page goes on by itself when it is back.
          </span>
        </p>
      )}
    </div>
  );
}

const showInfo = 6000; // ms

export function NoticeBar({ page }: { page: PageState }) {
  const notice = page.notice.value;
  useEffect(() => {
    if (notice?.tone !== "info" || notice.actions.length > 0) return;
    const timer = setTimeout(() => (page.notice.value = null), showInfo);
    return () => clearTimeout(timer);
  }, [notice]);
  return (
    <div class="notice-place" role={notice?.tone === "bad" ? "alert" : "status"}>
      {notice && (
        <p class={`notice ${notice.tone}`}>
          <Icon name={notice.tone === "bad" ? "warning" : "check"} />
          <span>
            {notice.text}
            {notice.actions.map(({ label, act }) => (
              <button key={label} type="button" class="button" onClick={() => finish(page, act)}>
                {label}
              </button>
            ))}
          </span>
          <IconButton icon="close" label="Dismiss" onClick={() => (page.notice.value = null)} />
        </p>
      )}
    </div>
  );
}

function finish(page: PageState, act: () => void): void {
  page.notice.value = null;
  act();
}

const seen = "waybreaker-invited";

// Goes for good when it is closed, or followed: something was changed, or played.
export function Invitation({ studio }: { studio: Studio }) {
  const [open, setOpen] = useState(() => localStorage.getItem(seen) === null);
  const followed = studio.editor.canUndo.value || studio.page.clock.playing.value;
  const close = () => {
    localStorage.setItem(seen, "yes");
    setOpen(false);
  };
  useEffect(() => {
    if (followed) close();
  }, [followed]);
  if (!open || !studio.page.shown.value) return null;
  return (
    <p class="invitation">
      <span>Drag the start or the goal on the map, and the plan follows. Or press play.</span>
      <IconButton icon="close" label="Dismiss the hint" onClick={close} />
    </p>
  );
}

export function Attribution({ page }: { page: PageState }) {
  const text = page.shown.value?.base.description.attribution;
  return text ? <p class="attribution">{text.replace(/^\(c\)/i, "©")}</p> : null;
}
