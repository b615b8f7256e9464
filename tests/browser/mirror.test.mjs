// The mirror after a long random walk: still the page that the program describes, with nothing stale in it.

import assert from 'node:assert/strict';
import { after, before, test as it } from 'node:test';
import { startBench, until } from './page.mjs';

const MIRROR = '#accessible-mirror';
const SEED = Number(process.env.SEED ?? 20_261_122);
const BATCHES = Number(process.env.BATCHES ?? 25);
const STEPS = 8;
const TEXTS = ['', '7', '700', '0.5', '-3', '1e400', 'seven', '10 cm', '1.5%', '٣', '²', '😀 a', '<b>&"', '1,5', '12 in', 'a'.repeat(300), ' 700 '];

let bench;
before(async () => {
  bench = await startBench();
});
after(() => bench.close());

/** Numbers from 0 to 1 that are the same for the same seed (mulberry32, by Tommy Ettinger, in the public domain). */
function randomNumbers(seed) {
  let state = seed | 0;
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let mixed = Math.imul(state ^ (state >>> 15), 1 | state);
    mixed = (mixed + Math.imul(mixed ^ (mixed >>> 7), 61 | mixed)) ^ mixed;
    return ((mixed ^ (mixed >>> 14)) >>> 0) / 2 ** 32;
  };
}

/** One step, as assistive technology does it: click, type, choose or move the focus. Returns what it did. */
const STEP = `
  const [chance, text, which] = arguments;
  const reachable = [...document.querySelectorAll('${MIRROR} :is(button, input, a, [role=slider])')].filter((one) => !one.disabled);
  const one = reachable[Math.floor(which * reachable.length)];
  if (!one) return 'nothing to reach';
  const name = one.getAttribute('aria-label') ?? document.getElementById(one.getAttribute('aria-labelledby'))?.textContent ?? one.textContent;
  // Away from the page leads no link: the walk is inside.
  if (one.localName === 'a') { one.focus(); return 'focus on link ' + name; }
  if (one.localName === 'input' && one.type === 'text') {
    one.focus();
    one.value = text;
    one.dispatchEvent(new InputEvent('input', { bubbles: true, inputType: 'insertText', data: text }));
    return JSON.stringify(text) + ' into ' + name;
  }
  if (one.localName === 'input' && one.type === 'range') {
    one.focus();
    one.value = String(Number(one.value) * (0.5 + chance));
    one.dispatchEvent(new Event('input', { bubbles: true }));
    return 'slider ' + name;
  }
  if (chance < 0.15) { one.focus(); return 'focus on ' + name; }
  if (chance > 0.9) {
    one.dispatchEvent(new KeyboardEvent('keydown', { key: 'Escape', code: 'Escape', bubbles: true, cancelable: true }));
    return 'Escape on ' + name;
  }
  one.click();
  return 'click on ' + name;`;

/** What the mirror as a page of HTML must hold to, whatever the program shows. One line for each fault. */
const FAULTS = `
  const host = document.querySelector('${MIRROR}');
  const all = [...host.querySelectorAll('*')];
  const faults = [];
  const ids = all.map((one) => one.id).filter(Boolean);
  if (new Set(ids).size !== ids.length) faults.push('an id occurs twice');
  for (const one of all) {
    for (const name of ['aria-labelledby', 'aria-describedby', 'aria-controls', 'aria-errormessage', 'aria-activedescendant']) {
      for (const id of (one.getAttribute(name) ?? '').split(' ').filter(Boolean)) {
        if (!document.getElementById(id)) faults.push(name + ' leads nowhere: ' + one.outerHTML.slice(0, 120));
      }
    }
    if (one.localName === 'input' && one.type === 'text' && !one.getAttribute('aria-label') && !one.getAttribute('aria-labelledby')) faults.push('a field without a name');
    if (one.localName === 'button' && !one.getAttribute('aria-label') && !one.getAttribute('aria-labelledby') && !one.textContent.trim()) faults.push('a button without a name: ' + one.outerHTML.slice(0, 120));
  }
  return faults;`;

/** What the program describes and what the browser holds, where the page exposes both. */
const TEXTS_OF_MIRROR = `
  const { description, readBack } = globalThis.accessibleMirror ?? {};
  return description ? [description(), readBack()] : null;`;

it(`a random walk of ${BATCHES * STEPS} steps (seed ${SEED}) leaves the mirror as the program describes it`, async (test) => {
  const page = await bench.page(test);
  await page.start();
  const random = randomNumbers(SEED);
  let compared = 0;
  const walked = [];
  for (let batch = 0; batch < BATCHES; batch += 1) {
    for (let step = 0; step < STEPS; step += 1) {
      walked.push(await page.run(STEP, random(), TEXTS[Math.floor(random() * TEXTS.length)], random()));
      if (random() < 0.5) await page.frames();
    }
    const last = () => `Seed ${SEED}, after ${walked.length} steps, the last of them: ${walked.slice(-2 * STEPS).join('; ')}`;
    assert.equal(await page.failure(), '', last());
    await page.frames();
    assert.deepEqual(await page.run(FAULTS), [], last());
    // A frame may lie between what was described and what has reached the browser.
    const texts = await page.run(TEXTS_OF_MIRROR);
    if (texts) {
      assert.equal(texts[1], texts[0], last());
      compared += 1;
    }
  }
  test.diagnostic(`${compared} of ${BATCHES} times the whole page was compared`);
  // Chromium's advice on speed, for letters that are drawn with the browser's fonts, is no fault.
  assert.deepEqual((await page.consoleProblems()).filter((problem) => !problem.includes('willReadFrequently')), []);
});

it('the fields hold what the program computes with, the table what it computes', async (test) => {
  const page = await bench.page(test);
  await page.start();
  await page.press('Coffee mug (stereo)');
  await page.says(/1\.400 m/);
  const rows = await page.run(
    `return [...document.querySelectorAll('${MIRROR} table')].flatMap((table) => [...table.rows].map((row) => [...row.cells].map((cell) => cell.textContent)))`,
  );
  const row = (name) => rows.find(([first, , unit]) => first === name && unit !== undefined);
  assert.deepEqual(row('Focal length (fx)')?.slice(0, 3), ['Focal length (fx)', '700', 'pixels']);
  assert.deepEqual(row('Disparity (d)')?.slice(0, 3), ['Disparity (d)', '50', 'pixels']);
  assert.match(row('Distance (stereo)')?.[1] ?? '', /^1\.400/);

  // What a field shows, what is stored, and what the next start shows is the same.
  const stored = JSON.parse(await until('the storage', () => page.stored()));
  assert.equal(await page.value('Focal length (fx)'), stored.inputs.focal_length.text);
  assert.equal(await page.value('Disparity (d)'), stored.inputs.disparity.text);
  const headings = await page.run(`return [...document.querySelectorAll('${MIRROR} :is(h1, h2)')].map((one) => one.textContent)`);
  assert.deepEqual(headings.slice(0, 5), ['Depth Calculator', 'Camera', 'Stereo', 'Monocular', 'Results']);
});
