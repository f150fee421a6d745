// Waits for a server that does not respond, then retries.
import { signal } from "@preact/signals";

const shortest = 1500; // ms between checks
const longest = 60_000;

export class ServerWatch {
  readonly gone = signal(false);
  #again: () => unknown = () => undefined;
  #pause = shortest;

  // `isThere` sends the server a small request.
  constructor(private readonly isThere: () => Promise<boolean>) {}

  // Calls `again` once the server responds. If the server runs but drops the request, retries become less and less
  // frequent.
  async await(again: () => unknown): Promise<void> {
    this.#again = again;
    if (this.gone.value) return;
    this.gone.value = true;
    await pause(this.#pause);
    this.#pause = Math.min(2 * this.#pause, longest);
    while (!(await this.isThere())) await pause(shortest);
    this.gone.value = false;
    this.#again();
  }

  // The server has responded to the retried request.
  isWell(): void {
    this.#pause = shortest;
  }
}

function pause(milliseconds: number): Promise<void> {
  return new Promise((done) => setTimeout(done, milliseconds));
}
