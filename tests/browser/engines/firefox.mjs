// Firefox, through geckodriver.

import { Capabilities } from 'selenium-webdriver';
import LogInspector from 'selenium-webdriver/bidi/logInspector.js';
import { Command } from 'selenium-webdriver/lib/command.js';

/** Settings that tests change. */
const CHANGED = ['ui.systemUsesDarkTheme', 'browser.display.document_color_use', 'javascript.enabled'];

/** Runs a script in Firefox itself, where its settings are, instead of in the page. */
async function inFirefox(driver, script, ...values) {
  const useContext = (context) => driver.execute(new Command('setContext').setParameter('context', context));
  await useContext('chrome');
  try {
    return await driver.executeScript(script, ...values);
  } finally {
    await useContext('content');
  }
}

export const firefox = {
  cannot: {
    'imitate a phone': 'its driver has no such command',
    'say what keeps a page from being installed': 'its driver has no such command',
  },
  switchesOff: ['webgl', 'webassembly'],
  // Without a screen it has no WebGL.
  needsScreen: true,
  // The last argument is for `inFirefox`.
  driverArguments: (port, otherPort) => ['--port', `${port}`, '--websocket-port', `${otherPort}`, '--allow-system-access'],

  capabilities({ browser, without, scale = 1, proxy }) {
    return new Capabilities({
      browserName: 'firefox',
      // For its console.
      webSocketUrl: true,
      // So that the proxy can read what is asked of others by https.
      acceptInsecureCerts: true,
      proxy: { proxyType: 'manual', httpProxy: `127.0.0.1:${proxy}`, sslProxy: `127.0.0.1:${proxy}` },
      'moz:firefoxOptions': {
        binary: browser,
        prefs: {
          // WebGL without a graphics card.
          'webgl.force-enabled': true,
          'webgl.disabled': without === 'webgl',
          'javascript.options.wasm': without !== 'webassembly',
          'layout.css.devPixelsPerPx': `${scale}`,
          // As if somebody had allowed the page to read the clipboard.
          'dom.events.testing.asyncClipboard': true,
          // Tab stops at every control, whatever the desktop says.
          'accessibility.tabfocus': 7,
          // The page may say who asks, also where others are asked: by that it is told from Firefox itself.
          'network.http.referer.disallowCrossSiteRelaxingDefault': false,
          // As little traffic of its own as there can be.
          'app.normandy.enabled': false,
          'services.settings.server': 'data:,',
          'network.captive-portal-service.enabled': false,
          'network.connectivity-service.enabled': false,
        },
      },
    });
  },

  async prepare(driver) {
    driver.getExecutor().defineCommand('setContext', 'POST', '/session/:sessionId/moz/context');
    driver.problems = [];
    const inspector = await LogInspector(driver);
    await inspector.onLog(({ level, text }) => ['warn', 'error'].includes(level) && driver.problems.push(text));
    await driver.manage().window().setRect({ x: 0, y: 0, width: 1900, height: 1300 });
  },

  async reset(driver) {
    // The keyboard may have been left to the browser's own controls.
    await inFirefox(driver, 'for (const name of arguments[0]) Services.prefs.clearUserPref(name); gBrowser.selectedBrowser.focus()', CHANGED);
  },

  async setScreen(driver, { width, height, dark = false }) {
    // The window has a least width, the page in it has none.
    const script = `
      const [width, height, dark] = arguments;
      Services.prefs.setIntPref('ui.systemUsesDarkTheme', dark ? 1 : 0);
      gBrowser.selectedBrowser.style.cssText = \`min-width: 0; max-width: \${width}px; max-height: \${height}px\``;
    await inFirefox(driver, script, width, height, dark);
  },

  async chooseColors(driver) {
    await inFirefox(driver, "Services.prefs.setIntPref('browser.display.document_color_use', 2)");
  },

  async allowScripts(driver, allowed) {
    await inFirefox(driver, "Services.prefs.setBoolPref('javascript.enabled', arguments[0])", allowed);
  },

  async allowClipboard() {},

  async consoleProblems(driver) {
    // What comes by the same way as this answer has come before it.
    await (await driver.getBidi()).send({ method: 'session.status', params: {} });
    return driver.problems.splice(0);
  },
};
