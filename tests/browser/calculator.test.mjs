// The calculator as somebody uses it: keyboard, clipboard, reload.

import assert from 'node:assert/strict';
import { after, before, it, ONE_ENGINE, unless } from './harness.mjs';
import { setTimeout as sleep } from 'node:timers/promises';
import { Key, startBench, until } from './page.mjs';

const FX = 'Focal length (fx)';
const BASELINE = 'Camera baseline (b)';
const DISPARITY = 'Disparity (d)';
const IMAGE_WIDTH = 'Object width in image (w_img)';
const REAL_WIDTH = 'Object real width (w_real)';

let bench;
before(async () => {
  bench = await startBench();
});
after(() => bench.close());

/** What is copied, as a part of a test that is left out where nobody can look. */
async function copies(test, page, pattern, press = () => page.press('Copy Results')) {
  await test.test('and is copied', { skip: unless('read the clipboard') }, async () => {
    await page.prepareClipboard();
    await press();
    assert.match(await until('the results on the clipboard', () => page.clipboard()), pattern);
    await page.says(/copied/i);
  });
}

it('the coffee mug is 1.400 m away, by keyboard alone', async (test) => {
  const page = await bench.page(test);
  await page.start();
  // At a desk the program starts in the first field.
  await page.type('700');
  await until('700 in the first field', async () => (await page.value(FX)) === '700');
  await page.tabTo(BASELINE);
  await page.type('10 cm');
  await page.tabTo(DISPARITY);
  await page.type('50', Key.ENTER);
  await page.says(/1\.373…1\.429 m/);

  await copies(test, page, /1\.400 m\b/, async () => {
    await page.tabTo('Copy Results');
    await page.type(Key.ENTER);
  });
  assert.deepEqual(await page.consoleProblems(), []);
});

it('the arrow keys lead through a choice, which is one stop of the key Tab', async (test) => {
  const page = await bench.page(test);
  await page.start();
  await page.tabTo('Measured: Width');
  const steps = [[Key.ARROW_RIGHT, 'Measured: Height'], [Key.ARROW_DOWN, 'Measured: Diameter of ball'], [Key.ARROW_LEFT, 'Measured: Height']];
  for (const [key, name] of steps) {
    await page.type(key);
    await until(name, async () => {
      const active = await page.driver.switchTo().activeElement();
      return (await active.getAccessibleName()) === name && (await active.isSelected());
    });
  }
  await page.field('Object height in image (w_img)');
  await page.type(Key.TAB);
  await until('the next stop', async () => (await (await page.driver.switchTo().activeElement()).getAccessibleName()) === 'Known sizes…');
});

it('the keyboard leaves the program again', { needs: ['leave a page with Tab'] }, async (test) => {
  const page = await bench.page(test);
  await page.start();
  let left = false;
  for (let tabs = 0; tabs < 60 && !left; tabs += 1) {
    await page.type(Key.TAB);
    left = await page.run('return document.activeElement === document.body || !document.hasFocus()');
  }
  assert.ok(left, 'sixty times Tab does not lead out');
});

it('what was entered is there again after a reload', async (test) => {
  const page = await bench.page(test);
  await page.start();
  await page.fill(FX, '700');
  await page.fill(BASELINE, '100');
  await page.fill(DISPARITY, '50');
  await page.says(/1\.373…1\.429 m/);
  await until('the inputs in the storage', async () => (await page.stored())?.includes('"700"'));
  assert.equal(typeof JSON.parse(await page.stored()), 'object');

  await page.reload();
  assert.deepEqual([await page.value(FX), await page.value(BASELINE), await page.value(DISPARITY)], ['700', '100', '50']);
  await copies(test, page, /1\.400 m\b/);
});

it('the doorway is 4.275 m away', { engines: ONE_ENGINE }, async (test) => {
  const page = await bench.page(test);
  await page.start();
  await page.fill(FX, '950');
  await page.fill(IMAGE_WIDTH, '200');
  await page.fill(REAL_WIDTH, '0.9');
  await page.says(/4\.275/);
  await copies(test, page, /4\.275 m\b/);
});

it('each example shows its distance', { engines: ONE_ENGINE }, async (test) => {
  const page = await bench.page(test);
  await page.start();
  await page.press('Doorway (monocular)');
  await page.says(/4\.275/);
  await page.press('Coffee mug (stereo)');
  await page.says(/1\.373…1\.429 m/);
});

it('a mistake is said at its field', { engines: ONE_ENGINE }, async (test) => {
  const page = await bench.page(test);
  await page.start();
  await page.fill(FX, 'seven');
  await until('the field marked as invalid', async () => (await (await page.field(FX)).getAttribute('aria-invalid')) === 'true');
});

for (const text of ['{', '', 'null', '{"version":999}', '\u0000 no JSON']) {
  it(`a store that holds ${JSON.stringify(text)} does not keep the program from starting`, { engines: ONE_ENGINE }, async (test) => {
    const page = await bench.page(test);
    await page.store(text);
    await page.start();
    assert.deepEqual(await page.consoleProblems(), []);
    await page.says(/could not be read/);
    await page.press('Coffee mug (stereo)');
    await page.says(/1\.373…1\.429 m/);
  });
}

it('a link fills in the fields that it names, and a reload keeps what was typed since', async (test) => {
  const page = await bench.page(test);
  await page.driver.get(`${bench.server.url}#fx=700&b=100mm&d=50`);
  await page.started();
  await page.says(/1\.373…1\.429 m/);
  await page.fill(DISPARITY, '100');
  await page.says(/0\.700/);
  await page.reload();
  assert.equal(await page.value(DISPARITY), '100');
});

it('nothing is computed while nothing happens, for five seconds, with and without a field in use', { engines: ONE_ENGINE }, async (test) => {
  const page = await bench.page(test);
  await page.runBefore('const ask = requestAnimationFrame; globalThis.asked = 0; globalThis.requestAnimationFrame = (work) => { globalThis.asked += 1; return ask(work); }');
  await page.start();
  await page.press('Coffee mug (stereo)');
  await page.says(/1\.373…1\.429 m/);
  // Every pass ends with drawing. (eframe asks in each animation frame whether there is anything to do; that is no pass.)
  await page.run(`
    const { dataset } = document.body;
    Object.assign(dataset, { work: '', idle: 0 });
    let drawn = performance.now();
    for (const name of ['clear', 'drawElements']) {
      const draw = WebGL2RenderingContext.prototype[name];
      WebGL2RenderingContext.prototype[name] = function (...values) {
        Object.assign(dataset, { work: dataset.work + name + ' ', idle: 0 });
        drawn = performance.now();
        return draw.apply(this, values);
      };
    }
    // How many times in a row, of at least half a second, there was nothing to draw: on a machine that is short of time, time alone says
    // nothing. Not in animation frames, which the page holds back.
    setTimeout(function next() {
      if (performance.now() - drawn > 500) dataset.idle = Number(dataset.idle) + 1;
      setTimeout(next, 16);
    }, 16);`);
  const work = () => page.run("const { work } = document.body.dataset; document.body.dataset.work = ''; return work");
  for (const use of ['focus', 'blur']) {
    await page.run(`arguments[0].${use}()`, await page.field(DISPARITY));
    // What is counted does happen, and comes to an end.
    await until('drawing', async () => /clear .*drawElements/.test(await work()));
    await until('half a second without drawing', async () => Number(await page.run('return document.body.dataset.idle')) > 30);
    await work();
    await page.run('globalThis.asked = 0');
    await sleep(5_000);
    assert.equal(await work(), '', `after ${use}`);
    // Not sixty times a second, as eframe does: the page rests (assets/web/rest.js).
    const asked = await page.run('return globalThis.asked');
    assert.ok(asked > 0 && asked < 25, `${asked} animation frames after ${use}`);
  }
});
