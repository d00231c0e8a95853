// Service worker: the page works without a network after the first visit.

/** Files of the page; the build replaces the name by the checksum of all files. */
declare const CACHE: string;
declare const FILES: string[];

interface ExtendableEvent extends Event {
  waitUntil(done: Promise<unknown>): void;
}
interface FetchEvent extends ExtendableEvent {
  request: Request;
  respondWith(response: Promise<Response>): void;
}

self.addEventListener("install", (event) => {
  const fill = async () => {
    const cache = await caches.open(CACHE);
    await cache.addAll(FILES);
  };
  (event as ExtendableEvent).waitUntil(fill());
});

self.addEventListener("activate", (event) => {
  const remove = async () => {
    const names = await caches.keys();
    const old = names.filter((name) => name.startsWith("ancf-") && name !== CACHE);
    await Promise.all(old.map((name) => caches.delete(name)));
  };
  (event as ExtendableEvent).waitUntil(remove());
});

self.addEventListener("fetch", (event) => {
  const { request } = event as FetchEvent;
  const answer = async () => {
    const cache = await caches.open(CACHE);
    return (await cache.match(request, { ignoreSearch: true })) ?? (await fetch(request));
  };
  if (request.method === "GET") (event as FetchEvent).respondWith(answer());
});
