// usage: node lighthouse.mjs FOLDER PAGE...: what Lighthouse says of pages of the built site, the median of five runs each.
import { launch } from "chrome-launcher";
import lighthouse from "lighthouse";
import { serve } from "./serve.mjs";

const [folder, ...pages] = process.argv.slice(2);
const runs = 5;
const onlyCategories = ["performance", "accessibility", "best-practices", "seo"];
const median = (values) => values.sort((a, b) => a - b)[Math.floor(values.length / 2)];

const server = await serve(folder);
for (const page of pages) {
  const results = [];
  for (let run = 0; run < runs; ++run) {
    const chrome = await launch({ chromeFlags: ["--headless=new", "--no-sandbox"] });
    const { lhr } = await lighthouse(`${server.url}/${page}`, { port: chrome.port, logLevel: "error", onlyCategories });
    chrome.kill();
    if (lhr.runtimeError) throw new Error(`${page}: ${lhr.runtimeError.message}`);
    results.push(lhr);
  }
  const scores = onlyCategories.map((name) => {
    const [lowest, highest] = [Math.min, Math.max].map((pick) => pick(...results.map((lhr) => lhr.categories[name].score)));
    const score = median(results.map((lhr) => lhr.categories[name].score));
    return `${name} ${Math.round(score * 100)}${lowest < highest ? ` (${Math.round(lowest * 100)} to ${Math.round(highest * 100)})` : ""}`;
  });
  console.log(`/${page}: ${scores.join(", ")}`);
  const [last] = results.slice(-1);
  for (const { auditRefs } of Object.values(last.categories)) {
    for (const { id, weight } of auditRefs) {
      const { score, title, displayValue } = last.audits[id];
      if (weight > 0 && score !== null && score < 0.9) console.log(`  ${title}${displayValue ? `: ${displayValue}` : ""}`);
    }
  }
}
server.close();
