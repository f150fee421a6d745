// A mission in the fragment of an address, which no server sees or limits: readable while it is short, else compressed.
// Links of former versions have it in the query.
const readable = 400; // letters
const compressed = "z=";
const most = 1_000_000; // letters that are unpacked
const piece = 1024; // bytes that are unpacked at a time, of which deflate makes a thousand times as many at most

// More than this many programs cut off or refuse.
export const longestLink = 8000;

// A mission that no page has written.
export class TooLarge extends Error {}

export async function fragmentOf(query: string): Promise<string> {
  return query.length <= readable ? `#${query}` : `#${compressed}${await pack(query)}`;
}

export interface Place {
  hash: string;
  search: string;
}

// The query of a mission; empty where the address holds none. Throws where it is cut off.
export async function missionAt({ hash, search }: Place): Promise<string> {
  const fragment = hash.replace(/^#/, "");
  if (fragment.startsWith(compressed)) return unpack(fragment.slice(compressed.length));
  return holdsMission(fragment) ? fragment : holdsMission(search) ? search.replace(/^\?/, "") : "";
}

export function holdsMission(query: string): boolean {
  const given = new URLSearchParams(query);
  return ["map", "start", "goal", "vehicles"].some((name) => given.has(name));
}

async function pack(text: string): Promise<string> {
  const packed = new Blob([text]).stream().pipeThrough(new CompressionStream("deflate"));
  const bytes = new Uint8Array(await new Response(packed).arrayBuffer());
  let letters = "";
  for (const byte of bytes) letters += String.fromCharCode(byte);
  return btoa(letters).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "");
}

async function unpack(text: string): Promise<string> {
  const letters = atob(text.replaceAll("-", "+").replaceAll("_", "/"));
  const bytes = Uint8Array.from(letters, (letter) => letter.charCodeAt(0));
  let at = 0;
  // A stream unpacks whole what it is given at once: it is given no more than what has been read allows.
  const packed = new ReadableStream<BufferSource>({
    pull(stream) {
      if (at < bytes.length) stream.enqueue(bytes.slice(at, (at += piece)));
      else stream.close();
    },
  });
  const reader = packed.pipeThrough(new DecompressionStream("deflate")).getReader();
  const decoder = new TextDecoder();
  let query = "";
  for (let { done, value } = await reader.read(); !done; { done, value } = await reader.read()) {
    query += decoder.decode(value, { stream: true });
    if (query.length > most) {
      void reader.cancel();
      throw new TooLarge("the mission is too large");
    }
  }
  return query;
}
