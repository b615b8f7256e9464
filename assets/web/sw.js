// Keeps this build of the page on the computer, so that it opens without a network and at once.
// `cargo xtask dist` fills in which build it is and which files it has.

const BUILD = '';
/** Name and digest (as for Subresource Integrity) of each: what a host still has of another build is not kept as part of this one. */
const FILES = [];
/** The same of what most visitors never use: it is kept from the first use on. */
const LATER = [];

/** Several sites, and several copies of this one, may share an origin and so its caches. */
const OURS = `depth-calculator ${registration.scope} `;
const CACHE = OURS + BUILD;
/** After that, the page that was kept is better than none. */
const PATIENCE_MS = 4000;

const address = (name) => new URL(name, registration.scope).href;
const ADDRESSES = new Set(FILES.map(([name]) => address(name)));
const LATER_BY_ADDRESS = new Map(LATER.map((file) => [address(file[0]), file]));
/** Where the pages are kept, by where they are asked for. */
const PAGES = new Map([
  [address('./'), address('./')],
  [address('index.html'), address('./')],
  [address('learn.html'), address('learn.html')],
]);

/** What is kept of it, if anything: where that cannot be read, the network still can. */
async function kept(url) {
  try {
    const cache = await caches.open(CACHE);
    return await cache.match(url, { ignoreVary: true });
  } catch {
    return undefined;
  }
}

async function keep([name, integrity]) {
  // Asks whether what the browser still has is up to date.
  const answer = await fetch(address(name), { cache: 'no-cache', integrity });
  if (!answer.ok) throw new Error(`${name}: HTTP status ${answer.status}`);
  // Browsers refuse a page that came by a redirection.
  const copy = answer.redirected ? new Response(await answer.blob(), { headers: answer.headers }) : answer;
  const cache = await caches.open(CACHE);
  await cache.put(address(name), copy);
}

/** Keeps a file that is used for the first time. Where there is no room for it, it is used all the same. */
async function used(request, file) {
  const before = await kept(request.url);
  if (before) return before;
  await keep(file).catch(() => {});
  return (await kept(request.url)) ?? fetch(request);
}

async function forgetOtherBuilds() {
  const others = (await caches.keys()).filter((name) => name.startsWith(OURS) && name !== CACHE);
  await Promise.all(others.map((name) => caches.delete(name)));
}

const patienceEnds = () =>
  new Promise((_, reject) => {
    setTimeout(reject, PATIENCE_MS, new Error('The network takes too long.'));
  });

/** The network first: nobody stays on an old version while there is a new one. */
async function page(request, url) {
  // Asked whether it is up to date, whatever the host says of how long it may be used.
  const network = fetch(request, { cache: 'no-cache' });
  try {
    const answer = await Promise.race([network, patienceEnds()]);
    if (answer.status < 500) return answer;
  } catch {
    // No network, or too slow.
  }
  return (await kept(url)) ?? network;
}

addEventListener('install', (event) => {
  event.waitUntil(Promise.all(FILES.map(keep)));
});

addEventListener('activate', (event) => {
  event.waitUntil(forgetOtherBuilds());
});

addEventListener('fetch', (event) => {
  const { request } = event;
  if (request.method !== 'GET') return;
  const url = request.url.split(/[?#]/)[0];
  if (request.mode === 'navigate') {
    if (PAGES.has(url)) event.respondWith(page(request, PAGES.get(url)));
  } else if (ADDRESSES.has(request.url)) {
    event.respondWith(kept(request.url).then((answer) => answer ?? fetch(request)));
  } else if (LATER_BY_ADDRESS.has(request.url)) {
    event.respondWith(used(request, LATER_BY_ADDRESS.get(request.url)));
  }
});

// register.js of a page of any other build may ask this: what it asks must stay the same.
addEventListener('message', ({ data, ports }) => {
  if (data === 'build') ports[0].postMessage(BUILD);
  if (data === 'activate') skipWaiting();
});
