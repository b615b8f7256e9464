// Before the program runs, while it loads, and when it cannot run.

import assert from 'node:assert/strict';
import { after, before, it, ONE_ENGINE } from './harness.mjs';
import { startBench, until } from './page.mjs';
import { settings } from './settings.mjs';

let bench;
before(async () => {
  bench = await startBench();
});
after(() => bench.close());

it('the page names itself and its purpose before any program has arrived', { engines: ONE_ENGINE }, async () => {
  const html = await (await fetch(bench.server.url)).text();
  assert.match(html, /<title>Depth Calculator<\/title>/);
  assert.match(html, /How far away is it, and how sure can I be\?/);
  assert.match(html, /<progress /);
  assert.match(html, /<noscript>/);
  assert.doesNotMatch(html, /user-scalable|maximum-scale/, 'zooming must stay possible');
  assert.doesNotMatch(html, /<script(?![^>]* (?:src=|type="application\/ld\+json"))/, 'a strict Content-Security-Policy allows no script inside the page');
  assert.doesNotMatch(html, /<style|style=|\son[a-z]+=/, 'nor styles and handlers');
  assert.doesNotMatch(html, /(?<!rel="canonical" )(?:src|href)="(?:\/|[a-z]+:)/, 'every address must be relative');
});

it('the program starts, without a complaint and without asking anybody else', async (test) => {
  const page = await bench.page(test);
  await page.start();
  assert.equal(await page.failure(), '');
  assert.equal(await page.bar(), undefined, 'the program stands where it was awaited');
  assert.deepEqual(await page.consoleProblems(), []);
  assert.deepEqual(await page.askedOrigins(), [bench.server.origin]);
  assert.deepEqual(page.elsewhere(), []);
});

it('had the page or its worker asked anybody else, it would have been noticed', async (test) => {
  const page = await bench.page(test);
  const ask = "fetch('http://plain.SELF.example/').catch(() => {}); fetch('https://secure.SELF.example/', { mode: 'no-cors' }).catch(() => {});";
  bench.server.state.added.set('before.js', `${ask.replaceAll('SELF', 'page')} new Image().src = 'http://image.page.example/';`);
  // Without the policy, which would refuse all that.
  const open = (html) => html.replace(/<meta http-equiv="Content-Security-Policy"[^>]*>/, '').replace('<head>', '<head><script src="before.js"></script>');
  await bench.server.changePage(open, (worker) => `${worker}\n${ask.replaceAll('SELF', 'worker')}`);
  await page.start();
  for (const asked of ['http://plain.page', 'https://secure.page', 'http://image.page', 'http://plain.worker', 'https://secure.worker']) {
    await until(`${asked} noticed`, () => page.elsewhere().some((one) => one.includes(asked)));
  }
});

it('every file that the page names is there', { engines: ONE_ENGINE }, async () => {
  const html = await (await fetch(bench.server.url)).text();
  const names = [...html.matchAll(/<(?:link(?! rel="canonical")|script)[^>]* (?:href|src)="([^"]+)"/g)].map((match) => match[1]);
  assert.ok(names.length >= 6, `only ${names}`);
  for (const name of names) {
    const answer = await fetch(new URL(name, bench.server.url));
    assert.equal(answer.status, 200, name);
    await answer.body.cancel();
  }
});

it('the bar moves while the program arrives', async (test) => {
  const page = await bench.page(test);
  Object.assign(bench.server.state, { programs: 'held', pieces: 0 });
  // Navigating from within the page does not wait for it to be loaded, which it is not until the last piece is sent.
  await page.driver.get('about:blank');
  await page.run('location.href = arguments[0]', bench.server.url);
  let position = 0;
  for (const pieces of [4, 10, 16]) {
    bench.server.state.pieces = pieces;
    position = await until(`the bar moves on from ${position}`, async () => {
      const bar = await page.bar();
      const now = bar && (await page.run('return arguments[0].position', bar));
      return now > position && now < 1 && now;
    });
  }
  bench.server.state.pieces = 20;
  await page.started();
});

it('a host that does not know the type of the program does no harm', async (test) => {
  const page = await bench.page(test);
  bench.server.state.programs = 'old type';
  await page.start();
  assert.deepEqual(await page.consoleProblems(), []);
});

const FAILURES = [
  { title: 'without WebGL', options: { without: 'webgl' }, says: /does not offer WebGL 2/ },
  { title: 'without WebAssembly', options: { without: 'webassembly' }, says: /does not run WebAssembly/ },
  { title: 'a missing program', programs: 'missing', says: /could not be downloaded/ },
  { title: 'a connection that ends in the middle', programs: 'cut', says: /could not be downloaded/ },
  { title: 'a file that is no program', programs: 'broken', says: /arrived, but this browser could not start it/ },
];

for (const { title, options, programs, says } of FAILURES) {
  it(`${title} is said in words, with a way on`, async (test) => {
    const page = await bench.page(test, options);
    bench.server.state.programs = programs ?? 'sent';
    const text = await page.startFailing();
    assert.match(text, says);
    assert.match(text, /Reload/);
    assert.match(text, /What you entered is kept in this browser\./);
    assert.equal(await page.run("return document.querySelector('main').inert"), true, 'what cannot be used is out of the way');
  });
}

it('Reload tries again', async (test) => {
  const page = await bench.page(test);
  bench.server.state.programs = 'missing';
  await page.startFailing();
  bench.server.state.programs = 'sent';
  await page.startAgain('Reload');
});

it('lost graphics are said in words', async (test) => {
  const page = await bench.page(test);
  await page.start();
  await page.loseGraphics();
  assert.match(await until('a message', () => page.failure()), /took the graphics away/);
});

/**
 * What the page hears of a program that reads beside its memory, which a compiler of WebKit makes it do now and then: a trap, or a panic
 * where it reads a length there. As soon after the first frame as if the machine were fast.
 */
const STOPS = {
  trap: "dispatchEvent(new ErrorEvent('error', { error: new window.WebAssembly.RuntimeError('Out of bounds memory access') }));",
  panic: "dispatchEvent(new CustomEvent('program-failed', { detail: ['The program has stopped because of an error in it.', 'Reload.', 'panicked at'] }));",
};
const SOON = "performance.clearMarks('first-frame'); performance.mark('first-frame');";

for (const [kind, stop] of Object.entries(STOPS)) {
  it(`a program that stops soon after its start by a ${kind} is started again, once, and then says so`, async (test) => {
    const page = await bench.page(test);
    page.mayStartAgain = true;
    await page.start();
    await page.fill('Focal length (fx)', '700');
    await until('the input in the storage', async () => (await page.stored())?.includes('"700"'));
    await page.renew(SOON + stop);
    assert.equal(await page.value('Focal length (fx)'), '700', 'what was entered is there');
    await page.run(SOON + stop);
    assert.match(await until('a message', () => page.failure()), /stopped because of an error/);
    await page.startAgain('Reload');
    page.mayStartAgain = true;
    await page.renew(SOON + stop);
  });
}

it('how long the first frame takes is known', async (test) => {
  const page = await bench.page(test);
  const times = [];
  for (let run = 0; run < 5; run += 1) {
    await page.start();
    times.push(await page.firstFrameMs());
  }
  times.sort((a, b) => a - b);
  const figures = times.map((time) => Math.round(time)).join(', ');
  test.diagnostic(`first frame (${settings.engine}): median ${Math.round(times[2])} ms of ${figures}`);
  assert.ok(times[0] > 0 && times.length === 5);
});
