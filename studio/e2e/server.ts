// A running `waybreaker serve`.
import { spawn, type ChildProcess } from "node:child_process";
import { command, data } from "./command";

export class Server {
  private constructor(
    readonly url: string,
    readonly port: number,
    private readonly child: ChildProcess,
  ) {}

  static async start(port = 0): Promise<Server> {
    const child = spawn(command, ["serve", "--maps", data, "--port", String(port)], { stdio: ["ignore", "ignore", "pipe"] });
    const url = await new Promise<string>((found, failed) => {
      let log = "";
      child.stderr!.on("data", (bytes: Buffer) => {
        log += bytes.toString();
        const listening = /http:\/\/127\.0\.0\.1:\d+/.exec(log);
        if (listening) found(listening[0]);
      });
      child.on("exit", () => failed(new Error(`the server ended: ${log}`)));
    });
    return new Server(url, Number(new URL(url).port), child);
  }

  async stop(): Promise<number | null> {
    if (this.child.exitCode !== null) return this.child.exitCode;
    const ended = new Promise<number | null>((resolve) => this.child.on("exit", resolve));
    this.child.kill("SIGTERM");
    return ended;
  }
}
