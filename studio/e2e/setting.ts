// What the tests of one file share: a server, a browser, and a folder for files. All end with the tests.
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import type { Browser } from "playwright-core";
import { afterAll, afterEach, beforeAll, expect } from "vitest";
import { Server } from "./server";
import { launch, StudioPage } from "./studio_page";

export class Setting {
  readonly scratch: string;
  server!: Server;
  browser!: Browser;
  readonly #settled: StudioPage[] = [];

  constructor(name: string) {
    this.scratch = mkdtempSync(join(tmpdir(), `${name}-`));
    beforeAll(async () => {
      [this.server, this.browser] = await Promise.all([Server.start(), launch()]);
    });
    afterEach(async () => {
      await Promise.all(this.#settled.splice(0).map((page) => page.close()));
    });
    afterAll(async () => {
      await this.browser.close();
      expect(await this.server.stop()).toBe(0);
      rmSync(this.scratch, { recursive: true });
    });
  }

  visit(options: Parameters<typeof StudioPage.visit>[2] = {}, url = `${this.server.url}/`): Promise<StudioPage> {
    return StudioPage.visit(this.browser, url, options);
  }

  // A page that has its plan. It is closed after the test.
  async settled(...visited: Parameters<Setting["visit"]>): Promise<StudioPage> {
    const page = await this.visit(...visited);
    this.#settled.push(page);
    await page.settled();
    return page;
  }
}
