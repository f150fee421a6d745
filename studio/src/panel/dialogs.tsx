// Dialogs: keys and hints, and the server's token.
import { useEffect, useRef } from "preact/hooks";
import type { TabToken } from "../api/token";

const keys: [string, string][] = [
  ["Ctrl Z", "undo"],
  ["Ctrl Shift Z, Ctrl Y", "redo"],
  ["Space", "play and pause"],
  ["M, W, E, Z", "move, draw wall, erase, zone"],
  ["Enter, Backspace", "on the map, while a zone is drawn: set a corner in the middle, or close; take the last one back"],
  ["Enter, Esc", "on the map, while bases are set: set one in the middle; end it"],
  ["R", "in a rehearsal: drop rubble"],
  ["Arrow keys", "on the map: pan; on a marker: move it"],
  ["+ and −", "on the map: zoom"],
  ["Menu key, Shift F10", "on the map, in a rehearsal: what can go wrong in the middle of it"],
  ["Esc", "close the card"],
  ["/", "find a street or obstacle"],
  ["?", "this help"],
];

export function HelpDialog({ open, onClose }: { open: boolean; onClose: () => void }) {
  const dialog = useModal(open);
  return (
    <dialog ref={dialog} class="dialog" aria-labelledby="help-title" onClose={onClose}>
      <h2 id="help-title">How it works</h2>
      <p>
        A ground robot drives from the start to the goal. An aircraft opens the way: it removes the few obstacles that
        cost the most time. Drag the markers and the plan follows; the slider says how many removals there may be. Add
        vehicles and aircraft, and all are planned together.
      </p>
      <p>
        Click an obstacle to <strong>protect</strong> it (never removed), <strong>force</strong> it (always removed), or{" "}
        <strong>exclude</strong> it (planned as if it were not there). The address of this page holds the whole mission.
      </p>
      <table class="keys">
        <caption>Keys</caption>
        <tbody>
          {keys.map(([key, what]) => (
            <tr key={key}>
              <th scope="row">
                <kbd>{key}</kbd>
              </th>
              <td>{what}</td>
            </tr>
          ))}
        </tbody>
      </table>
      <form method="dialog">
        <button class="button primary">Close</button>
      </form>
    </dialog>
  );
}

export function TokenDialog({ token }: { token: TabToken }) {
  const wanted = token.wanted.value;
  const dialog = useModal(wanted !== null);
  const field = useRef<HTMLInputElement>(null);
  return (
    <dialog ref={dialog} class="dialog" aria-labelledby="token-title" onCancel={(event) => event.preventDefault()}>
      <form
        onSubmit={(event) => {
          event.preventDefault();
          const given = field.current?.value.trim();
          if (given) token.give(given);
        }}
      >
        <h2 id="token-title">This server asks for a token</h2>
        <p>
          {wanted?.again ? "The token was not taken. Try again." : "Whoever started the server can tell it to you."}
        </p>
        <label class="token-field">
          Token
          <input ref={field} type="password" autocomplete="off" required />
        </label>
        <button class="button primary">Continue</button>
      </form>
    </dialog>
  );
}

export function useModal(open: boolean) {
  const dialog = useRef<HTMLDialogElement>(null);
  useEffect(() => {
    if (open && !dialog.current?.open) dialog.current?.showModal();
    if (!open && dialog.current?.open) dialog.current.close();
  }, [open]);
  return dialog;
}
