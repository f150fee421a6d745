// Waits for a server that does not answer, and then goes on.
import { signal } from "@preact/signals";

const shortest = 1500; // ms between questions whether it is there
const longest = 60_000;

export class ServerWatch {
  readonly gone = signal(false);
  #again: () => unknown = () => undefined;
  #pause = shortest;

  // `isThere` asks the server something small.
  constructor(private readonly isThere: () => Promise<boolean>) {}

  // Does `again` once the server answers. A server that is there and breaks off what it is asked is asked less and less often.
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

  // It has answered what it was asked.
  isWell(): void {
    this.#pause = shortest;
  }
}

function pause(milliseconds: number): Promise<void> {
  return new Promise((done) => setTimeout(done, milliseconds));
}
