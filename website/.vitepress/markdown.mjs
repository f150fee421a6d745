// What the site does to Markdown beside VitePress: links into the repository become links within the site.
import { existsSync, readFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { base, inRepository, isBeside, root, siteLink } from "./pages.mjs";

// VitePress writes a remark into the page where a snippet is missing.
function requireSnippets(text, file) {
  for (const [, path] of text.matchAll(/^<<< @\/([^\s{#]+)/gm)) {
    if (!existsSync(join(root, path))) throw new Error(`${file}: ${path} is not there to be shown`);
  }
}

// `path` is where a page comes to lie, `realPath` where it is, if that differs.
function fileOf({ realPath, path }) {
  const file = realPath ?? path;
  return file && inRepository(file);
}

// `<!-- playground: map=... -->` in Markdown, which code hosts do not show, is a link to that mission.
function linksIntoPlayground({ tokens }) {
  for (const token of tokens) {
    if (token.type !== "html_block") continue;
    token.content = token.content.replace(/<!-- playground: (\S+) -->/g, (_, mission) => {
      const href = `${base}playground/#${mission.replaceAll("&", "&amp;")}`;
      return `<p><a href="${href}" target="_self">Open this mission in the playground</a></p>`;
    });
  }
}

// Of a picture in the repository, in pixels.
function sizeOf(path) {
  const bytes = readFileSync(path);
  if (path.endsWith(".png")) return [bytes.readUInt32BE(16), bytes.readUInt32BE(20)];
  const size = /^<svg [^>]*?width="(\d+)" height="(\d+)"/.exec(bytes.toString("utf8"));
  return size && size.slice(1);
}

// Pictures have their room before they are there. Without it all lie in the first window, and none waits until it is seen.
function giveRoom(token, file) {
  const path = join(root, dirname(file), token.attrGet("src"));
  const size = /\.(svg|png)$/.test(path) && existsSync(path) && sizeOf(path);
  if (!size) return;
  token.attrSet("width", String(size[0]));
  token.attrSet("height", String(size[1]));
}

// The tabs of a group of code have random ids: here they count, so that two builds are equal.
function countTabs(md) {
  const rule = "container_code-group_open";
  const random = md.renderer.rules[rule];
  md.renderer.rules[rule] = (tokens, index, ...rest) => {
    const known = new Map();
    const counted = (_, kind, id) => {
      if (!known.has(id)) known.set(id, known.size);
      return `"${kind}-${index}-${known.get(id)}"`;
    };
    return random(tokens, index, ...rest).replace(/"(group|tab)-([\w-]+)"/g, counted);
  };
}

export function repository(md) {
  countTabs(md);
  md.core.ruler.before("normalize", "snippets_that_exist", (state) => requireSnippets(state.src, fileOf(state.env)));
  // What scrolls must be reached by the keyboard.
  md.renderer.rules.code_block = (tokens, index) =>
    `<pre v-pre tabindex="0"><code>${md.utils.escapeHtml(tokens[index].content)}</code></pre>\n`;
  md.core.ruler.push("links_into_playground", linksIntoPlayground);
  md.core.ruler.push("links_and_pictures_of_the_site", (state) => {
    const file = fileOf(state.env);
    if (!file) return;
    for (const token of state.tokens.flatMap((token) => token.children ?? [])) {
      if (token.type === "image") giveRoom(token, file);
      if (token.type !== "link_open") continue;
      const href = siteLink(token.attrGet("href"), file);
      token.attrSet("href", isBeside(href) ? base + href.slice(1) : href);
      if (isBeside(href)) token.attrSet("target", "_self");
    }
  });
}
