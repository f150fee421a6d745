// The studio in a real browser, as a person meets it: by what is read and pressed, and by places on the map.
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { type Browser, chromium as launcher, type Locator, type Page } from "playwright-core";
import type { Cell, Point } from "../src/domain/geometry";
import { objectiveOf, type Plan, valueOf } from "../src/domain/plan";
import { toScreen, wholeMap } from "../src/map/viewport/camera";
import { chromium } from "./command";

export const wide = { width: 1400, height: 900 };
export const phone = { width: 390, height: 844 };

export function launch(): Promise<Browser> {
  return launcher.launch({ executablePath: chromium, args: ["--no-sandbox", "--disable-dev-shm-usage"] });
}

const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

interface AxeResult {
  violations: { id: string; nodes: { html: string; failureSummary: string }[] }[];
}

// In the page: what axe-core says of the contrast of an element's texts.
async function unreadable(element: Element): Promise<string[]> {
  interface Axe {
    run(context: Element, options: object): Promise<AxeResult>;
  }
  const { violations } = await (window as unknown as { axe: Axe }).axe.run(element, { runOnly: ["color-contrast"] });
  return violations.flatMap(({ nodes }) => nodes.map(({ html, failureSummary }) => `${html} ${failureSummary}`));
}

// In the page: every plan that comes in is read a second time.
function tellAnswers(): void {
  const ask = window.fetch;
  window.fetch = async (...question) => {
    const answer = await ask(...question);
    if (answer.ok && answer.url.endsWith("/plan")) {
      const { keepAnswer } = window as unknown as { keepAnswer(body: string): void };
      void answer.clone().text().then(keepAnswer, () => undefined);
    }
    return answer;
  };
}

interface Visit {
  query?: string;
  viewport?: { width: number; height: number };
  colorScheme?: "light" | "dark";
}

export class StudioPage {
  readonly #answers: Plan[] = []; // all plans that the server gave
  readonly faults: string[] = []; // what the browser complained of

  private constructor(
    readonly page: Page,
    own: string,
  ) {
    page.on("pageerror", (error) => this.faults.push(String(error)));
    page.on("console", (message) => {
      if (message.type() === "error") this.faults.push(message.text());
    });
    page.on("request", (request) => {
      const foreign = !request.url().startsWith(own) && !/^(data|blob):/.test(request.url());
      if (foreign) this.faults.push(`a request to ${request.url()}`);
    });
  }

  static async visit(browser: Browser, url: string, { query = "", viewport = wide, colorScheme = "light" }: Visit = {}) {
    const context = await browser.newContext({ viewport, colorScheme, acceptDownloads: true });
    context.setDefaultTimeout(120_000);
    const page = await context.newPage();
    const studio = new StudioPage(page, url.startsWith("http") ? new URL(url).origin : url);
    await page.exposeFunction("keepAnswer", (body: string) => studio.keep(body));
    await page.addInitScript(tellAnswers);
    await page.goto(url + query);
    return studio;
  }

  // A plan, or the stream that ends with it, or with what is wrong.
  private keep(body: string): void {
    const event = /event: plan\ndata: (.*)\n/s.exec(body);
    if (!event && body.startsWith("event:")) return;
    this.#answers.push(JSON.parse(event ? event[1]!.replaceAll("\ndata: ", "\n") : body) as Plan);
  }

  result(): Locator {
    return this.page.getByRole("region", { name: "Result" });
  }

  // Once the search for the plan of the mission as it is has ended, and its independent check is in.
  async settled(): Promise<void> {
    await this.page.locator('[aria-label="Result"][aria-busy="false"]').getByText("Checked independently").waitFor();
  }

  // What the headline says: the objective with the removals, and without.
  async figures(): Promise<number[]> {
    const texts = await this.result().locator("data").evaluateAll((all) => all.map((one) => one.getAttribute("value")));
    return texts.map(Number);
  }

  // The answer of the server that the headline is about.
  async plan(): Promise<Plan> {
    const until = Date.now() + 30_000; // the page may have read the answer before it gets here
    for (;;) {
      const [reached, before] = await this.figures();
      const of = (outcome: Plan["after"], answer: Plan) => valueOf(outcome, objectiveOf(answer));
      const plan = this.#answers.findLast(
        (answer) => of(answer.after, answer) === reached && (before === undefined || of(answer.before, answer) === before),
      );
      if (plan) return plan;
      if (Date.now() > until) throw new Error(`the page says ${reached}, which no plan of the server reaches`);
      await this.page.waitForTimeout(20);
    }
  }

  map(): Locator {
    return this.page.getByRole("application");
  }

  marker(name: string): Locator {
    return this.page.getByRole("button", { name: new RegExp(`^${name}, column`) });
  }

  async cellOf(name: string): Promise<Cell> {
    const label = (await this.marker(name).getAttribute("aria-label")) ?? "";
    const [, x, y] = /column (\d+), row (\d+)/.exec(label) ?? [];
    return [Number(x), Number(y)];
  }

  // Where on the screen a point of the map is, while all of it is shown.
  async place(point: Point, map: { width: number; height: number }): Promise<{ x: number; y: number }> {
    const box = (await this.map().boundingBox())!;
    const [x, y] = toScreen(wholeMap(map, box), box, point);
    return { x: box.x + x, y: box.y + y };
  }

  // What axe-core finds against WCAG 2.1 AA and good practice, one line each.
  async accessibilityFaults(): Promise<string[]> {
    await this.page.evaluate(axe);
    return this.page.evaluate(async () => {
      const { violations } = await (window as unknown as { axe: { run(): Promise<AxeResult> } }).axe.run();
      return violations.flatMap(({ id, nodes }) => nodes.map(({ html, failureSummary }) => `${id}: ${html} ${failureSummary}`));
    });
  }

  // Texts that cannot be read while the pointer is over what they stand on: as if it were over everything at once, for axe
  // takes its time.
  async faultsWhenHovered(within: string): Promise<string[]> {
    await this.page.locator(within).waitFor();
    const tools = await this.page.context().newCDPSession(this.page);
    await tools.send("DOM.enable");
    await tools.send("CSS.enable");
    const { root } = await tools.send("DOM.getDocument");
    const holder = await tools.send("DOM.querySelector", { nodeId: root.nodeId, selector: within });
    const selector = "button, a, summary, label, select, input, tr";
    const { nodeIds } = await tools.send("DOM.querySelectorAll", { nodeId: holder.nodeId, selector });
    for (const nodeId of nodeIds) await tools.send("CSS.forcePseudoState", { nodeId, forcedPseudoClasses: ["hover"] });
    await this.page.evaluate(axe);
    const faults = await this.page.locator(within).evaluate(unreadable);
    await tools.detach();
    return faults;
  }

  // What has the keyboard's focus, and nothing shows it.
  async unseenFocus(within: string): Promise<string[]> {
    const unseen: string[] = [];
    for (const one of await this.page.locator(within).locator("button, a, summary, select, input").all()) {
      if (!(await one.isVisible())) continue;
      await one.focus();
      const shown = await one.evaluate((element) => {
        const rings = [element, element.nextElementSibling].map((part) => part && getComputedStyle(part).outlineStyle);
        return element !== document.activeElement || !element.matches(":focus-visible") || rings.some((ring) => ring && ring !== "none");
      });
      if (!shown) unseen.push(await one.evaluate((element) => element.outerHTML.slice(0, 120)));
    }
    return unseen;
  }

  // What reaches beyond the window or the panel that holds it.
  cutOff(selector: string): Promise<string[]> {
    return this.page.evaluate((which) => {
      const isSeen = (one: Element) => one.checkVisibility() && !one.closest(".spoken, .map-markers") && one.clientWidth > 1;
      return [...document.querySelectorAll(which)].filter(isSeen).flatMap((one) => {
        const box = one.getBoundingClientRect();
        const holder = one.closest(".panel")?.getBoundingClientRect();
        const [left, right] = [holder?.left ?? 0, holder?.right ?? innerWidth];
        const fits = box.left >= left - 1 && box.right <= right + 1;
        return fits ? [] : [`${one.outerHTML.slice(0, 120)}: ${box.left} to ${box.right} of ${left} to ${right}`];
      });
    }, selector);
  }

  // Of a pixel of the map, at a share of its width and height.
  colourAt(x: number, y: number): Promise<number[]> {
    return this.map().evaluate((canvas, [across, down]) => {
      const { width, height } = canvas as HTMLCanvasElement;
      const context = (canvas as HTMLCanvasElement).getContext("2d")!;
      return [...context.getImageData(across! * width, down! * height, 1, 1).data].slice(0, 3);
    }, [x, y]);
  }

  close(): Promise<void> {
    return this.page.context().close();
  }
}
