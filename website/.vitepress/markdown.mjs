// What the site does to Markdown beside VitePress: links into the repository become links within the site.
import { existsSync } from "node:fs";
import { join } from "node:path";
import { base, inRepository, isBeside, root, siteLink } from "./pages.mjs";

// Examples in languages whose packages are not part of this checkout.
const optional = new Set(["examples/embed.py", "examples/embed.mjs", "examples/embed.c"]);

function hasSnippet(line, file) {
  const path = /^<<< @\/([^\s{#]+)/.exec(line)?.[1];
  if (!path || existsSync(join(root, path))) return true;
  if (optional.has(path)) return false;
  throw new Error(`${file}: ${path} is not there to be shown`);
}

// `path` is where a page comes to lie, `realPath` where it is, if that differs.
function fileOf({ realPath, path }) {
  const file = realPath ?? path;
  return file && inRepository(file);
}

export function repository(md) {
  md.core.ruler.before("normalize", "snippets_that_exist", (state) => {
    const file = fileOf(state.env) ?? "";
    state.src = state.src
      .split("\n")
      .filter((line) => hasSnippet(line, file))
      .join("\n");
  });
  md.core.ruler.push("links_of_the_site", (state) => {
    const file = fileOf(state.env);
    if (!file) return;
    for (const token of state.tokens.flatMap((token) => token.children ?? [])) {
      if (token.type !== "link_open") continue;
      const href = siteLink(token.attrGet("href"), file);
      token.attrSet("href", isBeside(href) ? base + href.slice(1) : href);
      if (isBeside(href)) token.attrSet("target", "_self");
    }
  });
}
