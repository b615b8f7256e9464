// What the checkers look at: every screen and dialog, with mistakes and without.

import { until } from './page.mjs';

const MIRROR = '#accessible-mirror';
const FX = 'Focal length (fx)';
export const FIELDS = [FX, 'Camera baseline (b)', 'Disparity (d)', 'Object width in image (w_img)', 'Object real width (w_real)'];

async function fillAll(page, ...values) {
  for (const [index, value] of values.entries()) await page.fill(FIELDS[index], value);
}

/** How each screen is reached from a fresh start. */
export const SCREENS = {
  'the empty calculator': async () => {},
  'the calculator with every distance and its uncertainty': async (page) => {
    await fillAll(page, '700', '100', '50', '150', '0.30');
    await page.fill(`Uncertainty of ${FX}`, '1%');
    await page.fill('Uncertainty of Disparity (d)', '0.5');
    await page.press('Range, tilt, zero point');
    await page.says(/Where the uncertainty comes from/);
  },
  'the calculator that solves for another quantity': async (page) => {
    await fillAll(page, '700', '100');
    await page.press('Another quantity');
    await page.says(/Solve for/);
  },
  'the ground plane': async (page) => {
    await page.press('Ground plane');
    await page.says(/Along the floor/);
  },
  'two photographs and a step': async (page) => {
    await page.press('More ways');
    await page.press('Two photographs and a step');
    await page.says(/From the second place/);
  },
  'the calculator with mistakes': async (page) => {
    await fillAll(page, 'seven', '-3', '0');
    await page.press('Calculate Distance');
    await until('a field marked as invalid', () => page.run(`return document.querySelector('${MIRROR} [aria-invalid=true]') !== null`));
  },
  'rigs, one with a mistake': async (page) => {
    await page.show('Rigs');
    await page.press('New rig');
    await page.fill('Camera baseline (b)', '-3');
    await page.says(/A baseline is a distance/);
  },
  'the dialog that opens calibration files': async (page) => {
    await page.show('Rigs');
    await page.press('Calibration file…');
    await page.says(/Or paste the text of one/);
  },
  'a calibration whose unit is asked for': async (page) => {
    await page.run(
      `const transfer = new DataTransfer();
       transfer.items.add(new File([arguments[0]], 'stereo.json'));
       document.body.dispatchEvent(new DragEvent('drop', { bubbles: true, cancelable: true, dataTransfer: transfer }));`,
      JSON.stringify({ P1: [[700, 0, 320, 0], [0, 700, 240, 0], [0, 0, 1, 0]], P2: [[700, 0, 320, -84000], [0, 700, 240, 0], [0, 0, 1, 0]] }),
    );
    await page.says(/Which is it/);
  },
  'a known size that was searched': async (page) => {
    await page.press('Known sizes…');
    await page.fill('Search the known sizes', 'card');
    await page.says(/2 of 21/);
  },
  'the facts of a camera, of which two exclude one another': async (page) => {
    await page.press('From lens, FOV or Q…');
    await page.press('Camera facts…');
    const stated = { 'Width of the image': '1920', 'Height of the image': '1080', 'Horizontal field of view': '60', 'Diagonal field of view': '78' };
    for (const [field, text] of Object.entries(stated)) await page.fill(field, text);
    await page.says(/These exclude one another/);
  },
  'the explanations': async (page) => {
    await page.show('Learn');
    await page.says(/What this computes/);
  },
  'the list of keys': async (page) => {
    await page.press('Keys');
    await until('the dialog', () => page.run(`return document.querySelector('${MIRROR} [role=dialog]') !== null`));
  },
  'what the program is': async (page) => {
    await page.press('Keys');
    await page.press('About Depth Calculator');
    await page.says(/Version \d/);
  },
  'a dialog with a mistake': async (page) => {
    await page.press('From lens, FOV or Q…');
    await page.fill('Pixel pitch', 'three');
    await page.says(/is not a number/);
  },
  'the other dialog, with a list open': async (page) => {
    await page.press('OpenCV × 16, doffs…');
    await page.press('What is known');
    await until('the list', () => page.run(`return document.querySelector('${MIRROR} [role=listbox]') !== null`));
  },
  'an open menu': async (page) => {
    await page.press('Light or dark');
    await until('the menu', () => page.run(`return document.querySelector('${MIRROR} [role=menu]') !== null`));
  },
  'a notice': async (page) => {
    await page.press('Coffee mug (stereo)');
    await page.says(/1\.373…1\.429 m/);
    await page.press('Reset');
    await page.says(/All fields are cleared/);
  },
};
