// Calibration files in the page: dropped, chosen, pasted; and the second module that reads them, whatever happens to it.

import assert from 'node:assert/strict';
import { readdir, readFile } from 'node:fs/promises';
import path from 'node:path';
import { after, before, it, ONE_ENGINE, TWO_ENGINES } from './harness.mjs';
import { startBench, until } from './page.mjs';
import { settings } from './settings.mjs';

const FX = 'Focal length (fx)';
const BASELINE = 'Camera baseline (b)';
const DISPARITY = 'Disparity (d)';

/** 700 px and 10 cm: with 50 px of disparity the mug is 1.4 m away. */
const MIDDLEBURY = `cam0=[700 0 320; 0 700 240; 0 0 1]
cam1=[700 0 320; 0 700 240; 0 0 1]
doffs=0
baseline=100
width=640
height=480
`;
/** A file whose baseline has no unit: 120 of something. */
const OPENCV = `%YAML:1.0
---
P1: !!opencv-matrix
   rows: 3
   cols: 4
   dt: d
   data: [ 700., 0., 320., 0., 0., 700., 240., 0., 0., 0., 1., 0. ]
P2: !!opencv-matrix
   rows: 3
   cols: 4
   dt: d
   data: [ 700., 0., 320., -84000., 0., 700., 240., 0., 0., 0., 1., 0. ]
`;

/** The segment APP1 of a photograph (JPEG) with 26 mm in FocalLengthIn35mmFilm: TIFF, its directory, and that of EXIF with one tag. */
const EXIF = [
  ...[0xff, 0xe1, 0, 52, ...Buffer.from('Exif\0\0')],
  ...[...Buffer.from('II*\0'), 8, 0, 0, 0],
  ...[1, 0, 0x69, 0x87, 4, 0, 1, 0, 0, 0, 26, 0, 0, 0, 0, 0, 0, 0],
  ...[1, 0, 0x05, 0xa4, 3, 0, 1, 0, 0, 0, 26, 0, 0, 0, 0, 0, 0, 0],
];
/** Its size: 3024 rows of 4032 columns, one channel. */
const SIZE = [0xff, 0xc0, 0, 11, 8, 0x0b, 0xd0, 0x0f, 0xc0, 1, 1, 0x11, 0];

let bench;
before(async () => {
  bench = await startBench();
});
after(() => bench.close());

/** Drags files, as names and texts, to the middle of the window: `types` are the events that this is. */
async function drag(page, types, files) {
  await page.run(
    `const transfer = new DataTransfer();
     for (const [name, text] of arguments[0]) transfer.items.add(new File([text], name));
     for (const type of arguments[1]) {
       const target = document.elementFromPoint(innerWidth / 2, innerHeight / 2);
       target.dispatchEvent(new DragEvent(type, { bubbles: true, cancelable: true, dataTransfer: transfer }));
     }`,
    files,
    types,
  );
}

/** Drops files, as names and texts, in the middle of the window. */
const drop = (page, ...files) => drag(page, ['dragenter', 'dragover', 'drop'], files);

async function isDisabled(page, button) {
  const element = await page.element(button, 'button');
  return page.run("return arguments[0].getAttribute('aria-disabled') === 'true' || arguments[0].disabled === true", element);
}

/** The page, with 50 px typed into the disparity. */
async function started(test) {
  const page = await bench.page(test);
  await page.start();
  await page.fill(DISPARITY, '50');
  return page;
}

it('a file that is dropped is shown, then used, and the distance follows', async (test) => {
  const page = await started(test);
  const dragged = ['whatever.bin', MIDDLEBURY];
  await drag(page, ['dragenter', 'dragover'], [dragged]);
  await page.says(/Drop calibration files, or saved rigs, to read them/);
  await drag(page, ['dragover', 'drop'], [dragged]);
  await page.says(/whatever\.bin: a calib\.txt of Middlebury/);
  assert.match(await page.text(), /line 4/, 'where the baseline stands');
  assert.match(await page.text(), /nothing → 700 px/, 'nothing is applied before it is asked for');
  await page.press('Use in calculator');
  await until('the focal length', async () => (await page.value(FX)) === '700');
  assert.equal(await page.value(BASELINE), '100');
  await page.says(/1\.400 m/);
  await page.press('Undo');
  await until('the form as it was', async () => (await page.value(FX)) === '');
  await page.press('Rigs');
  await page.says(/whatever/);
  await page.reload();
  await page.says(/whatever/);
});

it('a photograph is opened by its head, however large it is', async (test) => {
  const page = await started(test);
  await page.run(
    `const transfer = new DataTransfer();
     const [head, rest] = arguments;
     transfer.items.add(new File([new Uint8Array(head), new Uint8Array(rest)], 'mug.jpg'));
     document.body.dispatchEvent(new DragEvent('drop', { bubbles: true, cancelable: true, dataTransfer: transfer }));`,
    [0xff, 0xd8, ...EXIF, ...SIZE],
    17 << 20,
  );
  await page.says(/mug\.jpg: a photograph with EXIF/);
  await page.says(/nothing → 3028\.66307139 ± \d/);
  await page.press('Use in calculator');
  await until('the focal length', async () => (await page.value(FX)) === '3028.66307139');
});

it('the unit that a file does not say is asked for', { engines: TWO_ENGINES }, async (test) => {
  const page = await started(test);
  await drop(page, ['extrinsics.yml', OPENCV]);
  await page.says(/Which is it\?/);
  assert.equal(await isDisabled(page, 'Use in calculator'), true);
  await page.press('The baseline is');
  await page.press('120 mm');
  await until('the button', async () => !(await isDisabled(page, 'Use in calculator')));
  await page.press('Use in calculator');
  await until('the baseline', async () => (await page.value(BASELINE)) === '120');
});

it('what cannot be read says why and changes nothing, and the text of a file can be pasted', { engines: TWO_ENGINES }, async (test) => {
  const page = await started(test);
  await page.press('Rigs');
  await page.press('Calibration file…');
  await page.says(/Or paste the text of one/);
  await drop(page, ['page.conf', '<!DOCTYPE html><html><body>404</body></html>']);
  await page.says(/a web page, not a calibration/);
  await page.says(/Nothing was changed/);
  await page.press('Cancel');
  await page.press('Calculator');
  assert.equal(await page.value(DISPARITY), '50');
  assert.equal(await page.value(FX), '');
  await page.press('Rigs');
  await page.press('Calibration file…');
  const field = await page.field('Or paste the text of one');
  // As a browser does it with what is pasted.
  await page.run(
    "arguments[0].focus(); arguments[0].value = arguments[1]; arguments[0].dispatchEvent(new InputEvent('input', { bubbles: true, inputType: 'insertFromPaste' }))",
    field,
    MIDDLEBURY,
  );
  await until('the text in the field', async () => /baseline=100/.test(await page.value('Or paste the text of one')));
  await until('the button', async () => !(await isDisabled(page, 'Read the text')));
  await page.press('Read the text');
  await page.says(/pasted text: a calib\.txt of Middlebury/);
});

it('files that are chosen are read together', { engines: TWO_ENGINES }, async (test) => {
  const page = await started(test);
  await page.press('Rigs');
  await page.press('Calibration file…');
  // Nobody sees the dialog of the browser: what it would give is put into the input that belongs to it.
  await page.run("HTMLInputElement.prototype.click = () => { document.body.dataset.asked = 'yes' }");
  await page.press('Open files…');
  await until('the input', () => page.run("return document.getElementById('calibration-files') !== null"));
  const camera = (name, tx) => `image_width: 640
image_height: 480
camera_name: ${name}
camera_matrix: {rows: 3, cols: 3, data: [700., 0., 320., 0., 700., 240., 0., 0., 1.]}
distortion_model: plumb_bob
distortion_coefficients: {rows: 1, cols: 5, data: [0., 0., 0., 0., 0.]}
rectification_matrix: {rows: 3, cols: 3, data: [1., 0., 0., 0., 1., 0., 0., 0., 1.]}
projection_matrix: {rows: 3, cols: 4, data: [700., 0., 320., ${tx}, 0., 700., 240., 0., 0., 0., 1., 0.]}
`;
  await page.run(
    `const transfer = new DataTransfer();
     for (const [name, text] of arguments[0]) transfer.items.add(new File([text], name));
     const input = document.getElementById('calibration-files');
     input.files = transfer.files;
     input.dispatchEvent(new Event('change', { bubbles: true }));`,
    [
      ['left.yaml', camera('left', 0)],
      ['right.yaml', camera('right', -70)],
    ],
  );
  await page.says(/left\.yaml, right\.yaml: /);
  await page.press('Use in calculator');
  await page.says(/1\.400 m/);
});

/** How long the page takes from a drop until it says something, in milliseconds. */
async function timed(page, pattern, ...files) {
  await page.run(
    `const start = performance.now();
     delete document.body.dataset.took;
     const observer = new MutationObserver(() => {
       if (!new RegExp(arguments[0]).test(document.body.innerText)) return;
       document.body.dataset.took = String(Math.round(performance.now() - start));
       observer.disconnect();
     });
     observer.observe(document.body, { childList: true, subtree: true, characterData: true });`,
    pattern,
  );
  await drop(page, ...files);
  return until('the answer', () => page.run('return document.body.dataset.took'));
}

it('says how long it takes from a drop to the answer', async (test) => {
  const page = await started(test);
  const first = await timed(page, 'one\\.txt: a calib', ['one.txt', MIDDLEBURY]);
  const again = await timed(page, 'two\\.txt: a calib', ['two.txt', MIDDLEBURY]);
  test.diagnostic(`from the drop to the answer: ${first} ms with the second module to load, then ${again} ms`);
  assert.ok(Number(first) > 0 && Number(again) > 0);
});

/** Has the page ask the server for what it loads next. */
const withoutKeptFiles = (page) => page.run('return navigator.serviceWorker?.getRegistration().then((kept) => kept?.unregister())');

/** What happens to the second module, by the beginnings of what its files are called, and what is then said. */
const FAULTS = [
  ['is not there', 'worker-', () => undefined, /could not be loaded/],
  ['is no script', 'worker-', () => 'This is not a script.', /could not be loaded/],
  ['is of another build', 'worker-', () => "postMessage(['{\"Ready\":{\"protocol\":0}}'])", /of another version/],
  ['stops', 'worker-', () => "postMessage(['{\"Ready\":{\"protocol\":1}}']); onmessage = () => { throw new Error('a trap') }", /stopped because of an error/],
  ['runs out of memory', 'worker-', () => "postMessage(['{\"Ready\":{\"protocol\":1}}']); onmessage = () => new ArrayBuffer(2 ** 53)", /stopped because of an error/],
];

for (const [what, begins, make, said] of FAULTS) {
  it(`a second module that ${what} harms nothing, and the next file gets a new one`, async (test) => {
    const page = await started(test);
    // As the page asks for it: a worker of kept files would be the right one.
    await withoutKeptFiles(page);
    const name = await page.run("return document.querySelector('meta[name=worker]').content");
    assert.ok(name.startsWith(begins), name);
    const right = await readFile(path.join(settings.dist, name), 'utf8');
    const broken = make();
    bench.server.state.added.set(name, broken ?? '');
    if (broken === undefined) await page.run("document.querySelector('meta[name=worker]').content = 'gone.js'");
    await drop(page, ['calib.txt', MIDDLEBURY]);
    await page.says(said);
    assert.equal(await page.failure(), '', 'the page itself runs');
    bench.server.state.added.set(name, right);
    if (broken === undefined) await page.run("document.querySelector('meta[name=worker]').content = arguments[0]", name);
    await drop(page, ['calib.txt', MIDDLEBURY]);
    await page.press('Use in calculator');
    await page.says(/1\.400 m/);
  });
}

it('a second module that does not answer is given up', async (test) => {
  const page = await started(test);
  const name = await page.run("return document.querySelector('meta[name=worker]').content");
  bench.server.state.added.set(name, "postMessage(['{\"Ready\":{\"protocol\":1}}']); onmessage = () => { for (;;); }");
  await withoutKeptFiles(page);
  await drop(page, ['calib.txt', MIDDLEBURY]);
  await page.says(/Reading calib\.txt/);
  // Who closes the tab meanwhile, and comes back, finds what was typed.
  await page.reload();
  await withoutKeptFiles(page);
  assert.equal(await page.value(DISPARITY), '50');
  await drop(page, ['calib.txt', MIDDLEBURY]);
  await page.says(/Reading calib\.txt/);
  await page.press('Cancel');
  await until('the dialog gone', async () => !/Reading calib\.txt/.test(await page.text()));
  bench.server.state.added.set(name, await readFile(path.join(settings.dist, name), 'utf8'));
  await drop(page, ['calib.txt', MIDDLEBURY]);
  await page.press('Use in calculator');
  await page.says(/1\.400 m/);
});

it('the second module is asked for at the first file, kept then, and there without a network', { engines: ONE_ENGINE }, async (test) => {
  const page = await started(test);
  const asked = () => page.run("return performance.getEntriesByType('resource').some((entry) => /depth-worker|worker-/.test(entry.name))");
  const isKept = () =>
    page.run(`return caches.keys().then(async (names) => {
      for (const name of names) for (const request of await (await caches.open(name)).keys()) if (/depth-worker.*wasm$/.test(request.url)) return true;
      return false;
    })`);
  await until('the service worker', () =>
    page.run("return navigator.serviceWorker.getRegistration().then((kept) => kept?.active?.state === 'activated')"),
  );
  await page.reload();
  assert.equal(await asked(), false);
  assert.equal(await isKept(), false);
  await drop(page, ['calib.txt', MIDDLEBURY]);
  await page.says(/calib\.txt of Middlebury/);
  await until('the module among what is kept', isKept);
  // From now on the host has none of it.
  const name = await page.run("return document.querySelector('meta[name=worker]').content");
  for (const file of await readdir(settings.dist)) if (file === name || /^depth-worker/.test(file)) bench.server.state.added.set(file, '');
  await page.reload();
  await drop(page, ['calib.txt', MIDDLEBURY]);
  await page.says(/calib\.txt of Middlebury/);
});
