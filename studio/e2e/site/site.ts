// A site that the command writes, and a plain server of files.
import { execFileSync } from "node:child_process";
import { createReadStream, existsSync, statSync } from "node:fs";
import { createServer, type Server } from "node:http";
import type { AddressInfo } from "node:net";
import { extname, join, resolve } from "node:path";
import { command, data } from "../command";

// Names the planner to the command, where it has none built in.
export const plannerOption = process.env.WAYBREAKER_WASM ? ["--wasm", process.env.WAYBREAKER_WASM] : [];

// The folder of a site: that of WAYBREAKER_SITE, such as the playground of the web site, or one that is written below `scratch`.
export function siteIn(scratch: string): string {
  if (process.env.WAYBREAKER_SITE) return resolve(process.env.WAYBREAKER_SITE);
  const folder = join(scratch, "site");
  execFileSync(command, ["site", folder, "--maps", data, ...plannerOption]);
  return folder;
}

const types: Record<string, string> = {
  ".html": "text/html",
  ".js": "text/javascript",
  ".css": "text/css",
  ".json": "application/json",
  ".wasm": "application/wasm",
};

// Serves the files of a folder below `/some/folder/`, as hosts do.
export class FileServer {
  private constructor(
    private readonly server: Server,
    readonly url: string,
  ) {}

  static async start(folder: string): Promise<FileServer> {
    const base = "/some/folder/";
    const server = createServer((request, response) => {
      const { pathname } = new URL(request.url!, "http://localhost");
      const below = pathname.startsWith(base) ? decodeURIComponent(pathname.slice(base.length)) : "..";
      const file = join(folder, below || "index.html");
      if (below.includes("..") || !existsSync(file) || !statSync(file).isFile()) return response.writeHead(404).end();
      response.writeHead(200, { "Content-Type": types[extname(file)] ?? "application/octet-stream" });
      createReadStream(file).pipe(response);
    });
    await new Promise<void>((ready) => server.listen(0, "127.0.0.1", ready));
    return new FileServer(server, `http://127.0.0.1:${(server.address() as AddressInfo).port}${base}`);
  }

  async stop(): Promise<void> {
    this.server.closeAllConnections();
    await new Promise((done) => this.server.close(done));
  }
}
