// Chromium and Google Chrome, through chromedriver.

import { Capabilities } from 'selenium-webdriver';
import { settings } from '../settings.mjs';

const ARGUMENTS = [
  // Without a window it tells assistive technology nothing.
  ...(settings.isHeard ? ['--force-renderer-accessibility'] : ['--headless=new']),
  '--no-sandbox',
  // WebGL without a graphics card.
  '--enable-unsafe-swiftshader',
  '--use-angle=swiftshader',
  // As little traffic of the browser's own as there can be. (What there still is, is not counted: see proxy.mjs.)
  '--disable-quic',
  '--no-first-run',
  '--no-pings',
  '--disable-background-networking',
  '--disable-client-side-phishing-detection',
  '--disable-component-update',
  '--disable-default-apps',
  '--disable-domain-reliability',
  '--disable-sync',
  '--metrics-recording-only',
  '--disable-features=AutofillServerCommunication,CertificateTransparencyComponentUpdater,MediaRouter,NetworkTimeServiceQuerying,OptimizationHints,Translate',
  '--host-resolver-rules=MAP * ~NOTFOUND , EXCLUDE 127.0.0.1',
  // So that the proxy can read what is asked of others by https.
  '--ignore-certificate-errors',
];

export const chromium = {
  /** What the engine cannot do under WebDriver, and why: a test that needs it is left out with these words. */
  cannot: {},
  /** What `without` it can do without by itself. */
  switchesOff: ['webgl'],

  driverArguments: (port) => [`--port=${port}`],

  /**
   * `without`: 'webgl' or 'webassembly', for a browser that lacks it; `scale`: device pixels in a CSS pixel; `proxy`: the port on
   * this computer that everything goes through which is meant for another.
   */
  capabilities({ browser, without, scale = 1, proxy }) {
    // An emulated scale would not reach the ResizeObserver, by which the canvas gets its size.
    const args = [...ARGUMENTS, `--force-device-scale-factor=${scale}`, `--proxy-server=http://127.0.0.1:${proxy}`];
    if (without === 'webgl') args.push('--disable-3d-apis');
    return new Capabilities({
      browserName: 'chrome',
      'goog:chromeOptions': { args, binary: browser },
      'goog:loggingPrefs': { browser: 'ALL' },
    });
  },

  /** What `capabilities` cannot say, once for each browser. */
  async prepare() {},

  /** Takes back what a test may have changed of the browser itself, which a new tab does not. */
  async reset(driver) {
    // The keyboard may have been left to the browser's own controls.
    await driver.sendDevToolsCommand('Page.bringToFront', {});
  },

  /** Gives the page a size in CSS pixels and a color scheme. */
  async setScreen(driver, { width, height, dark = false }) {
    await driver.sendDevToolsCommand('Emulation.setDeviceMetricsOverride', {
      width,
      height,
      deviceScaleFactor: 0,
      mobile: false,
    });
    await driver.sendDevToolsCommand('Emulation.setEmulatedMedia', {
      features: [{ name: 'prefers-color-scheme', value: dark ? 'dark' : 'light' }],
    });
  },

  /** Makes a phone of the page, as the device toolbar does: touch, and device pixels in name only. */
  async imitatePhone(driver, { width, height, scale }) {
    await driver.sendDevToolsCommand('Emulation.setDeviceMetricsOverride', { width, height, deviceScaleFactor: scale, mobile: true });
    await driver.sendDevToolsCommand('Emulation.setTouchEmulationEnabled', { enabled: true, maxTouchPoints: 5 });
  },

  /** What fingers do, in the words of the DevTools protocol: 'touchStart', 'touchMove', 'touchEnd', and where they are then. */
  async touch(driver, type, touchPoints) {
    await driver.sendAndGetDevToolsCommand('Input.dispatchTouchEvent', { type, touchPoints });
  },

  /** As if somebody had chosen colors for everything on the screen. */
  async chooseColors(driver) {
    await driver.sendDevToolsCommand('Emulation.setEmulatedMedia', { features: [{ name: 'forced-colors', value: 'active' }] });
  },

  async allowScripts(driver, allowed) {
    await driver.sendDevToolsCommand('Emulation.setScriptExecutionDisabled', { value: !allowed });
  },

  /** What keeps the page from being installed as a program. */
  async installProblems(driver) {
    const { installabilityErrors } = await driver.sendAndGetDevToolsCommand('Page.getInstallabilityErrors', {});
    return installabilityErrors.map(({ errorId }) => errorId);
  },

  /** Has downloads go into this folder, without a question. */
  async saveFilesIn(driver, folder) {
    await driver.sendDevToolsCommand('Browser.setDownloadBehavior', { behavior: 'allow', downloadPath: folder });
  },

  /** The page on paper of this size in inches, as PDF. */
  async print(driver, { paperWidth, paperHeight }) {
    const { data } = await driver.sendAndGetDevToolsCommand('Page.printToPDF', { paperWidth, paperHeight });
    return Buffer.from(data, 'base64');
  },

  /** Shows the page as it is on paper (`print`), or again as on the screen (empty). */
  async setMedia(driver, media) {
    await driver.sendDevToolsCommand('Emulation.setEmulatedMedia', { media });
  },

  async allowClipboard(driver, origin) {
    await driver.sendDevToolsCommand('Browser.grantPermissions', {
      origin,
      permissions: ['clipboardReadWrite', 'clipboardSanitizedWrite'],
    });
  },

  /** Errors and warnings on the console since the last call. */
  async consoleProblems(driver) {
    const entries = await driver.manage().logs().get('browser');
    return entries.filter((entry) => entry.level.value >= 900).map((entry) => entry.message);
  },
};
