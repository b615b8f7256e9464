// The first minutes of somebody who hears the page and uses it by keyboard.

import { Key } from '../page.mjs';

const { TAB, ENTER, ESCAPE, ARROW_DOWN, BACK_SPACE } = Key;

/** The keys of Orca from cell to cell. */
const CELL = { Down: 'alt+shift+Down', Left: 'alt+shift+Left', Right: 'alt+shift+Right', Up: 'alt+shift+Up' };

const MIDDLEBURY = 'cam0=[700 0 320; 0 700 240; 0 0 1]\ncam1=[700 0 320; 0 700 240; 0 0 1]\ndoffs=0\nbaseline=100\nwidth=640\nheight=480\n';

/** Drops a calibration in the middle of the window. */
const drop = (page) =>
  page.run(
    `const transfer = new DataTransfer();
     transfer.items.add(new File([arguments[0]], 'calib.txt'));
     const target = document.elementFromPoint(innerWidth / 2, innerHeight / 2);
     target.dispatchEvent(new DragEvent('drop', { bubbles: true, cancelable: true, dataTransfer: transfer }));`,
    MIDDLEBURY,
  );

/** What is done, by name, in order. `press` presses a key of the keyboard: of those of a driver, Orca hears none. */
export function steps(page, press) {
  const type = (...keys) => () => page.type(...keys);
  const tabTo = (name) => () => page.tabTo(name);
  const focus = async (element) => page.run('arguments[0].focus()', await element);
  const toCell = (way, where) => [`Alt + Shift + ${way}: ${where}`, () => press(CELL[way])];
  const select = async () => page.run('document.activeElement.select()');
  return [
    ['The page opens', () => page.start()],
    ['Types 700', type(...'700')],
    ['Tab', type(TAB)],
    ['Tab', type(TAB)],
    ['Types 1000', type(...'1000')],
    ['Tab: the unit', type(TAB)],
    ['Down: its list', type(ARROW_DOWN)],
    ['Down', type(ARROW_DOWN)],
    ['Enter', type(ENTER)],
    ['Tab to the disparity', tabTo('Disparity (d)')],
    ['Types 50', type(...'50')],
    ['Tab to the width in the image', tabTo('Object width in image (w_img)')],
    ['Types 150', type(...'150')],
    ['Tab to the real width', tabTo('Object real width (w_real)')],
    ['Types -3, a mistake', type(...'-3')],
    ['Enter', type(ENTER)],
    ['Types 0.30 instead', async () => {
      await select();
      await page.type(...'0.30');
    }],
    ['Enter', type(ENTER)],
    ['Tab to the helper of the disparity', async () => {
      await focus(page.field('Disparity (d)'));
      await page.driver.actions().keyDown(Key.SHIFT).sendKeys(TAB).keyUp(Key.SHIFT).perform();
    }],
    ['Enter: it opens', type(ENTER)],
    ['Escape: it closes', type(ESCAPE)],
    ['Tab', type(TAB)],
    ['Empties the disparity', async () => {
      await select();
      await page.type(BACK_SPACE);
    }],
    ['Enter', type(ENTER)],
    ['To a button', () => focus(page.element('Reset', 'button'))],
    ['The key ?: the keys', type('?')],
    ['Escape: they close', type(ESCAPE)],
    ['Alt + 3: Learn', () => page.driver.actions().keyDown(Key.ALT).sendKeys('3').keyUp(Key.ALT).perform()],
    ['Back, as the browser has it', () => page.driver.navigate().back()],
    ['To the disparity again', () => focus(page.field('Disparity (d)'))],
    ['Types 50', type(...'50')],
    ['Tab', type(TAB)],
    ['Types 0.2', type(...'0.2')],
    ['To a button', () => focus(page.element('Reset', 'button'))],
    ['Tab to the cursor of a chart', tabTo('Data cursor: Stereo against monocular')],
    ['To a button', () => focus(page.element('Reset', 'button'))],
    ['The key g: a chart', () => press('g')],
    ['The key g: another', () => press('g')],
    ['The key t: the table', () => press('t')],
    toCell('Right', 'the next header'),
    toCell('Left', 'back'),
    toCell('Down', 'the focal length'),
    toCell('Down', 'the baseline'),
    toCell('Down', 'the disparity'),
    toCell('Right', 'its value'),
    toCell('Right', 'its σ'),
    toCell('Right', 'its unit'),
    toCell('Up', 'that of the baseline'),
    toCell('Left', 'the σ that it has not'),
    toCell('Left', 'its value'),
    toCell('Down', 'the disparity'),
    toCell('Down', 'the width in the image'),
    toCell('Down', 'the real width'),
    toCell('Down', 'the next part of the table'),
    toCell('Down', 'its first value'),
    toCell('Left', 'its name'),
    ['To a button', () => focus(page.element('Reset', 'button'))],
    ['Alt + 2: Rigs', () => page.driver.actions().keyDown(Key.ALT).sendKeys('2').keyUp(Key.ALT).perform()],
    ['To a new rig', () => focus(page.element('New rig', 'button'))],
    ['Enter: it is there', type(ENTER)],
    ['To its name', () => focus(page.field('Name'))],
    ['Types a name', type(...'Robot')],
    ['Tab to its baseline', tabTo('Camera baseline (b)')],
    ['Types -3, a mistake', type(...'-3')],
    ['Tab', type(TAB)],
    ['To the files', () => focus(page.element('Calibration file…', 'button'))],
    ['Enter: the dialog', type(ENTER)],
    ['Tab to the text of a file', tabTo('Or paste the text of one')],
    ['Types what is none', type(...'nothing')],
    ['Tab: to read it', type(TAB)],
    ['Enter: why it is none', type(ENTER)],
    ['Escape: it closes', type(ESCAPE)],
    ['A calibration is dropped', () => drop(page)],
    ['Tab', type(TAB)],
    ['To use it', () => focus(page.element('Use in calculator', 'button'))],
    ['Enter: it is used', type(ENTER)],
    ['To the known sizes', () => focus(page.element('Known sizes…', 'button'))],
    ['Enter: they open', type(ENTER)],
    ['Types card short', type(...'card short')],
    ['Tab: what was found', type(TAB)],
    ['Enter: its size is filled in', type(ENTER)],
    ['To the helper of the focal length', () => focus(page.element('From lens, FOV or Q…', 'button'))],
    ['Enter: it opens', type(ENTER)],
    ['To the camera facts', () => focus(page.element('Camera facts…', 'button'))],
    ['Enter: they open', type(ENTER)],
    ['To the width of the image', () => focus(page.field('Width of the image'))],
    ['Types 1920', type(...'1920')],
    ['Tab: the height', type(TAB)],
    ['Types 1080', type(...'1080')],
    ['Tab to a view', tabTo('Diagonal field of view')],
    ['Types 78', type(...'78')],
    ['Tab: the equivalent, which follows', type(TAB)],
    ['Types 50, which excludes it', type(...'50')],
    ['Escape: it closes', type(ESCAPE)],
  ];
}
