// The references that come from the code itself: its description, types, docstrings.
import { execFileSync } from "node:child_process";
import { javascriptReference } from "../javascript.mjs";
import { httpReference } from "../openapi.mjs";
import { root } from "../.vitepress/pages.mjs";

// griffe is Debian's, and so must be its Python.
const pythonReference = () => execFileSync("/usr/bin/python3", ["-B", `${root}website/python_reference.py`], { encoding: "utf8" });

export default {
  async paths() {
    const pages = [["http", httpReference()], ["python", pythonReference()], ...(await javascriptReference())];
    return pages.map(([api, content]) => ({ params: { api }, content }));
  },
};
