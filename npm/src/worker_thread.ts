// The script of a browser's worker.
import { server } from "./serve.js";

const serve = server((message) => postMessage(message));
addEventListener("message", ({ data }) => serve(data));
