// Somebody who types faster than the program draws: what is typed is in the field that was meant.

import assert from 'node:assert/strict';
import { after, before, it, TWO_ENGINES } from './harness.mjs';
import { Key, startBench, until } from './page.mjs';

const FIELDS = ['Focal length (fx)', 'Camera baseline (b)', 'Disparity (d)', 'Object width in image (w_img)', 'Object real width (w_real)'];
const FORMS = 10;
/** Numbers, and what gets an error, a warning or a choice of corrections, so that notes come and go. */
const TEXTS = ['700', '1,000', 'abc', '0.1', '-12', '50', '1.234.5', '0', '150', '1e999', '7 parsec', '300', '1.000,5'];

let bench;
before(async () => {
  bench = await startBench();
});
after(() => bench.close());

const texts = (form) => FIELDS.map((_, field) => TEXTS[(form * FIELDS.length + field * 3 + form) % TEXTS.length]);
const numbers = (form) => FIELDS.map((_, field) => `${100 + form * 10 + field}`);

/** Fills all forms with `fill`, and returns those in which something else stands than what was typed. */
async function wrongForms(page, typed, fill) {
  // One by one: WebKit's driver does not find elements inside of lists.
  const elements = [];
  for (const name of FIELDS) elements.push(await page.field(name));
  const values = () => page.run('return [...arguments].map((field) => field.value)', ...elements);
  const wrong = [];
  for (let form = 0; form < FORMS; form += 1) {
    await fill(typed(form), elements);
    // Only now is there time for the program to catch up.
    for (let frame = 0; frame < 6 && String(await values()) !== String(typed(form)); frame += 1) await page.frames();
    if (String(await values()) !== String(typed(form))) wrong.push({ form, typed: typed(form), stands: await values() });
  }
  return wrong;
}

// High enough that no field is scrolled into view: that would move the others.
for (const [device, width, height, needs] of [
  ['desk', 1280, 1000, []],
  ['phone', 390, 1500, ['show a page as narrow as a phone']],
]) {
  it(`ten forms are filled by mouse and keys without waiting for anything, as wide as on a ${device}`, { needs, engines: TWO_ENGINES }, async (test) => {
    const page = await bench.page(test);
    await page.setScreen({ width, height });
    await page.start();
    const reset = await page.middle(await page.element('Reset', 'button'));
    const places = [];
    // Where no corrections lie: on a slow machine they are there long enough to be clicked.
    for (const name of FIELDS) places.push(await page.rightEnd(await page.field(name)));
    const wrong = await wrongForms(page, texts, (values) => {
      const actions = page.driver.actions();
      const click = (place) => actions.move({ ...place, duration: 0 }).press().release();
      click(reset);
      values.forEach((text, field) => click(places[field]).sendKeys(text));
      return actions.perform();
    });
    test.diagnostic(`${wrong.length} of ${FORMS} forms are wrong.`);
    assert.deepEqual(wrong, []);
  });
}

it('ten forms are filled in the accessible page without waiting for anything', async (test) => {
  const page = await bench.page(test);
  await page.start();
  const wrong = await wrongForms(page, texts, async (values, elements) => {
    // Each field gets the keyboard and one letter after the other, all in one task of the browser.
    await page.run(
      `const fields = [...arguments];
       const texts = fields.pop();
       fields.forEach((field, at) => {
         field.focus();
         field.value = '';
         for (const letter of texts[at]) {
           field.setRangeText(letter, field.value.length, field.value.length, 'end');
           field.dispatchEvent(new InputEvent('input', { bubbles: true, data: letter, inputType: 'insertText' }));
         }
       });`,
      ...elements,
      values,
    );
  });
  assert.deepEqual(wrong, []);
});

it('a form is filled with the key Tab without waiting for anything', { needs: ['leave a page with Tab'] }, async (test) => {
  const page = await bench.page(test);
  await page.start();
  const wrong = await wrongForms(page, numbers, async (values, [first]) => {
    await page.run('arguments[0].focus(); arguments[0].select()', first);
    // By way of each σ, and from the baseline to the disparity by way of its unit and the helper.
    const [fx, baseline, disparity, imageWidth, realWidth] = values;
    const { TAB } = Key;
    await page.driver.actions().sendKeys(fx, TAB, TAB, baseline, TAB, TAB, TAB, TAB, disparity, TAB, TAB, imageWidth, TAB, TAB, realWidth).perform();
  });
  assert.deepEqual(wrong, []);
  await until('a result', async () => /\d m\b/.test(await page.text()));
});

/** A sign of each script that is put together in a way of its own, and what is more than one sign: emoji, marks, turns of direction. */
const SCRIPTS = {
  Arabic: 'متر ٥',
  Hebrew: 'מֶטֶר',
  Khmer: 'ភាសាខ្មែរ',
  Devanagari: 'हिन्दी र्क',
  Bengali: 'কো',
  Tamil: 'கோ',
  Malayalam: 'ക്രോ',
  Sinhala: 'ක්‍රෝ',
  Hangul: '한글 \u1112\u1161\u11ab',
  Myanmar: 'မြန်မာ',
  Tibetan: 'བོད་སྐད',
  Javanese: 'ꦏꦿꦺꦴ',
  Thai: 'กำ',
  Mongolian: 'ᠮᠣᠩᠭᠣᠯ',
  NKo: 'ߒߞߏ',
  emoji: '👩‍🚀',
  marks: 'n\u0303\u0301',
  turned: '\u202eabc',
};

// Where the browser has signs for them it draws them; where it has none, the fonts of the program are asked.
for (const [drawn, options] of [
  ['drawn by the browser', {}],
  ['not even by the browser', { without: 'letters' }],
]) {
  it(`what no font here has can be typed, ${drawn}, and the program goes on`, async (test) => {
    const page = await bench.page(test, options);
    await page.start();
    const name = 'Object real width (w_real)';
    for (const text of Object.values(SCRIPTS)) {
      await page.fill(name, text);
    }
    await page.fill('Focal length (fx)', '500');
    await page.fill('Object width in image (w_img)', '100');
    await page.fill(name, '0.30');
    await until('the distance', async () => /1\.5\d* m\b/.test(await page.text()));
    assert.equal(await page.whyStartedAgain(), null, 'it was not started again meanwhile');
  });
}
