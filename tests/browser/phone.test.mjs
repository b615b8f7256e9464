// On a phone: sizes, fingers, and the on-screen keyboard.

import assert from 'node:assert/strict';
import { after, before, it } from './harness.mjs';
import { startBench, until } from './page.mjs';

/** Where many frames are drawn: without a graphics card, nine times as many pixels take nine times as long. */
const FAST = { width: 390, height: 844, scale: 1 };
const NEEDS = { needs: ['imitate a phone'] };

let bench;
before(async () => {
  bench = await startBench();
});
after(() => bench.close());

/** A page on a phone, with the program started. */
async function startOnPhone(test, screen) {
  const page = await bench.page(test);
  await page.imitatePhone(screen);
  await page.start();
  return page;
}

/** How many pixels of the canvas there are in a CSS pixel, for each that the browser says there are. */
const RATIO = 'return arguments[0].width / (arguments[0].clientWidth * devicePixelRatio)';

it('an emulated phone shows the page in its size', NEEDS, async (test) => {
  const page = await startOnPhone(test);
  assert.equal(await page.run('return devicePixelRatio'), 3);
  assert.equal(await page.run(RATIO, await page.canvas()), 1);
  // A button at the right edge of what egui paints is where the page ends, and not somewhere beyond.
  const { x } = await page.middle(await page.element('Coffee mug (stereo)', 'button'));
  assert.ok(x < 390, `at ${x}`);
  assert.deepEqual(await page.consoleProblems(), []);
});

it('a screen of twice as many pixels is drawn with all of them', NEEDS, async (test) => {
  const page = await bench.page(test, { scale: 2 });
  await page.start();
  assert.equal(await page.run('return devicePixelRatio'), 2);
  assert.equal(await page.run(RATIO, await page.canvas()), 1);
  assert.equal(await page.run("return 'devicePixelContentBoxSize' in ResizeObserverEntry.prototype"), true, 'the browser says how many, and is believed');
});

const isInput = (page) => page.run("return document.activeElement.matches('input, textarea')");

it('a phone starts without a keyboard', NEEDS, async (test) => {
  const page = await startOnPhone(test);
  await page.frames();
  assert.equal(await isInput(page), false);
  await page.type('7');
  assert.equal(await page.value('Focal length (fx)'), '', 'nor does anything type into a field');
});

it('a tablet starts without a keyboard', NEEDS, async (test) => {
  const page = await bench.page(test);
  await page.imitatePhone({ width: 1024, height: 768, scale: 2 });
  await page.start();
  await page.frames();
  assert.equal(await isInput(page), false);
});

it('two fingers zoom the page, and what lies over the canvas with it', NEEDS, async (test) => {
  const page = await startOnPhone(test, FAST);
  const at = await page.middle(await page.field('Disparity (d)'));
  assert.equal(await page.run('return visualViewport.scale'), 1);
  const fingers = (type, apart) => page.engine.touch(page.driver, type, [-1, 1].map((side, id) => ({ x: 195 + (side * apart) / 2, y: at.y, id })));
  await page.engine.touch(page.driver, 'touchStart', [{ x: 145, y: at.y, id: 0 }]);
  await fingers('touchStart', 100);
  for (let apart = 110; apart <= 250; apart += 10) {
    await fingers('touchMove', apart);
    await page.frames();
  }
  await page.engine.touch(page.driver, 'touchEnd', []);
  await until('a page twice as large', () => page.run('return visualViewport.scale > 1.8'));
  const rects = "return [document.querySelector('canvas'), document.querySelector('#accessible-mirror')].map((one) => JSON.stringify(one.getBoundingClientRect()))";
  const [canvas, mirror] = await page.run(rects);
  assert.equal(mirror, canvas);
  assert.equal(await isInput(page), false, 'nothing was tapped');
});

/** Where the middle of an element is once nothing moves any more. */
async function settled(page, element) {
  let last;
  return until('the page at rest', async () => {
    await page.frames();
    const now = await page.middle(element);
    const rests = last?.y === now.y;
    last = now;
    return rests && now;
  });
}

/** A finger comes down, moves by `way` in steps of a frame, rests there and is lifted. */
async function swipe(page, from, way) {
  const finger = (type, part) => {
    const points = part === undefined ? [] : [{ x: from.x + way.x * part, y: from.y + way.y * part }];
    return page.engine.touch(page.driver, type, points);
  };
  await finger('touchStart', 0);
  await page.frames();
  for (let step = 1; step <= 20; step += 1) {
    await finger('touchMove', step / 20);
    await page.frames();
  }
  // What is lifted while it moves would be thrown.
  for (let frame = 0; frame < 5; frame += 1) await page.frames();
  await finger('touchEnd');
}

it('a finger that begins on a field scrolls, and one that taps it edits it', NEEDS, async (test) => {
  const page = await startOnPhone(test, FAST);
  const name = 'Object width in image (w_img)';
  const field = await page.field(name);
  const scrolled = async (way) => {
    const from = await settled(page, field);
    await swipe(page, from, { x: 0, y: way });
    return (await settled(page, field)).y - from.y;
  };
  const figures = [];
  const follows = async (way) => {
    const by = await scrolled(way);
    figures.push(`${by} of ${way} px`);
    assert.ok(Math.abs(by - way) <= 12, `scrolled ${by} for ${way}`);
  };
  await follows(-300);
  assert.equal(await isInput(page), false);
  await follows(300);
  assert.equal(await isInput(page), false);

  const at = await settled(page, field);
  await page.engine.touch(page.driver, 'touchStart', [at]);
  await page.engine.touch(page.driver, 'touchEnd', []);
  await until('the field with the keyboard', () => isInput(page));
  await page.type('1');
  await until('the key in the field', async () => (await page.value(name)).includes('1'));

  // Also where the field has the focus already.
  const text = await page.value(name);
  await follows(-300);
  assert.equal(await page.value(name), text);
  test.diagnostic(`scrolled by a finger on a field: ${figures.join(', ')}`);
  assert.deepEqual(await page.consoleProblems(), []);
});

it('a point of a chart is moved sideways, and the page is not', NEEDS, async (test) => {
  const page = await startOnPhone(test, FAST);
  await page.press('Coffee mug (stereo)');
  await page.says(/1\.400/);
  const slider = await until('the slider', () => page.run("return document.querySelector('#accessible-mirror input[type=range]')"));
  await page.run('arguments[0].focus()', slider);
  const before = await until('the slider in sight', async () => {
    const at = await settled(page, slider);
    return at.y > 100 && at.y < 700 && at;
  });
  const reset = await page.element('Reset', 'button');
  const { y } = await settled(page, reset);
  await swipe(page, before, { x: 60, y: 8 });
  await until('another disparity', async () => (await page.value('Disparity (d)')) !== '50');
  assert.equal((await settled(page, reset)).y, y, 'nothing has scrolled');
});
