// WebKitGTK's MiniBrowser, through WebKitWebDriver.

import { setTimeout as sleep } from 'node:timers/promises';
import { Capabilities } from 'selenium-webdriver';

const NO_COMMAND = 'its driver has no such command';

/** To give the window a size, which it takes when it is shown. */
const MOST_ATTEMPTS = 50;

export const webkit = {
  cannot: {
    'imitate a phone': NO_COMMAND,
    'show a page as narrow as a phone': 'its window is at least 447 pixels wide',
    'read the clipboard': 'MiniBrowser refuses the clipboard to every page and has no way to allow it',
    'leave a page with Tab': 'MiniBrowser goes on with the first element of the page, whichever page it is',
    'choose the color scheme': 'MiniBrowser takes it from the desktop',
    'choose the colors': 'WebKit has no such mode',
    touch: 'its driver makes a mouse of a finger',
    'make its window lower': 'WebKitWebDriver calls the height of 420 pixels invalid',
    'read the console': 'its driver gives no log',
    'switch scripts off': NO_COMMAND,
    'say what keeps a page from being installed': NO_COMMAND,
  },
  switchesOff: [],
  /** Its compiler makes one start in 200 read beside the program's memory (2.50). */
  breaksPrograms: true,
  // MiniBrowser has no mode without a window.
  needsScreen: true,
  driverArguments: (port) => [`--port=${port}`],

  capabilities({ browser, proxy }) {
    return new Capabilities({
      browserName: 'MiniBrowser',
      // So that the proxy can read what is asked of others by https.
      acceptInsecureCerts: true,
      // With a proxy of WebDriver's, one start in five hangs.
      'webkitgtk:browserOptions': {
        args: ['--automation', `--proxy=http://127.0.0.1:${proxy}`, '--ignore-host=127.0.0.1'],
        binary: browser,
      },
    });
  },

  async prepare() {},
  async reset() {},

  /** Changes the window until the page in it has this size: WebDriver knows only the outer size. */
  async setScreen(driver, { width, height }) {
    const window = driver.manage().window();
    for (let attempt = 0; ; attempt += 1) {
      const [wide, high] = await driver.executeScript('return [innerWidth, innerHeight]');
      if (wide === width && high === height) return;
      if (attempt === MOST_ATTEMPTS) throw new Error(`The page became ${wide} by ${high} pixels large instead of ${width} by ${height}.`);
      const outer = await window.getRect();
      // A window that is not shown yet has no size.
      if (outer.width < wide || outer.height < high) {
        await sleep(50);
        continue;
      }
      await window.setRect({ x: 0, y: 0, width: outer.width + width - wide, height: outer.height + height - high });
    }
  },

  async allowClipboard() {},
  consoleProblems: async () => [],
};
