// The site around the program: the Learn page, use without a network, new versions, and what the page may not do.

import assert from 'node:assert/strict';
import { after, before, it, ONE_ENGINE } from './harness.mjs';
import { startBench, until } from './page.mjs';

/** Name of a build that there is not. */
const ANOTHER = 'another-build';

let bench;
before(async () => {
  bench = await startBench();
});
after(() => bench.close());

/** Waits until the page has been kept on this computer. */
function kept(page) {
  return until('the page kept on this computer', () =>
    page.run("return navigator.serviceWorker.getRegistration().then((kept) => kept?.active?.state === 'activated')"),
  );
}

/** What the page offers about a new version, empty if nothing. */
function offered(page) {
  return page.run("const bar = document.querySelector('[role=region][aria-label=\"New version\"]'); return bar.hidden ? '' : bar.innerText");
}

/** From now on the server has another build of the page: another name. */
async function publishAnother(before) {
  const rename = (text) => text.replace(before, ANOTHER);
  await bench.server.changePage(rename, rename);
}

/** Notes in the page itself which scripts, styles and requests its policy refuses. */
async function watchPolicy(page) {
  await page.runBefore(
    "globalThis.refused = []; addEventListener('securitypolicyviolation', ({ violatedDirective, blockedURI }) => refused.push(`${violatedDirective} ${blockedURI}`))",
  );
}

it('the Learn page can be read without scripts, and its examples open in the calculator', { needs: ['switch scripts off'] }, async (test) => {
  const page = await bench.page(test);
  await page.engine.allowScripts(page.driver, false);
  await page.driver.get(`${bench.server.url}learn.html`);
  const text = await page.driver.findElement({ css: 'main' }).getText();
  assert.match(text, /A robot looks at a mug/);
  assert.match(text, /Which baseline is reasonable\?/);
  const sizes = await page.run(`
    const box = (selector) => document.querySelector(selector).getBoundingClientRect();
    return { fraction: box('math mfrac').height, letter: box('math mi').height, window: innerWidth, page: document.documentElement.scrollWidth };
  `);
  assert.ok(sizes.fraction > 1.5 * sizes.letter, `formulas are drawn as fractions: ${JSON.stringify(sizes)}`);
  assert.ok(sizes.page <= sizes.window, `nothing stands out at the side: ${JSON.stringify(sizes)}`);

  await page.engine.allowScripts(page.driver, true);
  await page.driver.findElement({ css: 'a[href*="fx=700"]' }).click();
  await page.started();
  await page.says(/1\.373…1\.429 m/);
  assert.deepEqual(await page.consoleProblems(), []);
});

it('the Learn page fits a phone', { needs: ['show a page as narrow as a phone'] }, async (test) => {
  const page = await bench.page(test);
  await page.setScreen({ width: 320, height: 640 });
  await page.driver.get(`${bench.server.url}learn.html`);
  const { window, page: width } = await page.run('return { window: innerWidth, page: document.documentElement.scrollWidth }');
  assert.equal(window, 320);
  assert.ok(width <= 320, `the page is ${width} px wide`);
});

it('the policy refuses nothing that the program needs, and does refuse what it should', async (test) => {
  const page = await bench.page(test);
  await watchPolicy(page);
  await page.start();
  await page.press('Coffee mug (stereo)');
  await page.says(/1\.373…1\.429 m/);
  await kept(page);
  assert.deepEqual(await page.run('return refused'), []);
  assert.deepEqual(await page.consoleProblems(), []);
  assert.deepEqual(await page.askedOrigins(), [bench.server.origin]);
  assert.deepEqual(page.elsewhere(), []);

  await page.run("const script = document.createElement('script'); script.textContent = 'globalThis.injected = true'; document.body.append(script)");
  assert.equal(await page.run('return globalThis.injected ?? false'), false);
  await page.run("return fetch('http://127.0.0.1:9/').then(() => {}, () => {})");
  const refused = await until('two refusals', async () => {
    const seen = await page.run('return refused');
    return seen.length >= 2 && seen;
  });
  assert.match(refused.join(), /script-src/);
  assert.match(refused.join(), /connect-src/);
});

it('the page can be installed', { needs: ['say what keeps a page from being installed'] }, async (test) => {
  const page = await bench.page(test);
  await page.start();
  assert.deepEqual(await page.engine.installProblems(page.driver), []);
});

it('the second visit works without a server', async (test) => {
  const page = await bench.page(test);
  await page.start();
  await kept(page);
  bench.server.close();
  await assert.rejects(fetch(bench.server.url), 'the server is gone');

  // Elsewhere first: from the page itself, the browser would only follow the fragment.
  await page.driver.get('about:blank');
  await page.driver.get(`${bench.server.url}#fx=700&b=100mm&d=50`);
  await page.started();
  await page.says(/1\.373…1\.429 m/);
  assert.ok(await page.run('return navigator.serviceWorker.controller !== null'));
  await page.driver.get(`${bench.server.url}learn.html`);
  assert.match(await page.driver.findElement({ css: 'h1' }).getText(), /Distance/);
});

it('files of two builds are never kept as one', async (test) => {
  const page = await bench.page(test);
  await page.start();
  await kept(page);
  const before = await page.run("return document.querySelector('meta[name=build]').content");
  const names = await caches(page);
  // A host that is half way: a new worker, and still the old page.
  bench.server.state.changed.set('sw.js', (text) => text.replace(before, ANOTHER).replace(/\["\.\/","sha256-./, (start) => start.slice(0, -1) + (start.endsWith('A') ? 'B' : 'A')));
  const outcome = await page.driver.executeAsyncScript(
    `const done = arguments[0];
    navigator.serviceWorker.getRegistration().then(async (kept) => {
      kept.addEventListener('updatefound', () => {
        const worker = kept.installing;
        worker.addEventListener('statechange', () => done(worker.state));
      });
      await kept.update().catch(() => {});
    });`,
  );
  assert.equal(outcome, 'redundant');
  assert.equal(await offered(page), '');
  const complete = await page.run("return caches.keys().then((names) => Promise.all(names.map(async (name) => [name, (await (await caches.open(name)).keys()).length])))");
  assert.ok(complete.some(([name, files]) => names.includes(name) && files > 10), JSON.stringify(complete));
});

it('a storage of the worker that fails does not keep the network away', { engines: ONE_ENGINE }, async () => {
  const worker = await (await fetch(`${bench.server.url}sw.js`)).text();
  const listeners = {};
  const scope = { registration: { scope: 'http://host/' }, addEventListener: (name, heard) => (listeners[name] = heard), caches: { open: () => Promise.reject(new Error('The disk is broken.')) }, fetch: async () => 'from the network', URL, Map, Set, Promise, setTimeout };
  new Function(...Object.keys(scope), worker)(...Object.values(scope));
  const file = JSON.parse(worker.match(/const FILES = (.*);/)[1]).map(([name]) => name).find((name) => name.endsWith('.wasm'));
  let answer;
  listeners.fetch({ request: { method: 'GET', mode: 'cors', url: `http://host/${file}` }, respondWith: (given) => (answer = given) });
  assert.equal(await answer, 'from the network');
});

it('a server that keeps silent does not keep anybody waiting for long', async (test) => {
  const page = await bench.page(test);
  bench.server.state.impatient = true;
  await page.start();
  await kept(page);
  let asked = false;
  let speak;
  const silence = new Promise((resolve) => (speak = resolve));
  bench.server.state.changed.set('index.html', async (text) => {
    asked = true;
    await silence;
    return text;
  });
  // While the server has not answered.
  await openAnew(page);
  speak();
  assert.ok(asked, 'the network comes first');
  assert.ok(await page.run('return navigator.serviceWorker.controller !== null'));
});

it('a new version is offered, and comes when it is asked for', async (test) => {
  const page = await bench.page(test);
  await page.start();
  await kept(page);
  await openAnew(page);
  assert.equal(await offered(page), '', 'nothing is new');
  const before = await page.run("return document.querySelector('meta[name=build]').content");
  assert.match(before, /^[0-9a-f]{16}$/);

  await publishAnother(before);
  // As the page itself does when somebody comes back to it.
  await page.run("document.body.dataset.same = 'document'; document.dispatchEvent(new Event('visibilitychange'))");
  assert.match(await until('the offer', () => offered(page)), /Reload/);
  await until('its words', async () => /A new version is ready\./.test(await offered(page)));
  await page.frames();
  assert.equal(await page.run('return document.body.dataset.same'), 'document', 'nobody is interrupted');
  assert.equal((await caches(page)).length, 2, 'the version in use stays until then');

  // Nothing that the program draws is covered by the offer.
  const [canvas, bar] = await page.run('return [...arguments].map((one) => one.getBoundingClientRect().toJSON())', await page.canvas(), await page.around('[role=region]', /^New version$/));
  assert.ok(canvas.bottom <= bar.top && canvas.bottom > 500, JSON.stringify({ canvas, bar }));
  await page.click('Reload');
  await until('the new version', () =>
    page.run("return !document.body.dataset.same && document.querySelector('meta[name=build]')?.content === arguments[0]", ANOTHER),
  );
  await page.started();
  const left = await until('only the new version kept', async () => {
    const names = await caches(page);
    return names.length === 1 && names;
  });
  assert.match(left[0], /another-build$/);
  assert.equal(await offered(page), '');
});

it('whoever opens the page anew has the new version at once, without being asked', async (test) => {
  const page = await bench.page(test);
  await page.start();
  await kept(page);
  const before = await page.run("return document.querySelector('meta[name=build]').content");
  await publishAnother(before);

  await openAnew(page);
  assert.equal(await page.run("return document.querySelector('meta[name=build]').content"), 'another-build');
  await until('the new version kept', async () => {
    const names = await caches(page);
    return names.length === 1 && names[0].endsWith(' another-build');
  });
  assert.equal(await offered(page), '');
});

it('without what keeps it, the page works all the same', async (test) => {
  const page = await bench.page(test);
  bench.server.state.changed.set('sw.js', () => 'this is no script');
  await page.start();
  await page.press('Coffee mug (stereo)');
  await page.says(/1\.373…1\.429 m/);
  assert.equal(await page.failure(), '');
  // It has been tried, and nothing came of it.
  await page.driver.executeAsyncScript("navigator.serviceWorker.register('./sw.js').then(arguments[0], arguments[0])");
  assert.equal(await page.run('return navigator.serviceWorker.getRegistration().then((kept) => kept?.active ?? null)'), null);
});

/** Opens the page as somebody does who comes back later. (A browser that is told to load it again may ask the network for everything.) */
async function openAnew(page) {
  await page.driver.get('about:blank');
  await page.start();
}

function caches(page) {
  return page.run('return caches.keys()');
}
