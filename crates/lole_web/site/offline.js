// Keeps the page for visits without a network. What it keeps is named by what the files hold: another build is
// another name, and is kept whole before it is shown. The page in use is never changed under its user.
const BUILD = "lole-BUILD";
const FILES = ["./", "index.html", "page.css", "page.js", "worker.js", "lole_web.js", "lole_web_bg.wasm", "letters.otf", "manifest.webmanifest", "icon.svg"];
// What paper is made with is large, and fetched after the page is there.
const LATER = ["paper-regular.otf", "paper-bold.otf"];

self.addEventListener("install", (event) => {
  event.waitUntil(caches.open(BUILD).then((kept) => kept.addAll(FILES.map((file) => new Request(file, { cache: "no-cache" })))));
});

self.addEventListener("activate", (event) => {
  event.waitUntil(caches.keys().then((names) => Promise.all(
    names.filter((name) => name.startsWith("lole-") && name !== BUILD).map((name) => caches.delete(name)),
  )).then(() => self.clients.claim()));
});

self.addEventListener("message", (event) => {
  if (event.data === "now") self.skipWaiting();
  if (event.data === "later") event.waitUntil(caches.open(BUILD).then((kept) => kept.addAll(LATER)));
});

self.addEventListener("fetch", (event) => {
  if (event.request.method !== "GET" || new URL(event.request.url).origin !== self.location.origin) return;
  event.respondWith(caches.open(BUILD).then(async (kept) => {
    const found = await kept.match(event.request, { ignoreSearch: true });
    return found || fetch(event.request);
  }));
});
