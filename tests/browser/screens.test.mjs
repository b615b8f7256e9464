// Every screen at every width, light and dark: pictures for people, and proof that something is drawn.

import assert from 'node:assert/strict';
import { mkdir, writeFile } from 'node:fs/promises';
import path from 'node:path';
import { after, before, it, ONE_ENGINE } from './harness.mjs';
import { background, startBench, until } from './page.mjs';
import { settings } from './settings.mjs';

const FOLDER = settings.screenshots;
const DEVICES = [
  { device: 'a phone', scale: 2, sizes: [{ width: 390, height: 844 }] },
  {
    device: 'a desk',
    scale: 1,
    sizes: [
      { width: 768, height: 1024 },
      { width: 1280, height: 900 },
      { width: 1920, height: 1080 },
    ],
  },
];
/** As wide as screens are: only of the screen that has the most to show. */
const HUGE = { width: 2560, height: 1440 };
const MUG = { 'Focal length (fx)': '700', 'Camera baseline (b)': '100', 'Disparity (d)': '50' };
const FULL = {
  ...MUG,
  'Object width in image (w_img)': '150',
  'Object real width (w_real)': '0.30',
  'Uncertainty of Focal length (fx)': '2',
  'Uncertainty of Camera baseline (b)': '0.5',
  'Uncertainty of Disparity (d)': '0.5',
  'Uncertainty of Object width in image (w_img)': '2',
  'Uncertainty of Object real width (w_real)': '0.01',
};
const MISTAKES = { 'Focal length (fx)': 'seven', 'Camera baseline (b)': '-3', 'Disparity (d)': '0' };

/** How each screen is reached from a fresh start. */
const SCREENS = {
  'calculator-empty': async () => {},
  'calculator-full': (page) => fillAll(page, FULL),
  'calculator-errors': (page) => fillAll(page, MISTAKES),
  rigs: async (page) => {
    await page.show('Rigs');
    await page.press('New rig');
    await page.fill('Focal length (fx)', '700');
  },
  learn: (page) => page.show('Learn'),
};

async function fillAll(page, values) {
  for (const [name, value] of Object.entries(values)) await page.fill(name, value);
}

let bench;
before(async () => {
  bench = await startBench();
  await mkdir(FOLDER, { recursive: true });
});
after(() => bench.close());

/** A picture with a light or dark background, and the same again some frames later: nothing moves any more. */
async function settledScreenshot(page, dark) {
  let last;
  return until(`a ${dark ? 'dark' : 'light'} picture that stands still`, async () => {
    await page.frames();
    const next = await page.screenshot();
    const still = last?.equals(next) && background(next).lightness < 128 === dark;
    last = next;
    return still && next;
  });
}

for (const { device, scale, sizes } of DEVICES) {
  for (const [name, reach] of Object.entries(SCREENS)) {
    it(`${name} is drawn on ${device}, light and dark`, { engines: ONE_ENGINE }, async (test) => {
      const page = await bench.page(test, { scale });
      await page.setScreen(sizes[0]);
      await page.start();
      await reach(page);
      // So that no caret blinks in the pictures.
      await page.run('document.activeElement?.blur()');
      for (const dark of [false, true]) {
        for (const size of name === 'calculator-full' && device === 'a desk' ? [...sizes, HUGE] : sizes) {
          await page.setScreen({ ...size, dark });
          const png = await settledScreenshot(page, dark);
          const file = `${name}-${size.width}-${dark ? 'dark' : 'light'}.png`;
          await writeFile(path.join(FOLDER, file), png);
          const { share } = background(png);
          assert.ok(share < 0.985, `${file} is nearly of one color (${(100 * share).toFixed(1)} %)`);
        }
      }
      assert.equal(await page.run('return arguments[0].width / innerWidth', await page.canvas()), scale, 'device pixels drawn');
      assert.deepEqual(await page.consoleProblems(), []);
    });
  }
}

it('the page before the program follows the color scheme', { engines: ONE_ENGINE }, async (test) => {
  const page = await bench.page(test);
  bench.server.state.programs = 'missing';
  for (const dark of [false, true]) {
    await page.setScreen({ width: 1280, height: 900, dark });
    await page.startFailing();
    const png = await settledScreenshot(page, dark);
    await writeFile(path.join(FOLDER, `failure-${dark ? 'dark' : 'light'}.png`), png);
  }
});
