// The reference of the npm package as Markdown, by TypeDoc: one page for each module that programs import.
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { Application, Converter, ReflectionKind } from "typedoc";
import { root } from "./.vitepress/pages.mjs";

const modules = [
  { file: "index", page: "javascript", title: "JavaScript reference: `waybreaker`" },
  { file: "worker", page: "javascript-worker", title: "JavaScript reference: `waybreaker/worker`" },
];

// Those of Error, which every class of errors has.
function removeErrorConstructors({ project }) {
  for (const made of project.getReflectionsByKind(ReflectionKind.Constructor)) {
    if (made.parent.extendedTypes?.some(({ name }) => name === "Error")) project.removeReflection(made);
  }
}

function pageOf({ title }, markdown) {
  const body = markdown
    .replace(/^# .*\n/, "")
    .replace(/^#{4,} Get Signature\n/gm, "")
    .replace(/^#{4,} (?!Methods|Properties|Accessors|Constructors)([^()\n]*)$/gm, "**$1**") // "Parameters", "Returns"
    .replace(/\]\((\w+)\.md/g, (_, file) => `](/reference/${modules.find((module) => module.file === file).page}`);
  return `# ${title}\n\nMade from the types of the package. [JavaScript](/javascript) has examples.\n${body}`;
}

export async function javascriptReference() {
  const folder = mkdtempSync(join(tmpdir(), "typedoc-"));
  try {
    const app = await Application.bootstrapWithPlugins({
      plugin: ["typedoc-plugin-markdown"],
      entryPoints: modules.map(({ file }) => join(root, `npm/src/${file}.ts`)),
      tsconfig: join(root, "npm/tsconfig.json"),
      compilerOptions: { typeRoots: [join(root, "website/node_modules/@types")] }, // without those of npm/
      outputs: [{ name: "markdown", path: folder }],
      logLevel: "Warn",
      treatWarningsAsErrors: true,
      excludeExternals: true,
      excludeInternal: true,
      excludePrivate: true,
      disableSources: true,
      readme: "none",
      sort: ["source-order"],
      groupOrder: ["Functions", "Classes", "Interfaces", "Type Aliases"],
      outputFileStrategy: "modules",
      hideBreadcrumbs: true,
      hidePageHeader: true,
      parametersFormat: "table",
      classPropertiesFormat: "table",
      interfacePropertiesFormat: "table",
      typeAliasPropertiesFormat: "table",
    });
    app.converter.on(Converter.EVENT_RESOLVE_BEGIN, removeErrorConstructors);
    const project = await app.convert();
    if (!project) throw new Error("TypeDoc cannot read npm/src");
    await app.generateOutputs(project);
    if (app.logger.hasErrors() || app.logger.hasWarnings()) throw new Error("TypeDoc finds fault with npm/src");
    return modules.map((module) => [module.page, pageOf(module, readFileSync(join(folder, `${module.file}.md`), "utf8"))]);
  } finally {
    rmSync(folder, { recursive: true });
  }
}
