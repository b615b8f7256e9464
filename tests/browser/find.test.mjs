// The browser's own search in the page: it finds what is painted, marks it where it is painted, and scrolls to it.

import assert from 'node:assert/strict';
import { after, before, it } from './harness.mjs';
import { startBench, until } from './page.mjs';

let bench;
before(async () => {
  bench = await startBench();
});
after(() => bench.close());

/** What the search marks, and the element that says it. */
const MARKED = `
  const range = getSelection().getRangeAt(0);
  const rect = (one) => { const { left, top, right, bottom } = one.getBoundingClientRect(); return { left, top, right, bottom }; };
  const host = document.querySelector('#accessible-mirror');
  const element = range.startContainer.parentElement;
  return { text: String(range), range: rect(range), element: rect(element), canvas: rect(document.querySelector('canvas')), host: rect(host), opacity: getComputedStyle(host).opacity };`;

/** Searches from the beginning of the page, and says what is marked once it is in sight and nothing moves any more. */
async function find(page, words) {
  assert.equal(await page.run('getSelection().removeAllRanges(); return window.find(arguments[0], true)', words), true, `"${words}" is found`);
  let last;
  return until(`"${words}" in sight`, async () => {
    await page.frames();
    const marked = await page.run(MARKED);
    const rests = last?.range.top === marked.range.top;
    last = marked;
    return rests && marked.range.top >= marked.canvas.top && marked.range.bottom <= marked.canvas.bottom && marked;
  });
}

/** That a mark covers what is painted: `few` pixels more or less on each side, which is less than a letter in every font of a browser. */
function assertCovers({ range, element }, few = 6) {
  for (const side of ['left', 'right', 'top', 'bottom']) {
    assert.ok(Math.abs(range[side] - element[side]) <= few, `${side}: marked at ${range[side]}, painted at ${element[side]}`);
  }
}

it('the search of the browser marks the painted words', async (test) => {
  const page = await bench.page(test);
  await page.start();
  const marked = await find(page, 'Camera baseline (b)');
  assertCovers(marked);
  assert.equal(marked.opacity, '1');
  assert.deepEqual(marked.host, marked.canvas, 'the page lies over the canvas');
});

it('the search of the browser scrolls to what is out of sight, down and up again', async (test) => {
  const page = await bench.page(test);
  await page.start();
  await page.show('Learn');
  await page.says(/What this computes/);
  // What stands in the page once: in the list of contents a heading stands again.
  const headings = await page.run(`
    const mirror = document.querySelector('#accessible-mirror');
    const words = [...mirror.querySelectorAll('h1, h2, h3')].map((one) => one.textContent);
    return words.filter((one) => mirror.textContent.toLowerCase().split(one.toLowerCase()).length === 2)`);
  const [first, last] = [headings[0], headings.at(-1)];
  assert.notEqual(first, last);
  for (const words of [last, first]) {
    const marked = await find(page, words);
    assert.equal(marked.text, words);
    assertCovers(marked);
    assert.deepEqual(marked.host, marked.canvas, 'the page lies over the canvas');
  }
  assert.deepEqual(await page.consoleProblems(), []);
});
