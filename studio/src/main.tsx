// Opens the page: a studio that asks the server, or plans by itself, or the viewer of the plan that the document holds.
import { effect } from "@preact/signals";
import { render } from "preact";
import { carriedBy, carriedClient } from "./api/carried";
import { HttpClient } from "./api/http_client";
import { LocalClient } from "./api/local_client";
import { keepForOffline } from "./api/offline";
import { TabToken } from "./api/token";
import { fragmentOf, missionAt, type Place, TooLarge } from "./mission/address";
import { openCarried, openMission } from "./mission/opening";
import { Studio } from "./mission/studio";
import { viewerOf, type PlanDocument } from "./mission/viewer";
import { App } from "./panel/app";
import "./style.css";

const root = document.getElementById("app")!;
const held = document.getElementById("waybreaker")?.textContent;
const carried = carriedBy(document);

if (held) {
  render(<App page={viewerOf(JSON.parse(held) as PlanDocument)} />, root);
} else {
  const isSite = document.querySelector('meta[name="waybreaker-site"]') !== null; // `waybreaker site` wrote it
  const token = isSite || carried ? null : new TabToken();
  const studio = new Studio(carried ? carriedClient(carried) : token ? new HttpClient(token) : localClient());
  void missionIn(location, studio)
    .then((query) => (carried && !query ? openCarried(studio, carried.plan) : studio.maps.start(query)))
    .then(() => keepAddress(studio));
  setTimeout(() => render(<App page={studio.page} studio={studio} token={token} />, root)); // after what is fetched was asked for
  // A link put into the address of this very page changes its fragment alone.
  addEventListener("hashchange", async ({ newURL }) => {
    const query = await missionIn(new URL(newURL), studio);
    if (query) await openMission(studio, query);
  });
}

// The page plans by itself.
function localClient(): LocalClient {
  keepForOffline();
  const start = () => new Worker(new URL("./worker/worker.ts", import.meta.url), { type: "module" });
  return new LocalClient(start, plannerModule());
}

// Browsers compile while it comes, if it comes under its own type; not every host knows that.
async function plannerModule(): Promise<WebAssembly.Module> {
  const answer = await fetch("studio.wasm", { priority: "low" }); // the map is seen first
  const isTyped = answer.headers.get("Content-Type")?.startsWith("application/wasm");
  return isTyped ? WebAssembly.compileStreaming(answer) : WebAssembly.compile(await answer.arrayBuffer());
}

async function missionIn(address: Place, studio: Studio): Promise<string> {
  try {
    return await missionAt(address);
  } catch (error) {
    const what = error instanceof TooLarge ? "is too large" : "is not complete: the mission in it cannot be read";
    studio.page.notify("bad", `The link ${what}.`);
    return "";
  }
}

// The address holds the mission. Browsers take only so many changes in a while.
function keepAddress(studio: Studio): void {
  let timer = 0;
  effect(() => {
    if (studio.page.clock.playing.value) return;
    const query = studio.query();
    if (!query) return;
    clearTimeout(timer);
    timer = window.setTimeout(async () => {
      const fragment = await fragmentOf(query);
      if (studio.query() === query) history.replaceState(null, "", location.pathname + fragment);
    }, 250);
  });
}
