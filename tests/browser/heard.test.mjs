// What somebody hears who does not see the page: nothing while they type, each thing once, an answer to every action, and the focus
// where it was left. `cargo xtask speech` lets a screen reader say it.

import assert from 'node:assert/strict';
import { after, before, it, TWO_ENGINES } from './harness.mjs';
import { Key, startBench, until } from './page.mjs';

const MIRROR = '#accessible-mirror';
const [FX, B, D] = ['Focal length (fx)', 'Camera baseline (b)', 'Disparity (d)'];
const [WIDTH, REAL] = ['Object width in image (w_img)', 'Object real width (w_real)'];
/** So long nothing is typed before a mistake is called one (crates/egui-mirror/src/web/announcer.rs), less what clocks are rounded by. */
const PAUSE_MS = 400 - 5;

let bench;
before(async () => {
  bench = await startBench();
});
after(() => bench.close());

/** What is noted in the page, one line each. */
const NOTE = `
  const { dataset } = document.body;
  dataset.noted = '[]';
  const note = (one) => (dataset.noted = JSON.stringify([...JSON.parse(dataset.noted), one]));`;
const noted = (page) => page.run('return JSON.parse(document.body.dataset.noted)');
const forget = (page) => page.run("document.body.dataset.noted = '[]'");

/** Notes whatever a field with the focus says anew of itself, with how long before it the last key was. */
const WATCH_THE_FIELD = `${NOTE}
  let last = 0;
  for (const name of ['keydown', 'input']) addEventListener(name, () => (last = performance.now()), true);
  const look = (all) => {
    for (const { target, attributeName } of all) {
      const field = document.activeElement;
      const about = (target.closest ?? target.parentElement?.closest)?.call(target.closest ? target : target.parentElement, '[id]');
      const isAbout = about !== null && about !== undefined && (field.getAttribute('aria-describedby') ?? '').split(' ').includes(about.id);
      if (field.localName !== 'input' || (target !== field && !isAbout)) continue;
      note({ what: attributeName ?? 'description', now: attributeName && field.getAttribute(attributeName), sinceMs: performance.now() - last, value: field.value });
    }
  };
  const all = { attributeFilter: ['aria-describedby', 'aria-invalid'], childList: true, characterData: true, subtree: true };
  new MutationObserver(look).observe(document.body, all);`;

it('a field says nothing new of itself while it is typed in, and only that it is wrong once that has paused', async (test) => {
  const page = await bench.page(test);
  await page.start();
  await page.run(WATCH_THE_FIELD);
  const fill = async (name, text) => {
    const field = await page.field(name);
    await page.run('arguments[0].focus(); arguments[0].select()', field);
    await page.frames();
    await forget(page);
    await page.driver.actions().sendKeys(...text).perform();
    await until(`${text} in ${name}`, async () => (await page.value(name)) === text);
    return field;
  };
  for (const [name, text] of [
    [B, '100'],
    [FX, '700'],
    [D, '0.3'],
    [REAL, '0.05'],
  ]) {
    await fill(name, text);
    await page.frames();
    assert.deepEqual((await noted(page)).filter(({ what, sinceMs }) => what !== 'aria-invalid' || sinceMs < PAUSE_MS), [], `${text} into ${name}`);
  }
  // A mistake that stays is called one. What is wrong is said by a live region, not by a description that changes as well.
  const field = await fill(B, '-3');
  await until('the mistake', async () => (await field.getAttribute('aria-invalid')) === 'true');
  const changes = await noted(page);
  assert.deepEqual(changes.map(({ what, now, value }) => [what, now, value]), [['aria-invalid', 'true', '-3']]);
  assert.ok(changes[0].sinceMs >= PAUSE_MS, JSON.stringify(changes));
  // Whoever comes back to it is told.
  await page.run('arguments[0].focus()', await page.field(D));
  await until('the mistake in the description', async () => {
    const described = await page.run("return document.getElementById(arguments[0].getAttribute('aria-describedby')).textContent", field);
    return /has no sign/.test(described);
  });
});

/** Notes each message of the live regions, in order. */
const LISTEN = `${NOTE}
  for (const region of document.querySelectorAll('${MIRROR} [aria-live]')) {
    new MutationObserver(() => {
      const words = region.textContent.replaceAll('\\u{a0}', ' ').trim();
      if (words) note(words);
    }).observe(region, { childList: true, characterData: true, subtree: true });
  }`;

/** All that is said in answer to something until `last` is. A slow machine may say it in several messages. */
async function answer(page, act, last) {
  await forget(page);
  await act();
  const said = async () => (await noted(page)).join(' ');
  await until(`${last} aloud`, async () => last.test(await said()));
  return said();
}

it('each thing is said once, in order, and every action answers', async (test) => {
  const page = await bench.page(test);
  await page.start();
  await page.run(LISTEN);
  const press = (name) => () => page.press(name);
  const fill = (name, text) => () => page.fill(name, text);
  const MISSING = 'The baseline is missing for the stereo distance. Type a number above zero, such as 100 mm.';
  const NEGATIVE =
    'A negative disparity usually means that the left and the right image are swapped, or the upper and the lower one. Swap them, or type it without the minus.';

  assert.equal(await answer(page, press('Coffee mug (stereo)'), /filled in/), 'Stereo: 1.400 m. The example is filled in.');
  // With nothing new, the distances again, however often.
  for (let times = 0; times < 2; times += 1) assert.equal(await answer(page, press('Calculate Distance'), /Stereo/), 'Stereo: 1.400 m.');
  await page.fill(WIDTH, '150');
  // What has not changed is not said again.
  assert.equal(await answer(page, fill(REAL, '0.30'), /Combined/), 'Monocular: 1.400 m. Combined: needs ± in both.');
  assert.equal(await answer(page, fill(D, '-3'), /negative/), NEGATIVE);
  for (let times = 0; times < 2; times += 1) assert.equal(await answer(page, () => page.type(Key.ENTER), /negative/), NEGATIVE);
  assert.equal(await answer(page, fill(D, '50'), /Combined/), 'Stereo: 1.400 m. Combined: needs ± in both.');
  await page.run('arguments[0].focus(); arguments[0].select()', await page.field(B));
  await page.type(Key.BACK_SPACE);
  for (let times = 0; times < 2; times += 1) assert.equal(await answer(page, () => page.type(Key.ENTER), /missing/), MISSING);
  // How two distances agree comes with them.
  assert.equal(await answer(page, fill(B, '1'), /Combined/), 'Stereo: 0.1400 m. Combined, disagree: Monocular is 10 times as far.');
  assert.equal(await answer(page, press('Reset'), /cleared/), 'All fields are cleared.');
  assert.equal(await answer(page, press('Learn'), /Learn/), 'Learn.');
  assert.match(await answer(page, press('Keys'), /This list/), /^Keys\. What they do\. Tab, Shift \+ Tab: Next field .* \?: This list\.$/);
});

/** The name of what has the keyboard. */
const FOCUSED = `
  const one = document.activeElement;
  if (one === document.body || one.localName === 'canvas') return one.localName;
  const labels = (one.getAttribute('aria-labelledby') ?? '').split(' ').map((id) => document.getElementById(id)?.textContent).join(' ');
  return (one.getAttribute('aria-label') || labels.trim() || one.textContent).trim();`;

it('the screens are named, and Back and Forward go between them', async (test) => {
  const page = await bench.page(test);
  await page.start();
  const shows = async (title) => {
    await until(`the title ${title}`, async () => (await page.driver.getTitle()) === title);
    await until('one heading of the first level', () => page.run(`return document.querySelectorAll('${MIRROR} h1').length === 1`));
  };
  await shows('Depth Calculator');
  await page.run('arguments[0].focus()', await page.field(FX));
  // From a field that is not there any more.
  await page.driver.actions().keyDown(Key.ALT).sendKeys('3').keyUp(Key.ALT).perform();
  await shows('Learn – Depth Calculator');
  await until('the focus on the tab of the screen', async () => (await page.run(FOCUSED)) === 'Learn');
  await page.driver.navigate().back();
  await shows('Depth Calculator');
  assert.equal(await page.value(FX), '', 'the key wrote nothing');
  await page.driver.navigate().forward();
  await shows('Learn – Depth Calculator');
  await page.driver.navigate().back();
  await shows('Depth Calculator');
});

it('the page starts, and is reloaded, with the focus in its first field', async (test) => {
  const page = await bench.page(test);
  await page.start();
  for (let times = 0; times < 2; times += 1) {
    await until('the focus', async () => (await page.run(FOCUSED)) === FX);
    assert.equal(await page.run('return document.activeElement.localName'), 'input');
    await page.reload();
  }
});

/** The buttons and keys that are pressed one after the other on a fresh page, and the name of what has the focus then. */
const ACTIONS = [
  [['Coffee mug (stereo)'], 'Coffee mug (stereo)'],
  [['Range, tilt, zero point'], 'Range, tilt, zero point'],
  [['Range, tilt, zero point', 'Range, tilt, zero point'], 'Range, tilt, zero point'],
  [['Calculate Distance'], FX],
  [['Coffee mug (stereo)', 'Calculate Distance'], 'Calculate Distance'],
  [['Coffee mug (stereo)', 'Reset'], 'Reset'],
  [['Ground plane'], 'Ground plane'],
  [['Another quantity'], 'Another quantity'],
  [['Focal length (fx): go to the field'], FX],
  [['Unit of Camera baseline (b)'], 'mm  (millimeters)'],
  [['Unit of Camera baseline (b)', Key.ARROW_DOWN, Key.ENTER], 'Unit of Camera baseline (b)'],
  [['From lens, FOV or Q…'], 'What is known'],
  [['OpenCV × 16, doffs…', 'Cancel'], 'OpenCV × 16, doffs…'],
  [['More ways'], 'Two photographs and a step'],
  [['More ways', 'Two photographs and a step'], 'More ways: Two photographs and a step'],
  [['Light or dark', 'Dark'], 'Light or dark'],
  [['Keys'], 'Close'],
  [['Keys', 'Close'], 'Keys'],
  [['Keys', 'About Depth Calculator', 'Close'], 'Keys'],
  [['Learn'], 'Learn'],
];

/** Notes each time that the browser has taken the focus nowhere. */
const WATCH_THE_FOCUS = `${NOTE}
  document.addEventListener('focusout', ({ target, relatedTarget }) => {
    if (relatedTarget === null) note('from ' + (target.getAttribute('aria-label') || target.textContent));
    else if (relatedTarget.localName === 'canvas') note('to the canvas');
  });`;

it('the focus stays where an action left it, or goes to what it opened, and is never nowhere', { engines: TWO_ENGINES }, async (test) => {
  const page = await bench.page(test);
  for (const [presses, expected] of ACTIONS) {
    await page.start();
    await page.run(WATCH_THE_FOCUS);
    for (const name of presses) {
      const isKey = Object.values(Key).includes(name);
      if (!isKey) await page.run('arguments[0].focus()', await page.element(name, 'button', 'tab', 'radio', 'link', 'choice'));
      await page.frames();
      await page.type(isKey ? name : Key.ENTER);
    }
    let now = '';
    await until(`the focus on ${expected} after ${presses}, not on ${now}`, async () => (now = await page.run(FOCUSED)) === expected);
    assert.deepEqual(await noted(page), [], `${presses}`);
    await page.run('localStorage.clear(); sessionStorage.clear()');
  }
});
