// The reference of the HTTP service as Markdown, from the description that the service itself gives.
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { root } from "./.vitepress/pages.mjs";

const methods = ["get", "post", "put", "patch", "delete"];

/** Text in a cell of a table. `<` and braces would be HTML and Vue. */
const cell = (text = "") =>
  text.replace(/\s+/g, " ").replace(/\|/g, "\\|").replace(/</g, "&lt;").replace(/{{/g, "&#123;&#123;");
const code = (text) => `<code v-pre>${text.replace(/&/g, "&amp;").replace(/</g, "&lt;").replace(/\|/g, "&#124;")}</code>`;

const row = (...cells) => `| ${cells.join(" | ")} |`;
const table = (head, rows) =>
  rows.length === 0 ? [] : [row(...head), row(...head.map(() => "---")), ...rows.map((cells) => row(...cells)), ""];

const nameOf = (ref) => ref.split("/").at(-1);
const linked = (name) => `[${name}](#${name.toLowerCase()})`;

function type(schema) {
  if (schema.$ref) return linked(nameOf(schema.$ref));
  if (schema.anyOf) return schema.anyOf.map(type).join(" or ");
  if (schema.enum) return schema.enum.map((value) => code(String(value))).join(", ");
  if (schema.type === "array") return schema.items ? `list of ${type(schema.items)}` : "list";
  return [schema.type ?? "anything"].flat().join(" or ");
}

function range({ minimum, exclusiveMinimum, maximum, minItems, maxItems, default: usual }) {
  const parts = [];
  if (minimum !== undefined) parts.push(`at least ${minimum}`);
  if (exclusiveMinimum !== undefined) parts.push(`above ${exclusiveMinimum}`);
  if (maximum !== undefined) parts.push(`at most ${maximum}`);
  if (minItems !== undefined && minItems === maxItems) parts.push(`${minItems} of them`);
  else {
    if (minItems !== undefined) parts.push(`at least ${minItems} of them`);
    if (maxItems !== undefined) parts.push(`at most ${maxItems} of them`);
  }
  if (usual !== undefined) parts.push(`default: ${usual}`);
  return parts.join(", ");
}

/** One row for each property, those of objects inside under their path. */
function properties(schema, path = "") {
  const rows = [];
  for (const [name, property] of Object.entries(schema.properties ?? {})) {
    const full = path + name;
    const needed = (schema.required ?? []).includes(name);
    const words = [property.description, range(property)].filter(Boolean).map(cell).join("; ");
    rows.push([code(full), type(property) + (needed ? "" : ", optional"), words]);
    rows.push(...properties(property, `${full}.`));
    if (property.items) rows.push(...properties(property.items, `${full}[].`));
  }
  return rows;
}

const bodyOf = (content) => {
  const entries = Object.entries(content ?? {});
  return entries.map(([media, { schema }]) => `${code(media)}${schema?.$ref ? ` ${type(schema)}` : ""}`).join("<br>");
};

export function httpReference() {
  const description = JSON.parse(readFileSync(join(root, "src/service/openapi.json"), "utf8"));
  const resolve = (item) =>
    item.$ref ? item.$ref.slice(2).split("/").reduce((node, key) => node[key], description) : item;

  const operations = Object.entries(description.paths).flatMap(([path, item]) =>
    methods.filter((method) => item[method]).map((method) => ({ path, method, shared: item.parameters ?? [], ...item[method] })),
  );
  // Those that are described alike share a row.
  const answers = (responses) => {
    const rows = new Map();
    for (const [status, response] of Object.entries(responses)) {
      const answer = resolve(response);
      const said = [cell(answer.description), bodyOf(answer.content)];
      const row = rows.get(said.join()) ?? [[], ...said];
      row[0].push(status);
      rows.set(said.join(), row);
    }
    return [...rows.values()].map(([statuses, ...said]) => [statuses.join(", "), ...said]);
  };
  const request = (operation) => {
    const parameters = [...operation.shared, ...(operation.parameters ?? [])].map(resolve);
    const body = operation.requestBody && resolve(operation.requestBody);
    return [
      `### ${operation.summary} {#${operation.operationId}}`,
      "",
      code(`${operation.method.toUpperCase()} ${operation.path}`),
      "",
      ...(operation.description ? [cell(operation.description), ""] : []),
      ...table(
        ["parameter", "in", "type", ""],
        parameters.map((p) => [
          code(p.name),
          p.in,
          type(p.schema) + (p.required ? "" : ", optional"),
          [p.description, range(p.schema)].filter(Boolean).map(cell).join("; "),
        ]),
      ),
      ...(body ? [`Body: ${bodyOf(body.content)}. ${cell(body.description)}`, ""] : []),
      ...table(["answer", "", "body"], answers(operation.responses)),
    ];
  };
  const schema = ([name, item]) => [
    `### ${name}`,
    "",
    ...(item.description ? [cell(item.description), ""] : []),
    ...(item.properties ? [] : [`${type(item)}${range(item) ? `, ${range(item)}` : ""}`, ""]),
    ...table(["", "type", ""], [...properties(item), ...(item.items?.properties ? properties(item.items, "[].") : [])]),
  ];
  return [
    "# HTTP reference",
    "",
    "Made from the service's own description (OpenAPI 3.1), which it gives at `/api/v1/openapi.json`. [The service](/server) has",
    "examples of the common requests.",
    "",
    cell(description.info.description),
    "",
    "## Requests",
    "",
    ...operations.flatMap(request),
    "## Schemas",
    "",
    ...Object.entries(description.components.schemas).flatMap(schema),
  ].join("\n");
}
