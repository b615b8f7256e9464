// What leaves the page: charts as files, and the report on paper. Both are asked of Chromium, the one whose driver tells of them.

import assert from 'node:assert/strict';
import { mkdtemp, readFile, readdir, rm } from 'node:fs/promises';
import os from 'node:os';
import path from 'node:path';
import { PNG } from 'pngjs';
import { after, before, it, ONE_ENGINE } from './harness.mjs';
import { startBench, until } from './page.mjs';

/** Inches. */
const PAPER = { A4: { paperWidth: 8.27, paperHeight: 11.69 }, Letter: { paperWidth: 8.5, paperHeight: 11 } };
const PARCEL = [
  ['Focal length (fx)', '700'],
  ['Camera baseline (b)', '100'],
  ['Disparity (d)', '50'],
  ['Object width in image (w_img)', '150'],
  ['Object real width (w_real)', '0.3'],
];
const SIGMAS = ['2', '0.5', '0.5', '2', '0.01'];
const CURVE = 'Distance against disparity';
const TITLES = ['Stereo against monocular', 'Where the uncertainty comes from', CURVE, 'Top view'];

let bench;
before(async () => {
  bench = await startBench();
});
after(() => bench.close());

async function fillIn(page) {
  for (const [at, [name, value]] of PARCEL.entries()) {
    await page.fill(name, value);
    await page.fill(`Uncertainty of ${name}`, SIGMAS[at]);
  }
}

/** How many pages a PDF has. Chromium leaves the dictionaries of pages uncompressed. */
function pages(pdf) {
  return pdf.toString('latin1').match(/\/Type\s*\/Page\b(?!s)/g)?.length ?? 0;
}

/** What can be read of the report on paper. */
async function paper(page) {
  await page.engine.setMedia(page.driver, 'print');
  const text = await page.run("return document.getElementById('report').innerText");
  const others = await page.run(`
    const shown = [...document.querySelectorAll('#app, #accessible-mirror, #loading, #fatal, #update')].filter((one) => one.checkVisibility());
    return shown.map((one) => one.id)`);
  await page.engine.setMedia(page.driver, '');
  return { text, others };
}

it('a chart is downloaded as a PNG of its own size, without its menu', { engines: ONE_ENGINE }, async (test) => {
  const folder = await mkdtemp(path.join(os.tmpdir(), 'depth-calculator-'));
  try {
    const page = await bench.page(test);
    await page.start();
    await page.engine.saveFilesIn(page.driver, folder);
    await fillIn(page);
    const chart = await page.element(CURVE, 'image');
    await page.run('arguments[0].scrollIntoView({ block: "nearest" })', chart);
    // Beside the point that can be moved, which is in the middle.
    const { x, y } = await page.middle(chart);
    await page.driver.actions().move({ x: x + 100, y: y + 40 }).contextClick().perform();
    await page.press('Save as PNG');
    const file = path.join(folder, 'distance-against-disparity.png');
    await until('the file', async () => (await readdir(folder)).includes(path.basename(file)));
    await page.says(/Saved among this browser's downloads, as “distance-against-disparity.png”/);
    const { width, height, data } = PNG.sync.read(await readFile(file));
    const box = await page.run('const { width, height } = arguments[0].getBoundingClientRect(); return { width, height }', chart);
    assert.ok(Math.abs(width - box.width) <= 1 && Math.abs(height - box.height) <= 1, `${width} × ${height}, drawn ${box.width} × ${box.height}`);
    const colors = new Set();
    for (let at = 0; at < data.length; at += 4) colors.add(data.readUInt32BE(at));
    assert.ok(colors.size > 20, `${colors.size} colors`);
    assert.deepEqual(await page.consoleProblems(), []);
  } finally {
    await rm(folder, { recursive: true });
  }
});

it('the report fits one page of A4 and one of Letter, and says what the screen says', { engines: ONE_ENGINE }, async (test) => {
  const page = await bench.page(test);
  await page.start();
  await fillIn(page);
  for (const [name, size] of Object.entries(PAPER)) {
    const pdf = await page.engine.print(page.driver, size);
    assert.equal(pages(pdf), 1, `pages of ${name}`);
  }
  const { text, others } = await paper(page);
  assert.deepEqual(others, [], 'seen on paper beside the report');
  for (const part of ['(1.400 ± 0.016)', '(1.400 ± 0.050)', '(1.400 ± 0.015)', 'Key input parameters and outputs', 'Estimated object width (pixels)', ...TITLES]) {
    assert.ok(text.includes(part), `"${part}" is not in:\n${text}`);
  }
  const link = await page.run("return document.querySelector('#report footer a').href");
  assert.equal(link.split('#')[0], page.server.url);
  assert.match(link, /#fx=700&sfx=2&b=100mm&sb=0\.5mm&d=50&sd=0\.5/);
  assert.ok(await page.run("return document.getElementById('app').checkVisibility()"), 'the program is seen again');
  assert.deepEqual(await page.consoleProblems(), []);
});

it('with nothing typed the form is printed, and what is missing', { engines: ONE_ENGINE }, async (test) => {
  const page = await bench.page(test);
  await page.start();
  assert.equal(pages(await page.engine.print(page.driver, PAPER.A4)), 1);
  const { text } = await paper(page);
  assert.match(text, /Focal length/);
  assert.match(text, /missing|Enter /i);
  assert.ok(!text.includes(CURVE), text);
});

it('what was typed last is on paper, and what cannot be read is said there', { engines: ONE_ENGINE }, async (test) => {
  const page = await bench.page(test);
  await page.start();
  await page.fill('Focal length (fx)', 'seven');
  await page.engine.print(page.driver, PAPER.A4);
  const { text } = await paper(page);
  assert.match(text, /seven/);
});

it('the key for printing is left to the browser', async (test) => {
  const page = await bench.page(test);
  await page.start();
  const [kept, heard] = await page.run(`
    let heard = '';
    // On its way to the element, as the program lets nothing come back from there.
    document.addEventListener('keydown', ({ key }) => { heard += key; }, true);
    const kept = [arguments[0], document.getElementById('app')].map((target) =>
      ['o', 'p', 'P'].map((key) => {
        const press = new KeyboardEvent('keydown', { key, code: 'Key' + key.toUpperCase(), ctrlKey: true, bubbles: true, cancelable: true });
        target.dispatchEvent(press);
        return key.toLowerCase() === 'p' && press.defaultPrevented;
      }),
    );
    return [kept.flat().includes(true), heard]`, await page.element('Reset', 'button'));
  assert.equal(kept, false);
  assert.equal(heard, 'o', 'a button of the program hears other keys; this one would print twice');
});
