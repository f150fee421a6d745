// What the page and its planner's Worker send each other.

export type Call =
  | { what: "open"; map: string; document: string }
  | { what: "read"; file: Uint8Array } // a map of MovingAI's format
  | { what: "edit"; of: string; edits: string }
  | { what: "close"; map: string }
  | { what: "plan"; map: string; request: string }
  | { what: "revise"; map: string; request: string }
  | { what: "check"; map: string; plan: string }
  | { what: "export"; map: string; plan: string; format: string };

// What a document says that a new map is called.
export function idOfDocument(document: string): string {
  return /"id":"([^"]+)"/.exec(document)![1]!;
}

// The first message to a Worker is the compiled module, the others are calls, one at a time.
export type ToWorker = WebAssembly.Module | Call;

export type FromWorker =
  | { kind: "progress"; best: number; bound: number }
  | { kind: "answer"; text: string } // of "open" and "close" empty, of "read" and "edit" the map's document
  | { kind: "refused"; reason: string } // by the planner, which says why
  | { kind: "failed"; reason: string }; // the Worker cannot go on
