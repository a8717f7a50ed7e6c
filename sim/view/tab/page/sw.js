// Caches the folder's files, so that the page works without a network. The build inserts their list and a
// hash of their contents (sim/view/tab/folder.mjs), so a folder with different files gets a new cache.
const FILES = [/* files */], CONTENT = '/* content */';

const MINE = `robosim ${registration.scope} `, NAME = MINE + CONTENT;

async function keep() {
  const cache = await caches.open(NAME);
  await cache.addAll(FILES.map((file) => new Request(file, { cache: 'no-cache' })));
  await skipWaiting();
}

async function forgetOthers() {
  for (const name of await caches.keys()) if (name.startsWith(MINE) && name !== NAME) await caches.delete(name);
  await clients.claim();
}

async function answer(request) {
  const cache = await caches.open(NAME);
  return await cache.match(request, { ignoreSearch: true }) ?? fetch(request);
}

addEventListener('install', (e) => e.waitUntil(keep()));
addEventListener('activate', (e) => e.waitUntil(forgetOthers()));
addEventListener('fetch', (e) => { if (e.request.method === 'GET') e.respondWith(answer(e.request)); });
