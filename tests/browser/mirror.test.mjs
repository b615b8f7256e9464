// The mirror in a real browser: what assistive technology is told of it, and that nothing stale is in it after a long random walk.
// What it has to say of each screen is tested without a browser, in tests/mirror.rs.
// Longer than a file should be, as everything in it walks through the same pages with the same helpers.

import assert from 'node:assert/strict';
import { after, before, it, TWO_ENGINES, unless } from './harness.mjs';
import { Pointer } from 'selenium-webdriver/lib/input.js';
import { Key, startBench, until } from './page.mjs';
import { settings } from './settings.mjs';

const MIRROR = '#accessible-mirror';
const { seed: SEED, batches: BATCHES } = settings;
const STEPS = 8;
/** How often the screen is left and shown anew, which takes seconds. */
const BATCHES_A_LOOK = 5;
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

/** The role that an element has by itself to a browser (HTML-AAM 1.0). Others have none, or say theirs. */
const ROLES = {
  a: 'link',
  article: 'article',
  aside: 'complementary',
  button: 'button',
  'input checkbox': 'checkbox',
  'input radio': 'radio',
  'input range': 'slider',
  'input text': 'textbox',
  h1: 'heading',
  h2: 'heading',
  h3: 'heading',
  h4: 'heading',
  main: 'main',
  nav: 'navigation',
  textarea: 'textbox',
};
/** How engines call these roles. */
const CALLED = { '': ['', 'generic', 'none', 'StaticText'], img: ['img', 'image'] };

/** What each element of the mirror says it is, and where it is to lie: as far from the canvas as it and what is around it say. */
const SAID = `
  const around = document.querySelector('canvas').getBoundingClientRect();
  const labels = (one) => (one.getAttribute('aria-labelledby') ?? '').split(' ').map((id) => document.getElementById(id)?.textContent).join(' ');
  return [...document.querySelectorAll('${MIRROR} [id]')].map((one) => {
    let [left, top] = [0, 0];
    for (let at = one; at.id; at = at.parentElement) {
      left += parseFloat(at.style.left);
      top += parseFloat(at.style.top);
    }
    const box = one.getBoundingClientRect();
    const { width, height } = one.style;
    return {
      element: one,
      tag: [one.localName, one.localName === 'input' ? one.type : ''].join(' ').trim(),
      role: one.getAttribute('role'),
      name: one.getAttribute('aria-label') ?? labels(one),
      content: one.firstElementChild ? '' : one.textContent,
      isShutOut: one.closest('[inert]') !== null,
      isInDialog: one.closest('[role=dialog]') !== null,
      distances: [box.left - around.left - left, box.top - around.top - top, box.width - parseFloat(width), box.height - parseFloat(height)],
    };
  });`;

const words = (text) => text.replaceAll('\u{a0}', ' ').replaceAll(/\s+/g, ' ').trim();

/** Where what the browser tells assistive technology is not what the elements say. One line for each. */
async function differences(page) {
  const found = [];
  const all = await page.run(SAID);
  if (all.length < 30) found.push(`only ${all.length} elements`);
  const hasDialog = all.some(({ isInDialog }) => isInDialog);
  for (const { element, tag, role, name, content, isShutOut, isInDialog, distances } of all) {
    const what = `${tag} "${name || content}"`;
    if (isShutOut !== (hasDialog && !isInDialog)) found.push(`${what} is ${isShutOut ? '' : 'not '}shut out`);
    if (distances.some((distance) => Math.abs(distance) > 0.01)) found.push(`${what} lies elsewhere, by ${distances}`);
    if (isShutOut) continue;
    const expected = role ?? ROLES[tag] ?? '';
    const computed = await element.getAriaRole();
    if (!(CALLED[expected] ?? [expected]).includes(computed)) found.push(`${what} has the role "${computed}" instead of "${expected}"`);
    // Other roles are not named by what is in them, or are rows and cells of words that are looked at for themselves.
    const isNamed = name || /^(button|cell|columnheader|heading|link|menuitem|menuitemcheckbox|option|rowheader|tab)$/.test(expected);
    if (isNamed && (name || content) && words(await element.getAccessibleName()) !== words(name || content)) {
      found.push(`${what} has the name "${await element.getAccessibleName()}"`);
    }
  }
  return found;
}

it('what assistive technology is told is what the mirror says, at the place that it says', async (test) => {
  const page = await bench.page(test);
  await page.start();
  const look = async (where) => {
    // An element that goes meanwhile could not be asked.
    await settled(page);
    assert.deepEqual(await differences(page), [], where);
  };
  await page.press('Coffee mug (stereo)');
  await page.says(/1\.373…1\.429 m/);
  await page.fill('Uncertainty of Disparity (d)', '0.5');
  await page.fill('Camera baseline (b)', 'ten');
  await look('the calculator with a mistake');
  await page.press('Unit of Camera baseline (b)');
  await look('an open list');
  assert.equal(await (await page.driver.findElement({ css: `${MIRROR} [role=listbox]` })).getAccessibleName(), 'Unit of Camera baseline (b)');
  await page.type(Key.ESCAPE);
  await page.press('OpenCV × 16, doffs…');
  await look('a dialog');
  await page.press('Cancel');
  await page.show('Learn');
  await look('the explanations');
});

/** Closes one list, menu or dialog, as Escape does. Returns whether there was one. */
const CLOSE = `
  const open = [...document.querySelectorAll('${MIRROR} :is([role=dialog], [role=listbox], [role=menu])')].pop();
  const one = open?.querySelector('button, input, a');
  one?.focus();
  one?.dispatchEvent(new KeyboardEvent('keydown', { key: 'Escape', code: 'Escape', bubbles: true, cancelable: true }));
  return open !== undefined;`;

/** All that the browser holds of the mirror, one line for each element, and how many of them are newer than the last look. */
const HELD = `
  let made = 0;
  const depth = (one) => (one.id === 'accessible-mirror' ? 0 : 1 + depth(one.parentElement));
  const lines = [...document.querySelectorAll('${MIRROR} [id]')].map((one) => {
    made += one.wasSeen ? 0 : 1;
    one.wasSeen = true;
    const attributes = [...one.attributes].filter(({ name }) => name !== 'style').map(({ name, value }) => name + '=' + JSON.stringify(value));
    const { left, top, width, height } = one.style;
    const content = one.firstElementChild ? '' : one.textContent;
    return [depth(one), one.localName, ...attributes.sort(), one.value, one.checked, one.indeterminate, content, left, top, width, height].join(' ');
  });
  return [lines.join('\\n'), made];`;

/** What the browser holds of the mirror, once nothing changes any more. */
async function settled(page) {
  let [lines, made] = ['', 0];
  await until('a page that stays as it is', async () => {
    await page.frames();
    const before = lines;
    const now = await page.run(HELD);
    lines = now[0];
    made += now[1];
    return lines === before;
  });
  return { lines, made };
}

/** Leaves the screen and comes back, which makes its elements anew. Returns what the browser held before and what it holds now. */
async function rebuilt(page) {
  const show = async (tab) => {
    await page.run('arguments[0].click()', tab);
    await until('the screen', async () => (await tab.getAttribute('aria-selected')) === 'true');
    // A dialog that was open when the screen was left is open again.
    await until('nothing over the screen', async () => {
      const wasOpen = await page.run(CLOSE);
      await page.frames();
      return !wasOpen;
    });
    // egui draws what has the focus in another size, so that is the tab both times, and no field is being edited.
    await until('the focus on its tab', async () => {
      await page.run('document.activeElement.blur(); arguments[0].focus()', tab);
      await page.frames();
      return page.run('return document.activeElement === arguments[0]', tab);
    });
    return settled(page);
  };
  const [shown, other] = await page.run(`return [true, false].map((chosen) => document.querySelector('${MIRROR} [role=tab][aria-selected=' + chosen + ']'))`);
  // There is no notice after that.
  const { lines: grown } = await show(shown);
  await show(other);
  const { lines: fresh, made } = await show(shown);
  return { grown, fresh, made };
}

it('after a random walk the mirror is what it would be if it were made anew', { engines: TWO_ENGINES }, async (test) => {
  const page = await bench.page(test);
  await page.start();
  // The dialog for printing is the browser's, and in Firefox the page waits for it.
  await page.run('window.print = () => {}');
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
    if ((batch + 1) % BATCHES_A_LOOK !== 0 && batch + 1 !== BATCHES) continue;
    const { grown, fresh, made } = await rebuilt(page);
    assert.equal(grown, fresh, last());
    assert.ok(made > 30, `only ${made} elements were made anew`);
    compared += 1;
  }
  test.diagnostic(`${walked.length} steps from seed ${SEED}: ${compared} times the whole page was compared`);
  // Chromium's advice on speed, for letters that are drawn with the browser's fonts, is no fault.
  assert.deepEqual((await page.consoleProblems()).filter((problem) => !problem.includes('willReadFrequently')), []);
});

it('the fields hold what the program computes with, the table what it computes', async (test) => {
  const page = await bench.page(test);
  await page.start();
  await page.press('Coffee mug (stereo)');
  await page.says(/1\.373…1\.429 m/);
  const rows = await page.run(
    `return [...document.querySelectorAll('${MIRROR} table')].flatMap((table) => [...table.rows].map((row) => [...row.cells].map((cell) => cell.textContent)))`,
  );
  const row = (name) => rows.find(([first, , , unit]) => first === name && unit !== undefined);
  // Without an uncertainty there is an empty cell, so that the unit is under its own header.
  assert.deepEqual(row('Parameter')?.slice(1, 4), ['Value', '± 1 σ', 'Unit']);
  assert.deepEqual(row('Focal length (fx)')?.slice(1, 4), ['700', '', 'px']);
  assert.deepEqual(row('Disparity (d)')?.slice(1, 4), ['50', '', 'px']);
  assert.match(row('Object distance (D, stereo)')?.[1] ?? '', /^1\.400/);

  // What a field shows, what is stored, and what the next start shows is the same.
  const stored = JSON.parse(await until('the storage', () => page.stored()));
  assert.equal(await page.value('Focal length (fx)'), stored.inputs.entries.fx.text);
  assert.equal(await page.value('Disparity (d)'), stored.inputs.entries.d.text);
  const headings = await page.run(`return [...document.querySelectorAll('${MIRROR} :is(h1, h2)')].map((one) => one.textContent)`);
  assert.deepEqual(headings.slice(0, 5), ['Depth Calculator', 'Camera', 'Stereo', 'Monocular', 'Stereo']);
});

/** Notes everything that the mirror says aloud, where every engine's scripts find it. */
const LISTEN = `
  const { dataset } = document.body;
  dataset.spoken = '';
  for (const region of document.querySelectorAll('${MIRROR} [aria-live]')) {
    new MutationObserver(() => (dataset.spoken += region.textContent && region.textContent + ' | ')).observe(region, { childList: true, characterData: true, subtree: true });
  }`;

it('results are said when they change, with what they are, and errors when they appear', async (test) => {
  const page = await bench.page(test);
  await page.start();
  await page.run(LISTEN);
  const spoken = () => page.run('return document.body.dataset.spoken');
  const hears = (pattern) => until(`${pattern} aloud`, async () => pattern.test(await spoken()));
  await page.press('Coffee mug (stereo)');
  await hears(/Stereo: 1\.400 m/);
  await hears(/The example is filled in\./);
  await page.fill('Disparity (d)', '100');
  await hears(/Stereo: 0\.7000 m/);
  // The second error is said too, and the first not again.
  await page.fill('Camera baseline (b)', '-3');
  await hears(/has no sign/);
  await page.run("document.body.dataset.spoken = ''");
  await page.fill('Focal length (fx)', 'seven');
  await hears(/“seven” is not a number/);
  assert.doesNotMatch(await spoken(), /has no sign/);
});

it('only what has changed touches the page, and nothing when nothing has', async (test) => {
  const page = await bench.page(test);
  await page.start();
  await page.press('Coffee mug (stereo)');
  await page.says(/1\.373…1\.429 m/);
  await page.fill('Focal length (fx)', '700');
  await page.frames();
  await page.run(`
    const { dataset } = document.body;
    const place = (target) => (target.closest?.('[id]') ?? target.parentElement?.closest('[id]'))?.id ?? 'away';
    const note = ({ type, target, addedNodes }) => [...addedNodes].filter((one) => one.id).map(() => 'made:' + place(target)).concat(type + ':' + place(target));
    dataset.touched = '';
    new MutationObserver((all) => (dataset.touched += all.flatMap(note).join(' ') + ' '))
      .observe(document.querySelector('${MIRROR}'), { childList: true, characterData: true, attributes: true, subtree: true });`);
  /** What has been touched since the last call, of a kind. */
  const touched = async (kind) => {
    await page.frames();
    return (await page.run("const { touched } = document.body.dataset; document.body.dataset.touched = ''; return touched")).split(' ').filter((one) => kind.test(one));
  };
  // In one step: what is half typed may be an error of its own.
  await page.type(Key.ARROW_UP);
  await page.says(/1\.402/);
  const changed = await touched(/:mirror-/);
  assert.ok(changed.length > 5, 'the numbers that depend on it');
  assert.deepEqual(changed.filter((one) => one.startsWith('made:')), [], 'what shows another number is the same element');
  await page.fill('Object width in image (w_img)', 'seven');
  await page.says(/is not a number|cannot|above zero/);
  // Once the typing has paused.
  const width = await page.field('Object width in image (w_img)');
  await until('the field called wrong', async () => (await width.getAttribute('aria-invalid')) === 'true');
  const made = await touched(/^made:/);
  assert.ok(made.length > 0 && made.length < 5, `an error is an element, the rest of the form is not made anew: ${made}`);
  // A pointer that moves is a pass in which nothing is another.
  await page.run("document.querySelector('canvas').dispatchEvent(new PointerEvent('pointermove', { clientX: 5, clientY: 5, bubbles: true, isPrimary: true }))");
  assert.deepEqual(await touched(/:mirror-/), []);
});

it('a keyboard with letters and a minus is asked for, as a unit may be typed, and the question mark lists the keys wherever the keyboard is', async (test) => {
  const page = await bench.page(test);
  await page.start();
  assert.equal(await (await page.field('Disparity (d)')).getAttribute('inputmode'), 'text');
  await page.run('arguments[0].focus()', await page.element('Reset', 'button'));
  await page.type('?');
  await page.says(/Step ten times as far|Shift \+ ↑ ↓/);
  await page.press('Close');
  await page.run('arguments[0].focus()', await page.field('Disparity (d)'));
  await page.driver.actions().keyDown(Key.ALT).sendKeys('3').keyUp(Key.ALT).perform();
  await page.says(/What this computes/);
});

it('About names the commit and leads to the licenses on a page of their own', async (test) => {
  const page = await bench.page(test);
  await page.start();
  await page.run("document.querySelector('meta[name=commit]').content = '0123456789abcdef'; window.open = (address) => { document.body.dataset.opened = address; return window; }");
  await page.press('Keys');
  await page.press('About Depth Calculator');
  await page.says(/Version \d+\.\d+\.\d+, commit 0123456789abcdef\./);
  await page.press('Licenses of the fonts and of every library in it');
  assert.equal(await until('the page', () => page.run('return document.body.dataset.opened')), 'licenses.html');
  await page.press('Close');
  await until('no dialog', () => page.run(`return document.querySelector('${MIRROR} [role=dialog]') === null`));
});

/** The names of elements that are not what is found at their middle, as the browser finds it for whoever explores by touch. */
const HIDDEN_FROM_A_FINGER = `
  const host = document.querySelector('${MIRROR}');
  const { bottom } = host.getBoundingClientRect();
  const shown = [...host.querySelectorAll(':is(button, input, a, h1, h2, h3, td, th, [role=tab], [role=img], span)[id]')].map((one) => [one, one.getBoundingClientRect()]);
  const looked = shown.filter(([one, box]) => box.width > 4 && box.height > 4 && box.bottom < bottom && !one.querySelector('[id]'));
  if (looked.length < 30) return ['only ' + looked.length + ' are shown'];
  return looked
    .map(([one, box]) => [one, document.elementFromPoint(box.x + box.width / 2, box.y + box.height / 2)])
    .filter(([one, found]) => !one.contains(found) && !(one.matches('[role=img]') && found?.matches('[type=range]')))
    .map(([one, found]) => one.outerHTML.replace(/ style="[^"]*"/, '') + ' is behind ' + (found?.outerHTML.replace(/ style="[^"]*"/, '').slice(0, 80)));`;
/** As when the mouse leaves the page. */
const LEAVE = "document.body.dispatchEvent(new PointerEvent('pointerout', { pointerType: 'mouse', bubbles: true }));";
/** Is the canvas what a pointer meets at the middle of this element? */
/** What shows and hides the refinements. */
const REFINE = 'Range, tilt, zero point';
const CANDIDATES_OF_FIELD = `return [...document.querySelectorAll('${MIRROR} input')].filter((one) => one.getAttribute('aria-label') === arguments[0] || (one.getAttribute('aria-labelledby') ?? '').split(' ').some((id) => document.getElementById(id)?.textContent === arguments[0])).length`;
const REACHES_THE_CANVAS = `
  const { x, y, width, height } = arguments[0].getBoundingClientRect();
  return document.elementFromPoint(x + width / 2, y + height / 2).localName === 'canvas';`;

it('a finger that explores finds what is painted there, and a pointer that comes is for the canvas', async (test) => {
  const page = await bench.page(test);
  await page.start();
  await page.press('Coffee mug (stereo)');
  await page.says(/1\.373…1\.429 m/);
  await page.frames();
  // Where there is a screen, a mouse lies on it, of which the browser may tell the page at any time.
  const leave = () => page.run(LEAVE);
  assert.deepEqual(await page.run(LEAVE + HIDDEN_FROM_A_FINGER), []);

  // The first that is heard of the mouse: what it presses is pressed once, and then the canvas has it.
  const FIELD = 'Tilt of the target';
  const isRefined = async () => (await page.run(CANDIDATES_OF_FIELD, FIELD)) > 0;
  const button = await page.element(REFINE, 'button');
  assert.equal(await page.run(LEAVE + REACHES_THE_CANVAS, button), false);
  await page.point(REFINE);
  await page.field(FIELD);
  await page.frames();
  const other = await page.element('Reset', 'button');
  assert.equal(await page.run(REACHES_THE_CANVAS, other), true);

  // It leaves the window, comes back to where it was without moving, and presses.
  const again = await page.element(REFINE, 'button');
  await page.moveTo(again);
  assert.equal(await page.run(LEAVE + REACHES_THE_CANVAS, other), false);
  await page.driver.actions().press().release().perform();
  await until('the refinements gone', async () => !(await isRefined()));
  await page.frames();
  assert.equal(await isRefined(), false);

  // Assistive technology presses as Chromium makes it up: a whole press of a mouse that is nowhere. It is one click, and the keyboard
  // stays where it is, whether or not a mouse lies on the page besides.
  const PRESS = `
    const one = arguments[0];
    one.focus();
    const { x, y, width, height } = one.getBoundingClientRect();
    const place = { bubbles: true, cancelable: true, clientX: x + width / 2, clientY: y + height / 2, pointerId: 1, pointerType: 'mouse', isPrimary: true };
    for (const name of ['pointerdown', 'mousedown', 'pointerup', 'mouseup', 'click']) {
      const Kind = name.startsWith('mouse') ? MouseEvent : PointerEvent;
      one.dispatchEvent(new Kind(name, { ...place, detail: name === 'click' ? 1 : 0, buttons: name.endsWith('down') ? 1 : 0 }));
    }
    return document.activeElement === one || document.activeElement.outerHTML.slice(0, 200);`;
  for (const [mouse, name, shown] of [['away', REFINE, true], ['there', REFINE, false]]) {
    await leave();
    // A mouse comes over the mirror first, and goes on over the canvas.
    if (mouse === 'there') for (const stop of ['Copy Results', 'Reset']) await page.moveTo(await page.element(stop, 'button'));
    assert.equal(await page.run(PRESS, await page.element(name, 'button')), true, `the keyboard stays, with a mouse ${mouse}`);
    await until(`the refinements, with a mouse ${mouse}`, async () => (await isRefined()) === shown);
    await page.frames();
    assert.equal(await isRefined(), shown, `one press, with a mouse ${mouse}`);
  }

  // And into a field, where the keyboard goes as on the canvas.
  await page.moveTo(await page.field('Disparity (d)'));
  await leave();
  await page.driver.actions().press().release().perform();
  await page.frames();
  await page.type('7');
  await until('the key in the field', async () => (await page.value('Disparity (d)')).includes('7'));
  assert.notEqual(await page.run('return document.activeElement.localName'), 'body');

  if (unless('touch')) test.diagnostic(`Without a finger: ${unless('touch')}`);
  else await byTouch(page, isRefined);
  assert.deepEqual(await page.consoleProblems(), []);
});

/** Taps: the first after a while, which meets the mirror, and the next. */
async function byTouch(page, isRefined) {
  const tap = async (name) => {
    const finger = new Pointer('finger', Pointer.Type.TOUCH);
    const place = await page.middle(await page.element(name, 'button'));
    await page.driver.actions().insert(finger, finger.move(place), finger.press(), finger.release()).perform();
  };
  const areShown = (shown) => until(`the refinements ${shown ? 'there' : 'gone'}`, async () => (await isRefined()) === shown);
  await page.run(LEAVE);
  // Before, as "soon after" is 3 s, and finding an element may take as long where much else runs.
  const reset = await page.element('Reset', 'button');
  await tap(REFINE);
  await areShown(true);
  // The next finger, soon after, has the canvas at once.
  assert.equal(await page.run(REACHES_THE_CANVAS, reset), true);
  // What is pressed by a key or by assistive technology after that is not taken for a part of it.
  await page.press(REFINE);
  await areShown(false);
  // The form is shorter now, and what was scrolled comes back.
  await page.frames();
  await tap(REFINE);
  await areShown(true);
  // Later the mirror can be explored again.
  const isAbove = async () => !(await page.run(REACHES_THE_CANVAS, await page.element('Reset', 'button')));
  if (!page.engine.needsScreen) await until('the mirror above', isAbove);
}

it('a slider can be set, as phones do it', async (test) => {
  const page = await bench.page(test);
  await page.start();
  await page.press('Coffee mug (stereo)');
  await page.says(/1\.373…1\.429 m/);
  const slider = await until('the slider', () => page.run(`return document.querySelector('${MIRROR} input[type=range]')`));
  assert.equal(await slider.getAccessibleName(), 'Disparity of the point, in pixels');
  await page.run("arguments[0].value = '70'; arguments[0].dispatchEvent(new Event('input', { bubbles: true }))", slider);
  await until('70 in the field', async () => (await page.value('Disparity (d)')) === '70');
  await page.says(/1\.000/);
});
