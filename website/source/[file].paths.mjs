// A page for each file of the repository that a page links to, and for each folder, with the files in it.
import { readdirSync, readFileSync, statSync } from "node:fs";
import { basename, extname, join } from "node:path";
import { linkedSources, markdownFiles, root, siteLink } from "../.vitepress/pages.mjs";

const languages = { ".cff": "yaml", ".h": "c" };
const fenced = (text, language) => `\`\`\`\`${language}\n${text.replace(/\n?$/, "\n")}\`\`\`\`\n`;

function notebook(text, file) {
  const prose = (text) => text.replace(/\]\(([^()\s]+)\)/g, (_, href) => `](${siteLink(href, file)})`);
  return JSON.parse(text)
    .cells.map(({ cell_type, source }) => (cell_type === "code" ? fenced(source.join(""), "python") : prose(source.join(""))))
    .join("\n\n");
}

function page(file) {
  const text = readFileSync(join(root, file), "utf8");
  if (extname(file) === ".ipynb") return notebook(text, file);
  return `# ${file}\n\n${fenced(text, languages[extname(file)] ?? extname(file).slice(1))}`;
}

function listing(folder, files) {
  return `# ${folder}\n\n${files.map((file) => `- [${basename(file)}](/source/${file}.html)`).join("\n")}\n`;
}

export default {
  paths() {
    const contents = new Map();
    for (const source of linkedSources(markdownFiles())) {
      const isFolder = statSync(join(root, source)).isDirectory();
      const files = isFolder ? readdirSync(join(root, source)).map((name) => `${source}/${name}`) : [source];
      if (isFolder) contents.set(source, listing(source, files));
      for (const file of files) contents.set(file, page(file));
    }
    return [...contents].map(([file, content]) => ({ params: { file }, content }));
  },
};
