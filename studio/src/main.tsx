// Opens the page: a studio that asks the server, or the viewer of the plan that the document holds.
import { effect } from "@preact/signals";
import { render } from "preact";
import { Client } from "./api/client";
import { TabToken } from "./api/token";
import { Studio } from "./mission/studio";
import { viewerOf, type PlanDocument } from "./mission/viewer";
import { App } from "./panel/app";
import "./style.css";

const root = document.getElementById("app")!;
const held = document.getElementById("waybreaker")?.textContent;

if (held) {
  render(<App page={viewerOf(JSON.parse(held) as PlanDocument)} />, root);
} else {
  const token = new TabToken();
  const studio = new Studio(new Client(token));
  render(<App page={studio} token={token} />, root);
  void studio.start(location.search).then(() => keepAddress(studio));
}

// The address holds the mission. Browsers take only so many changes in a while.
function keepAddress(studio: Studio): void {
  let timer = 0;
  effect(() => {
    if (studio.clock.playing.value) return;
    const link = studio.link();
    if (!link) return;
    clearTimeout(timer);
    timer = window.setTimeout(() => history.replaceState(null, "", location.pathname + link), 250);
  });
}
