// The server's token: from the address's #token=..., which never leaves the browser, then kept for this tab.
import { signal } from "@preact/signals";
import type { TokenSource } from "./http_client";

const key = "waybreaker-token";

export class TabToken implements TokenSource {
  // Set while the page asks for a token: who waits for it.
  readonly wanted = signal<{ again: boolean } | null>(null);
  private waiting: ((token: string) => void)[] = [];

  constructor() {
    const fragment = location.hash.slice(1);
    const given = new URLSearchParams(fragment).get("token");
    if (given === null) return;
    sessionStorage.setItem(key, given);
    const rest = fragment.replace(/(^|&)token=[^&]*/, "").replace(/^&/, "");
    history.replaceState(null, "", location.pathname + location.search + (rest && `#${rest}`));
  }

  current(): string {
    return sessionStorage.getItem(key) ?? "";
  }

  ask(): Promise<string> {
    this.wanted.value ??= { again: this.current() !== "" };
    return new Promise((done) => this.waiting.push(done));
  }

  give(token: string): void {
    sessionStorage.setItem(key, token.trim());
    this.wanted.value = null;
    for (const done of this.waiting.splice(0)) done(token);
  }
}
