// What may go wrong around the program: each is said in a sentence, and nothing that was entered is lost by it.

import assert from 'node:assert/strict';
import { after, before, it, ONE_ENGINE } from './harness.mjs';
import { Key, startBench, STORAGE_KEY, until } from './page.mjs';

const FX = 'Focal length (fx)';
const BASELINE = 'Camera baseline (b)';
const DISPARITY = 'Disparity (d)';

let bench;
before(async () => {
  bench = await startBench();
});
after(() => bench.close());

async function fillMug(page) {
  await page.fill(FX, '700');
  await page.fill(BASELINE, '100');
  await page.fill(DISPARITY, '50');
  await page.says(/1\.373…1\.429 m/);
}

async function mugIsStored(page) {
  await until('the inputs in the storage', async () => {
    const text = await page.stored();
    return ['"700"', '"100"', '"50"'].every((value) => text?.includes(value));
  });
}

it('lost graphics lose nothing that was entered', async (test) => {
  const page = await bench.page(test);
  await page.start();
  await fillMug(page);
  await mugIsStored(page);
  await page.loseGraphics();
  assert.match(await until('a message', () => page.failure()), /took the graphics away/);
  await page.startAgain('Reload');
  assert.equal(await page.value(FX), '700');
  assert.equal(await page.value(BASELINE), '100');
  assert.equal(await page.value(DISPARITY), '50');
  await page.says(/1\.373…1\.429 m/);
});

/** Tells the program that its window is none: eframe counts on one to ask for the time, and panics. */
async function panic(page) {
  await page.startsNoMore();
  const tab = await page.element('Learn', 'tab');
  await page.run('Object.defineProperty(Window, Symbol.hasInstance, { value: () => false }); arguments[0].click()', tab);
}

it('a panic is said, and a reload brings back what was entered', async (test) => {
  const page = await bench.page(test);
  await page.start();
  await fillMug(page);
  await mugIsStored(page);
  await panic(page);
  assert.match(await until('a message', () => page.failure()), /stopped because of an error in it/);
  assert.match(await page.failure(), /panicked at/);
  await page.startAgain('Reload');
  assert.equal(await page.value(FX), '700');
  await page.says(/1\.373…1\.429 m/);
});

it('a program that is ended while the page is left is not started there, and is there again for who comes back', async (test) => {
  const page = await bench.page(test);
  await page.start();
  await fillMug(page);
  await mugIsStored(page);
  // As Firefox does where a script runs when somebody follows a link: what the program had locked stays locked, and it says so.
  await page.run(
    "dispatchEvent(new PageTransitionEvent('pagehide', { persisted: true })); dispatchEvent(new CustomEvent('program-failed', { detail: ['It stopped.', 'Reload.', 'A lock.'] }))",
  );
  assert.equal(await page.failure(), '');
  assert.equal(await page.whyStartedAgain(), null);
  await page.renew("dispatchEvent(new PageTransitionEvent('pageshow', { persisted: true }))");
  assert.equal(await page.value(FX), '700');
  await page.says(/1\.373…1\.429 m/);
});

it('what is stored need not be read again if it may be why the program stops', async (test) => {
  const page = await bench.page(test);
  await page.start();
  await fillMug(page);
  await mugIsStored(page);
  await page.reload();
  await panic(page);
  await until('a message', () => page.failure());
  await page.startAgain('Start with an empty form');
  assert.equal(await page.value(FX), '');
  assert.match(await page.run(`return localStorage.getItem('${STORAGE_KEY}/set aside')`), /"700"/, 'nothing is thrown away');
  await page.reload();
  assert.equal(await page.value(FX), '', 'nor does it come back');
});

it('what cannot be read is set aside, its place is named, and nothing that was set aside is overwritten', async (test) => {
  const page = await bench.page(test);
  for (const [text, key] of [['not a state', `${STORAGE_KEY}/set aside`], ['another', `${STORAGE_KEY}/set aside 2`]]) {
    await page.store(text);
    await page.start();
    await page.says(new RegExp(`starts fresh\\. The old text is kept in this browser's storage, under the key “${key}”\\.`));
    assert.equal(await page.run('return localStorage.getItem(arguments[0])', key), text);
    assert.equal(await page.stored(), null, 'moved, so that a reload does not set it aside again');
  }
  await fillMug(page);
  await mugIsStored(page);
  await page.reload();
  await panic(page);
  await until('a message', () => page.failure());
  await page.startAgain('Start with an empty form');
  assert.match(await page.run('return localStorage.getItem(arguments[0])', `${STORAGE_KEY}/set aside 3`), /"700"/);
  assert.equal(await page.run('return localStorage.getItem(arguments[0])', `${STORAGE_KEY}/set aside`), 'not a state');
});

const REFUSALS = [
  {
    title: 'a storage that may not even be looked at',
    script:
      "Object.defineProperty(globalThis, 'localStorage', { configurable: true, get() { throw new DOMException('Access is denied for this document.', 'SecurityError'); } });",
    says: /does not let the page store anything: Access is denied.*forgets what you enter/s,
  },
  {
    title: 'a storage that cannot be read',
    script: "Storage.prototype.getItem = () => { throw new DOMException('The disk is broken.', 'UnknownError'); };",
    says: /does not let the page read what it stored: The disk is broken/,
  },
  {
    title: 'a browser without storage',
    script: "Object.defineProperty(globalThis, 'localStorage', { configurable: true, get: () => null });",
    says: /has no storage for pages/,
  },
];

for (const { title, script, says } of REFUSALS) {
  it(`${title} is said, and the program works`, { engines: ONE_ENGINE }, async (test) => {
    const page = await bench.page(test);
    await page.runBefore(script);
    await page.start();
    await page.says(says);
    await fillMug(page);
    assert.equal(await page.failure(), '');
  });
}

it('a full storage is said, and the program works', async (test) => {
  const page = await bench.page(test);
  await page.start();
  const filled = await page.run(`
    let size = 1 << 20;
    for (let piece = 0; size >= 1; ) {
      try { localStorage.setItem('filler' + piece, 'x'.repeat(size)); piece += 1; } catch { size >>= 1; }
    }
    try { localStorage.setItem('one more', 'value'); return false; } catch { return true; }`);
  assert.ok(filled, 'the storage is full');
  await page.fill(FX, '700');
  await page.says(/could not store your inputs: .+\. What you enter now may be gone after a restart/s);
  await page.fill(BASELINE, '100');
  await page.fill(DISPARITY, '50');
  await page.says(/1\.373…1\.429 m/);

  // What is typed once there is room again is kept.
  await page.run("for (const name of Object.keys(localStorage)) if (name.startsWith('filler')) localStorage.removeItem(name)");
  await page.fill(DISPARITY, '100');
  await page.says(/0\.700/);
  await page.reload();
  assert.equal(await page.value(DISPARITY), '100');
  assert.equal(await page.value(FX), '700');
});

it('a clipboard that refuses is said', { engines: ONE_ENGINE }, async (test) => {
  const page = await bench.page(test);
  await page.start();
  await page.press('Coffee mug (stereo)');
  await page.says(/1\.373…1\.429 m/);
  await page.run("Clipboard.prototype.writeText = () => Promise.reject(new DOMException('Write permission denied.', 'NotAllowedError'))");
  await page.press('Copy Results');
  await page.says(/refused to copy: Write permission denied\./);
  assert.doesNotMatch(await page.text(), /Copied to the clipboard/);
});

it('what is copied is copied while the browser handles the click, as Safari demands', async (test) => {
  const page = await bench.page(test);
  await page.start();
  await page.press('Coffee mug (stereo)');
  await page.says(/1\.373…1\.429 m/);
  // A browser knows the event that is being handled; in the next frame there is none.
  await page.run("Clipboard.prototype.writeText = (text) => { document.body.dataset.copied = `${window.event?.type}: ${text}`; return Promise.resolve(); }");
  const copied = () => until('the copy', () => page.run("const { dataset } = document.body; const { copied } = dataset; delete dataset.copied; return copied"));
  await page.press('Copy Results');
  assert.match(await copied(), /^click: .*1\.400 m/s);
  await page.says(/Copied to the clipboard/);
  await page.run('arguments[0].focus()', await page.element('Copy Results', 'button'));
  await page.type(Key.ENTER);
  assert.match(await copied(), /^click: .*1\.400 m/s);
  await page.point('Copy Results');
  assert.match(await copied(), /^pointerup: .*1\.400 m/s);
});

it('a browser that gives the page no clipboard is told from one that refuses', { engines: ONE_ENGINE }, async (test) => {
  const page = await bench.page(test);
  await page.start();
  await page.press('Coffee mug (stereo)');
  await page.says(/1\.373…1\.429 m/);
  await page.run("Object.defineProperty(navigator, 'clipboard', { value: undefined })");
  await page.press('Copy Results');
  await page.says(/copies and pastes only on pages that arrive over https/);
});

it('two windows keep what is typed in each, and a new one starts with what was typed last', async (test) => {
  const page = await bench.page(test);
  await page.start();
  await page.fill(FX, '700');
  await until('the first in the storage', async () => (await page.stored())?.includes('"700"'));
  const first = await page.driver.getWindowHandle();

  await page.driver.switchTo().newWindow('window');
  const second = await page.driver.getWindowHandle();
  await page.start();
  assert.equal(await page.value(FX), '700', 'the second window starts with what the first has stored');
  await page.fill(FX, '950');
  await until('the second in the storage', async () => (await page.stored())?.includes('"950"'));

  await page.driver.switchTo().window(first);
  assert.equal(await page.value(FX), '700', 'nobody’s typing is replaced');
  await page.reload();
  assert.equal(await page.value(FX), '700', 'nor by a reload');
  await page.fill(BASELINE, '100');
  await until('the first in its own storage', async () => (await page.own())?.includes('"100"'));

  await page.driver.switchTo().window(second);
  await page.reload();
  assert.equal(await page.value(FX), '950');
  assert.equal(await page.value(BASELINE), '');

  await page.driver.switchTo().newWindow('window');
  await page.start();
  assert.equal(await page.value(FX), '700');
  assert.equal(await page.value(BASELINE), '100', 'the first was typed into last');
  assert.equal(await page.failure(), '');
});

it('a window in which nothing was typed keeps its empty form', async (test) => {
  const page = await bench.page(test);
  await page.start();
  const first = await page.driver.getWindowHandle();
  await page.driver.switchTo().newWindow('window');
  await page.start();
  await page.fill(FX, '950');
  await until('the second in the storage', async () => (await page.stored())?.includes('"950"'));
  await page.driver.switchTo().window(first);
  await page.reload();
  assert.equal(await page.value(FX), '');
});

/** eframe's own field, once the canvas has the keyboard. */
function fieldOfCanvas(page) {
  return until('the field of the canvas', () => page.run("const { activeElement: one } = document; return one.matches('canvas + input') ? one : null"));
}

/** Types into a field and does something more before the program has got a frame, all in one task of the browser. */
const TYPE_AND = "const [field, text] = arguments; field.focus(); field.value = text; field.dispatchEvent(new InputEvent('input', { bubbles: true, inputType: 'insertText', data: text }));";

it('what is typed in the moment in which the page is reloaded comes back', async (test) => {
  const page = await bench.page(test);
  await page.start();
  const typeAndReload = async (field, text) => {
    await page.renew(`${TYPE_AND} location.reload()`, field, text);
  };
  await typeAndReload(await page.field(FX), '700');
  assert.equal(await page.value(FX), '700');

  // And where the canvas has the keyboard: then eframe's own field has it.
  await page.point('Reset');
  await until('an empty form', async () => (await page.value(FX)) === '');
  await page.moveTo(await page.field(FX));
  await page.driver.actions().press().release().perform();
  const agent = await fieldOfCanvas(page);
  await typeAndReload(agent, '950');
  assert.equal(await page.value(FX), '950');
});

it('what is typed in the moment in which the page is hidden is stored at once', async (test) => {
  const page = await bench.page(test);
  await page.start();
  const HIDE = "Object.defineProperty(Document.prototype, 'hidden', { configurable: true, get: () => true }); document.dispatchEvent(new Event('visibilitychange'));";
  const hide = (field, text) => page.run(`const shown = Object.getOwnPropertyDescriptor(Document.prototype, 'hidden');
    ${TYPE_AND} ${HIDE} const texts = [sessionStorage, localStorage].map((storage) => storage.getItem('${STORAGE_KEY}'));
    Object.defineProperty(Document.prototype, 'hidden', shown); document.dispatchEvent(new Event('visibilitychange')); return texts`, field, text);
  for (const text of await hide(await page.field(FX), '700')) assert.match(text, /"700"/);
  await page.frames();
  assert.equal(await page.value(FX), '700');

  await page.moveTo(await page.field(DISPARITY));
  await page.driver.actions().press().release().perform();
  const agent = await fieldOfCanvas(page);
  for (const text of await hide(agent, '50')) assert.match(text, /"50"/);
  // The program goes on as if nothing had been.
  await page.type('0');
  await until('both keys', async () => (await page.value(DISPARITY)) === '500');
});

it('a store that is cleared while the program runs is written again', async (test) => {
  const page = await bench.page(test);
  await page.start();
  await page.fill(FX, '700');
  await until('the inputs in the storage', () => page.stored());
  await page.run('localStorage.removeItem(arguments[0])', STORAGE_KEY);
  await page.fill(BASELINE, '100');
  await until('the inputs in the storage again', async () => (await page.stored())?.includes('"700"'));
});
