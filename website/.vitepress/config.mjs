// The site is made of the Markdown of the repository: docs/, what pages.mjs lists, and the home page beside this.
import { readdirSync, readFileSync } from "node:fs";
import { slug } from "github-slugger";
import { defineConfig } from "vitepress";
import { repository } from "./markdown.mjs";
import { base, excluded, isBeside, placeOf, root } from "./pages.mjs";

const guides = [
  { text: "A robot that must get through", link: "/guides/robot" },
  { text: "A game with walls that fall", link: "/guides/game" },
  { text: "A city after a disaster", link: "/guides/disaster" },
  { text: "Research", link: "/guides/research" },
];

const decisions = readdirSync(`${root}docs/adr`).map((file) => ({
  text: /^# (?:\d+\. *)?(.*)/.exec(readFileSync(`${root}docs/adr/${file}`, "utf8"))[1],
  link: `/adr/${file.replace(/\.md$/, "")}`,
}));

const sidebar = [
  {
    text: "Use it",
    items: [
      { text: "Get started", link: "/start" },
      { text: "Playground", link: `${base}playground/`, target: "_self" },
      { text: "The page", link: "/studio" },
      { text: "Commands", link: "/commands" },
      { text: "Debian packages", link: "/debian" },
      { text: "Several vehicles", link: "/coalition" },
      { text: "Live missions", link: "/live" },
      { text: "Maps and data", link: "/data" },
      { text: "Gallery", link: "/gallery" },
    ],
  },
  { text: "Guides", items: guides },
  {
    text: "Build with it",
    items: [
      { text: "Ten lines in each language", link: "/build" },
      { text: "C++", link: "/embedding" },
      { text: "C++ reference", link: `${base}cpp/index.html`, target: "_self" },
      { text: "Python", link: "/python" },
      { text: "Python reference", link: "/reference/python" },
      { text: "JavaScript", link: "/javascript" },
      { text: "JavaScript reference", link: "/reference/javascript" },
      { text: "JavaScript reference: worker", link: "/reference/javascript-worker" },
      { text: "C", link: "/c" },
      { text: "HTTP", link: "/server" },
      { text: "HTTP reference", link: "/reference/http" },
      { text: "ROS 2", link: "/ros" },
      { text: "Contract: motion, files", link: "/contract" },
    ],
  },
  {
    text: "Trust it",
    items: [
      { text: "What is proven, what is not", link: "/trust" },
      { text: "The proof", link: "/exact" },
      { text: "The paper's experiment", link: "/paper" },
      { text: "Performance", link: "/performance" },
      { text: "Compared with", link: "/compared" },
      { text: "Experiments", link: "/experiments" },
      { text: "On a cluster", link: "/cluster" },
    ],
  },
  {
    text: "Inside",
    items: [
      { text: "Architecture", link: "/architecture" },
      { text: "The aircraft's tour", link: "/flight" },
      { text: "The code of the page", link: "/studio-code" },
      { text: "What was tried", link: "/notes/tried" },
      ...decisions,
      { text: "City maps", link: "/maps" },
      { text: "Maps of the experiment", link: "/paper-maps" },
      { text: "Pictures", link: "/pictures" },
      { text: "Contributing", link: "/contributing" },
      { text: "Changelog", link: "/changelog" },
    ],
  },
];

// By default the colours of a line that takes more than half a second are given up: two builds would differ.
const colourWhole = { preprocess: (_, options) => void (options.tokenizeTimeLimit = 0) };

// Pages lie outside this folder, where no node_modules is found on the way up.
const vueOfThisFolder = {
  name: "vue-of-this-folder",
  enforce: "pre",
  resolveId(id, _, options) {
    if (id !== "vue" && !id.startsWith("vue/")) return null;
    return this.resolve(id, `${root}website/index.md`, { ...options, skipSelf: true });
  },
};

export default defineConfig({
  title: "waybreaker",
  description: "Plans missions in which a ground vehicle crosses a city and an aircraft opens the way",
  lang: "en",
  base,
  srcDir: root,
  srcExclude: excluded,
  rewrites: placeOf,
  outDir: process.env.SITE_OUT ?? `${root}build/site`,
  cacheDir: `${root}build/site-cache`,
  buildConcurrency: 1, // pages come into the search index in one order
  ignoreDeadLinks: [isBeside, /^http:\/\/localhost/], // check.mjs looks at those beside when all of the site is there
  appearance: true,
  markdown: {
    config: (md) => md.use(repository),
    anchor: { slugify: slug }, // the anchors of code hosts
    theme: { light: "github-light-high-contrast", dark: "github-dark-high-contrast" },
    codeTransformers: [colourWhole],
    image: { lazyLoading: true },
    languageAlias: { console: "shellscript", mapfile: "text", mjs: "javascript", pycon: "python" },
  },
  vite: {
    publicDir: `${root}website/public`,
    plugins: [vueOfThisFolder],
    server: { fs: { allow: [root] }, watch: { ignored: ["**/build/**", "**/data/**", "**/tests/**"] } },
  },
  head: [["link", { rel: "icon", type: "image/svg+xml", href: `${base}icon.svg` }]],
  themeConfig: {
    logo: "/icon.svg",
    outline: [2, 3],
    search: { provider: "local" },
    nav: [
      { text: "Get started", link: "/start" },
      { text: "Playground", link: `${base}playground/`, target: "_self" },
      { text: "Guides", items: guides },
      { text: "Build", link: "/build" },
      { text: "Trust", link: "/trust" },
      { text: "Gallery", link: "/gallery" },
    ],
    sidebar,
    footer: {
      message: "MIT licence. Maps © OpenStreetMap contributors, ODbL 1.0.",
    },
    notFound: { linkText: "Home", linkLabel: "Home" },
    docFooter: { prev: "Before", next: "Next" },
  },
});
