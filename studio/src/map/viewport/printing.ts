// When the page goes to paper and comes back: on it are light colours, and everything at once.
export function onPrinting(act: (printing: boolean) => void): () => void {
  const listening = new AbortController();
  const { signal } = listening;
  // Browsers that only show how print would look change the medium alone.
  const medium = matchMedia("print");
  medium.addEventListener("change", () => act(medium.matches), { signal });
  addEventListener("beforeprint", () => act(true), { signal });
  addEventListener("afterprint", () => act(false), { signal });
  return () => listening.abort();
}
