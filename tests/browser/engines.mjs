// The browsers that the tests run in, and what differs between them.

import { spawn } from 'node:child_process';
import { once } from 'node:events';
import net from 'node:net';
import { setTimeout as sleep } from 'node:timers/promises';
import { Builder, Capabilities } from 'selenium-webdriver';
import { Command } from 'selenium-webdriver/lib/command.js';

const CHROMIUM_ARGUMENTS = [
  '--headless=new',
  '--no-sandbox',
  // WebGL without a graphics card.
  '--enable-unsafe-swiftshader',
  '--use-angle=swiftshader',
  // No traffic but the page's own.
  '--disable-quic',
  '--no-first-run',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-sync',
];

/** What chromedriver records, one entry per message. */
async function chromiumLog(driver, name) {
  return driver.manage().logs().get(name);
}

const chromium = {
  /** What the engine cannot do under WebDriver, and why: a test that needs it is skipped with these words. */
  cannot: {},

  driver: process.env.CHROMEDRIVER ?? 'chromedriver',
  driverArguments: (port) => [`--port=${port}`],

  /** `without`: 'webgl' or 'webassembly', for a browser that lacks it; `scale`: device pixels in a CSS pixel. */
  capabilities({ without, scale = 1 } = {}) {
    // An emulated scale would not reach the ResizeObserver, by which the canvas gets its size.
    const args = [...CHROMIUM_ARGUMENTS, `--force-device-scale-factor=${scale}`];
    if (without === 'webgl') args.push('--disable-3d-apis');
    return new Capabilities({
      browserName: 'chrome',
      'goog:chromeOptions': {
        args,
        ...(process.env.CHROMIUM && { binary: process.env.CHROMIUM }),
      },
      'goog:loggingPrefs': { browser: 'ALL', performance: 'ALL' },
    });
  },

  /** What `capabilities` cannot say. */
  async prepare(driver, { without } = {}) {
    if (without === 'webassembly') {
      await driver.sendDevToolsCommand('Page.addScriptToEvaluateOnNewDocument', { source: 'delete globalThis.WebAssembly' });
    }
  },

  /** Gives the page a size in CSS pixels and a colour scheme. */
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

  /** As if somebody had chosen colours for everything on the screen. */
  async chooseColours(driver) {
    await driver.sendDevToolsCommand('Emulation.setEmulatedMedia', { features: [{ name: 'forced-colors', value: 'active' }] });
  },

  async allowScripts(driver, allowed) {
    await driver.sendDevToolsCommand('Emulation.setScriptExecutionDisabled', { value: !allowed });
  },

  /** Runs a script at the start of every page that is loaded from now on. */
  async onEveryPage(driver, source) {
    await driver.sendDevToolsCommand('Page.addScriptToEvaluateOnNewDocument', { source });
  },

  /** What keeps the page from being installed as a program. */
  async installProblems(driver) {
    const { installabilityErrors } = await driver.sendAndGetDevToolsCommand('Page.getInstallabilityErrors', {});
    return installabilityErrors.map(({ errorId }) => errorId);
  },

  async allowClipboard(driver, origin) {
    await driver.sendDevToolsCommand('Browser.grantPermissions', {
      origin,
      permissions: ['clipboardReadWrite', 'clipboardSanitizedWrite'],
    });
  },

  /** Errors and warnings on the console since the last call. */
  async consoleProblems(driver) {
    const entries = await chromiumLog(driver, 'browser');
    return entries.filter((entry) => entry.level.value >= 900).map((entry) => entry.message);
  },

  /** The address of every request since the last call, whoever made it. */
  async requests(driver) {
    const messages = (await chromiumLog(driver, 'performance')).map((entry) => JSON.parse(entry.message).message);
    return messages.flatMap(({ method, params }) => {
      if (method === 'Network.requestWillBeSent') return [params.request.url];
      if (method === 'Network.webSocketCreated') return [params.url];
      return [];
    });
  },
};

/** Changes the window until the page in it has this size: WebDriver knows only the outer size. */
async function setPageSize(driver, { width, height }) {
  const window = driver.manage().window();
  for (let attempt = 0; ; attempt += 1) {
    const [wide, high] = await driver.executeScript('return [innerWidth, innerHeight]');
    if (wide === width && high === height) return;
    if (attempt === 5) throw new Error(`The page became ${wide} by ${high} pixels large instead of ${width} by ${height}.`);
    const outer = await window.getRect();
    await window.setRect({ x: 0, y: 0, width: outer.width + width - wide, height: outer.height + height - high });
  }
}

const LACKS_A_LOG = 'its driver gives no log';
const LACKS_A_COMMAND = 'its driver has no such command';

const firefox = {
  cannot: {
    'show a page as narrow as a phone': 'its window is at least 450 pixels wide',
    'read the console': LACKS_A_LOG,
    'list every request': LACKS_A_LOG,
    'run a script before the page': 'that needs WebDriver BiDi, which these tests do not speak',
    'choose the colours': 'it takes them from the desktop',
    'switch scripts off': LACKS_A_COMMAND,
    'say what keeps a page from being installed': LACKS_A_COMMAND,
  },
  // Without a screen it has no WebGL.
  needsScreen: true,
  driver: process.env.GECKODRIVER ?? 'geckodriver',
  // The last argument: the colour scheme is a setting of the browser, not of the page.
  driverArguments: (port) => ['--port', `${port}`, '--allow-system-access'],

  capabilities({ without, scale = 1 } = {}) {
    return new Capabilities({
      browserName: 'firefox',
      'moz:firefoxOptions': {
        ...(process.env.FIREFOX && { binary: process.env.FIREFOX }),
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
          // No traffic but the page's own.
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
  },

  async setScreen(driver, screen) {
    const useContext = (context) => driver.execute(new Command('setContext').setParameter('context', context));
    await useContext('chrome');
    await driver.executeScript("Services.prefs.setIntPref('ui.systemUsesDarkTheme', arguments[0])", screen.dark ? 1 : 0);
    await useContext('content');
    await setPageSize(driver, screen);
  },

  async allowClipboard() {},
  consoleProblems: async () => [],
  requests: async () => [],
};

const webkit = {
  cannot: {
    'show a page as narrow as a phone': 'its window is at least 447 pixels wide',
    'read the clipboard': 'MiniBrowser refuses the clipboard to every page and has no way to allow it',
    'leave a page with Tab': 'MiniBrowser goes on with the first element of the page, whichever page it is',
    'choose the colour scheme': 'MiniBrowser takes it from the desktop',
    'choose the colours': 'WebKit has no such mode',
    'take its clock from a window': 'it keeps window.performance, whatever a page defines',
    'make its window lower': 'WebKitWebDriver calls the height of 420 pixels invalid',
    'go without WebGL or WebAssembly': 'MiniBrowser cannot switch them off',
    'read the console': LACKS_A_LOG,
    'list every request': LACKS_A_LOG,
    'run a script before the page': LACKS_A_COMMAND,
    'switch scripts off': LACKS_A_COMMAND,
    'say what keeps a page from being installed': LACKS_A_COMMAND,
  },
  // MiniBrowser has no mode without a window.
  needsScreen: true,
  driver: process.env.WEBKITDRIVER ?? 'WebKitWebDriver',
  driverArguments: (port) => [`--port=${port}`],

  capabilities() {
    const binary = process.env.MINIBROWSER;
    return new Capabilities({
      browserName: 'MiniBrowser',
      'webkitgtk:browserOptions': { args: ['--automation'], ...(binary && { binary }) },
    });
  },

  async prepare() {},
  setScreen: setPageSize,
  async allowClipboard() {},
  consoleProblems: async () => [],
  requests: async () => [],
};

/** By name. The environment variable ENGINE chooses. What an engine `cannot` do, it has no function for, or one without effect. */
const ENGINES = { chromium, firefox, webkit };

/** An X server without a screen, if there is none: its environment, and how to end it. */
async function startScreen() {
  if (process.platform !== 'linux' || process.env.DISPLAY) return { environment: process.env, close() {} };
  const child = spawn('Xvfb', ['-displayfd', '3', '-screen', '0', '2000x1400x24', '-nolisten', 'tcp'], {
    stdio: ['ignore', 'ignore', 'ignore', 'pipe'],
  });
  const failed = once(child, 'error').then(([error]) => {
    throw new Error(`Xvfb could not be started: ${error.message}`);
  });
  const ended = once(child, 'exit').then(() => {
    throw new Error('Xvfb ended at once.');
  });
  // Later it ends because the tests do.
  ended.catch(() => {});
  const [display] = await Promise.race([once(child.stdio[3], 'data'), failed, ended]);
  return { environment: { ...process.env, DISPLAY: `:${display.toString().trim()}` }, close: () => child.kill() };
}

async function freePort() {
  const server = net.createServer().listen(0, '127.0.0.1');
  await once(server, 'listening');
  const { port } = server.address();
  server.close();
  await once(server, 'close');
  return port;
}

async function answers(url) {
  for (let attempt = 0; attempt < 100; attempt += 1) {
    try {
      const status = await (await fetch(`${url}/status`)).json();
      if (status.value.ready) return true;
    } catch {
      // Not listening yet.
    }
    await sleep(100);
  }
  return false;
}

/** Long for a browser to start or to end. WebKitWebDriver, once in some hundred times, answers neither. */
const PATIENCE_MS = 40_000;
const ATTEMPTS = 3;

/** What `work` comes to; undefined if that takes too long. */
function inTime(work) {
  return Promise.race([work, sleep(PATIENCE_MS, undefined, { ref: false })]);
}

/** A driver that listens: where, and how to end it. */
async function startDriver(engine, environment) {
  const port = await freePort();
  const url = `http://127.0.0.1:${port}`;
  const child = spawn(engine.driver, engine.driverArguments(port), { stdio: 'ignore', env: environment });
  const failed = once(child, 'error').then(([error]) => {
    throw new Error(`${engine.driver} could not be started: ${error.message}`);
  });
  if (!(await Promise.race([answers(url), failed]))) throw new Error(`${engine.driver} does not answer.`);
  return { url, close: (signal) => child.kill(signal) };
}

/** Starts the driver of the chosen engine. `open` starts a fresh browser with an empty profile; `close` ends the driver. */
export async function startEngine() {
  const name = process.env.ENGINE ?? 'chromium';
  const engine = ENGINES[name];
  if (!engine) throw new Error(`There is no engine "${name}"; there are ${Object.keys(ENGINES).join(', ')}.`);
  const screen = engine.needsScreen ? await startScreen() : { environment: process.env, close() {} };
  let running = await startDriver(engine, screen.environment);
  const renew = async () => {
    running.close('SIGKILL');
    running = await startDriver(engine, screen.environment);
  };

  return {
    name,
    engine,
    async open(options) {
      for (let attempt = 1; attempt <= ATTEMPTS; attempt += 1) {
        const builder = new Builder().disableEnvironmentOverrides().usingServer(running.url);
        const driver = await inTime(builder.withCapabilities(engine.capabilities(options)).build());
        if (driver) {
          await engine.prepare(driver, options);
          return driver;
        }
        await renew();
      }
      throw new Error(`${name} does not start.`);
    },
    /** Ends a browser that `open` has started. */
    async end(driver) {
      const ended = await inTime(driver.quit().then(() => true));
      if (!ended) await renew();
    },
    close() {
      running.close();
      screen.close();
    },
  };
}
