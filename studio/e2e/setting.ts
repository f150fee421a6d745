// What the tests of one file share: a server, a browser, and a folder for files. All end with the tests.
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import type { Browser } from "playwright-core";
import { afterAll, beforeAll, expect } from "vitest";
import { Server } from "./server";
import { launch, StudioPage } from "./studio_page";

export class Setting {
  readonly scratch: string;
  server!: Server;
  browser!: Browser;

  constructor(name: string) {
    this.scratch = mkdtempSync(join(tmpdir(), `${name}-`));
    beforeAll(async () => {
      [this.server, this.browser] = await Promise.all([Server.start(), launch()]);
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
}
