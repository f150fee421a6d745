// A page for each file of the repository that a page links to.
import { readFileSync } from "node:fs";
import { extname, join } from "node:path";
import { linkedSources, markdownFiles, root } from "../.vitepress/pages.mjs";

export default {
  paths: () =>
    linkedSources(markdownFiles()).map((file) => {
      const text = readFileSync(join(root, file), "utf8");
      const language = { ".cff": "yaml" }[extname(file)] ?? extname(file).slice(1);
      return { params: { file }, content: `# ${file}\n\n\`\`\`\`${language}\n${text}\`\`\`\`\n` };
    }),
};
