import type { Connection, Listener } from "./remote.js";

export function connectionTo(worker: Worker, listener: Listener): Connection {
  worker.onmessage = ({ data }) => listener.answered(data);
  worker.onerror = (event) => listener.failed(event.message);
  return {
    post: (message) => worker.postMessage(message),
    hold: () => undefined,
    end: () => worker.terminate(),
  };
}
