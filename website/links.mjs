// usage: node links.mjs FOLDER [BASE]: every link, anchor and picture of the built site leads somewhere.
import { existsSync, readdirSync, readFileSync, statSync } from "node:fs";
import { dirname, join, normalize, relative } from "node:path";

const [folder, base = "/"] = process.argv.slice(2);
const files = readdirSync(folder, { recursive: true }).filter((file) => file.endsWith(".html") && !/^(cpp|playground)\//.test(file));
const texts = new Map();
const read = (file) => {
  if (!texts.has(file)) texts.set(file, readFileSync(join(folder, file), "utf8"));
  return texts.get(file);
};
const anchors = new Map();
const anchorsOf = (file) => {
  if (!anchors.has(file)) anchors.set(file, new Set([...read(file).matchAll(/ (?:id|name)="([^"]*)"/g)].map(([, id]) => id)));
  return anchors.get(file);
};
const plain = (text) => text.replaceAll("&amp;", "&").replaceAll("&#39;", "'").replaceAll("&quot;", '"');

let links = 0;
const faults = new Set();
for (const file of files) {
  for (const [, found] of read(file).matchAll(/ (?:href|src)="([^"]*)"/g)) {
    const link = plain(found);
    if (/^(https?:|mailto:|data:)/.test(link)) continue;
    links += 1;
    const [path, hash] = decodeURI(link).split("#");
    let target = path === "" ? file : path.startsWith("/") ? relative(base, path) : normalize(join(dirname(file), path));
    if (existsSync(join(folder, target)) && statSync(join(folder, target)).isDirectory()) target = join(target, "index.html");
    if (!existsSync(join(folder, target)) && existsSync(join(folder, `${target}.html`))) target += ".html";
    if (!existsSync(join(folder, target))) faults.add(`${file}: ${link} leads nowhere`);
    else if (hash && target.endsWith(".html") && !target.startsWith("playground") && !anchorsOf(target).has(hash)) faults.add(`${file}: ${link}: there is no such heading`);
  }
}
for (const fault of faults) console.error(fault);
console.log(`${links} links of ${files.length} pages, ${faults.size} of them broken`);
process.exitCode = faults.size > 0 || links === 0 ? 1 : 0;
