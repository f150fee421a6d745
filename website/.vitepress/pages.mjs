// Which files of the repository are pages of the site, and where a link from one of them leads.
import { existsSync, readdirSync, readFileSync, statSync } from "node:fs";
import { dirname, join, posix, relative } from "node:path";
import { fileURLToPath } from "node:url";

export const root = fileURLToPath(new URL("../..", import.meta.url));

/** The folder of the host that the site is put in: `/`, or `/waybreaker/`. */
export const base = process.env.SITE_BASE ?? "/";

// What has no page.
export const excluded = [
  "!(website|docs|data|studio|npm|python)/**/*",
  "data/!(paper-maps)/**/*",
  "{studio,npm,python}/!(README.md)",
  "{studio,npm,python}/*/**",
  "website/parts/**",
];

const elsewhere = {
  "README.md": "start.md",
  "CHANGELOG.md": "changelog.md",
  "CONTRIBUTING.md": "contributing.md",
  "data/README.md": "maps.md",
  "data/paper-maps/README.md": "paper-maps.md",
  "npm/README.md": "javascript.md",
  "python/README.md": "python.md",
  "studio/README.md": "studio-code.md",
  "docs/pictures/README.md": "pictures.md",
};

/** Where the page made of a file lies: `docs/exact.md` is `exact.md`. */
export function placeOf(file) {
  return elsewhere[file] ?? file.replace(/^(docs|website)\//, "");
}

// Folders that a page stands for.
const folders = {
  "include/waybreaker": "/cpp/index.html",
  examples: "/build",
  "docs/adr": "/adr/001-core-without-dependencies",
};

/** Whether a link leads to what lies beside the pages: Doxygen's files, pictures, the playground. */
export const isBeside = (link) => /^\/(cpp|picture|playground)\//.test(link);

const isExternal = (href) => /^([a-z]+:|\/\/|#|\/)/i.test(href);

/** Where a relative link of `file` leads on the site; `sources` collects the files that need a page of their own. */
export function siteLink(href, file, sources = new Set()) {
  if (isExternal(href)) return href;
  const [path, hash] = decodeURI(href).split(/(?=#)/);
  const target = posix.normalize(posix.join(dirname(file), path)).replace(/\/$/, "");
  if (target.startsWith("..") || !existsSync(join(root, target))) throw new Error(`${file}: ${href} leads nowhere`);
  if (folders[target]) return folders[target];
  if (target.endsWith(".md")) return `/${placeOf(target).replace(/(^|\/)index\.md$/, "$1").replace(/\.md$/, "")}${hash ?? ""}`;
  if (target.startsWith("docs/pictures/")) return target.replace("docs/pictures/", "/picture/");
  sources.add(target);
  return `/source/${target}.html`;
}

/** The files, not pages themselves, that the Markdown of `files` links to. */
export function linkedSources(files) {
  const sources = new Set();
  for (const file of files) {
    const text = readFileSync(join(root, file), "utf8").replace(/^(```+)[^]*?^\1/gm, "");
    for (const [, href] of text.matchAll(/\]\(([^()\s]+)\)/g)) siteLink(href, file, sources);
  }
  return [...sources].sort();
}

/** All Markdown that pages are made of, but for what is beside this. */
export function markdownFiles() {
  const inside = (folder) =>
    readdirSync(join(root, folder), { recursive: true })
      .filter((name) => name.endsWith(".md"))
      .map((name) => `${folder}/${name}`);
  return [...inside("docs"), ...Object.keys(elsewhere).filter((file) => !file.startsWith("docs/"))].sort();
}

export const inRepository = (path) => relative(root, path).split("\\").join("/");
