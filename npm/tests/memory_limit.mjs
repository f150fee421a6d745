/** The module with at most so many pages of memory (64 KiB each): its memory section is written anew. */
export function withMemoryLimit(wasm, pages) {
  const memorySection = 5;
  let at = 8; // after magic and version
  const number = () => {
    let value = 0;
    for (let shift = 0; ; shift += 7) {
      const byte = wasm[at++];
      value |= (byte & 0x7f) << shift;
      if (byte < 0x80) return value >>> 0;
    }
  };
  const leb = (value) => {
    const bytes = [];
    for (; value >= 0x80; value >>>= 7) bytes.push((value & 0x7f) | 0x80);
    return [...bytes, value];
  };
  for (;;) {
    const start = at;
    const section = wasm[at++];
    const size = number();
    const end = at + size;
    if (section !== memorySection) {
      at = end;
      continue;
    }
    at += 2; // one memory, without a limit
    const content = [1, 1, ...leb(number()), ...leb(pages)];
    return Buffer.concat([wasm.subarray(0, start), Buffer.from([section, ...leb(content.length), ...content]), wasm.subarray(end)]);
  }
}
