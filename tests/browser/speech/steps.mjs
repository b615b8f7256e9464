// The first minutes of somebody who hears the page and uses it by keyboard.

import { Key } from '../page.mjs';

const { TAB, ENTER, ESCAPE, ARROW_DOWN, BACK_SPACE } = Key;

/** What is done, by name, in order. */
export function steps(page) {
  const type = (...keys) => () => page.type(...keys);
  const tabTo = (name) => () => page.tabTo(name);
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
      await page.run('arguments[0].focus()', await page.field('Disparity (d)'));
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
    ['The key ? on a button: the keys', async () => {
      await page.run('arguments[0].focus()', await page.element('Reset', 'button'));
      await page.type('?');
    }],
    ['Escape: they close', type(ESCAPE)],
    ['Alt + 3: Learn', () => page.driver.actions().keyDown(Key.ALT).sendKeys('3').keyUp(Key.ALT).perform()],
    ['Back, as the browser has it', () => page.driver.navigate().back()],
  ];
}
