// Keeps the page, and the maps that were opened, for when there is no network (public/service-worker.js). Not where the
// browser has no service workers: pages without TLS, private windows.
export function keepForOffline(): void {
  const { serviceWorker } = navigator as Partial<Navigator>;
  if (!serviceWorker) return;
  serviceWorker.addEventListener("controllerchange", fetchMapsAgain, { once: true });
  void serviceWorker.register("service-worker.js").catch(() => undefined);
}

// On the first visit maps come before the service worker is there, and go past it.
function fetchMapsAgain(): void {
  const folder = new URL("maps/", document.baseURI).href;
  const again = (entry: PerformanceEntry) => {
    const wentPast = (entry as PerformanceResourceTiming).workerStart === 0;
    if (entry.name.startsWith(folder) && wentPast) void fetch(entry.name).catch(() => undefined);
  };
  new PerformanceObserver((list) => list.getEntries().forEach(again)).observe({ type: "resource", buffered: true });
}
