// The browsers that the tests run in, and what differs between them.

import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { createServer } from 'node:http';
import net from 'node:net';
import { setTimeout as sleep } from 'node:timers/promises';
import { Builder, Capabilities } from 'selenium-webdriver';
import LogInspector from 'selenium-webdriver/bidi/logInspector.js';
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

const chromium = {
  /** What the engine cannot do under WebDriver, and why: a test that needs it is skipped with these words. */
  cannot: {},
  /** What `without` it can do without by itself. */
  switchesOff: ['webgl'],

  driver: process.env.CHROMEDRIVER ?? 'chromedriver',
  driverArguments: (port) => [`--port=${port}`],
  /** What it asks of its maker, whichever page is open. */
  ownRequests: /^CONNECT (\w+\.google|(content-autofill|optimizationguide-pa|safebrowsing)\.googleapis)\.com:443$/,

  /**
   * `without`: 'webgl' or 'webassembly', for a browser that lacks it; `scale`: device pixels in a CSS pixel; `proxy`: the port on
   * this computer that everything goes through which is meant for another.
   */
  capabilities({ without, scale = 1, proxy }) {
    // An emulated scale would not reach the ResizeObserver, by which the canvas gets its size.
    const args = [...CHROMIUM_ARGUMENTS, `--force-device-scale-factor=${scale}`, `--proxy-server=http://127.0.0.1:${proxy}`];
    if (without === 'webgl') args.push('--disable-3d-apis');
    return new Capabilities({
      browserName: 'chrome',
      'goog:chromeOptions': {
        args,
        ...(process.env.CHROMIUM && { binary: process.env.CHROMIUM }),
      },
      'goog:loggingPrefs': { browser: 'ALL' },
    });
  },

  /** What `capabilities` cannot say. */
  async prepare() {},

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
    const entries = await driver.manage().logs().get('browser');
    return entries.filter((entry) => entry.level.value >= 900).map((entry) => entry.message);
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

const firefox = {
  cannot: {
    'say what keeps a page from being installed': LACKS_A_COMMAND,
  },
  switchesOff: ['webgl', 'webassembly'],
  ownRequests: /\.(mozilla|firefox)\.(com|org|net)[:/]/,
  // Without a screen it has no WebGL.
  needsScreen: true,
  driver: process.env.GECKODRIVER ?? 'geckodriver',
  // The last argument is for `inFirefox`.
  driverArguments: (port, otherPort) => ['--port', `${port}`, '--websocket-port', `${otherPort}`, '--allow-system-access'],

  capabilities({ without, scale = 1, proxy }) {
    return new Capabilities({
      browserName: 'firefox',
      // For its console.
      webSocketUrl: true,
      proxy: { proxyType: 'manual', httpProxy: `127.0.0.1:${proxy}`, sslProxy: `127.0.0.1:${proxy}` },
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
    driver.problems = [];
    const inspector = await LogInspector(driver);
    await inspector.onLog(({ level, text }) => ['warn', 'error'].includes(level) && driver.problems.push(text));
    await driver.manage().window().setRect({ x: 0, y: 0, width: 1900, height: 1300 });
  },

  async setScreen(driver, { width, height, dark = false }) {
    // The window has a least width, the page in it has none.
    const script = `
      const [width, height, dark] = arguments;
      Services.prefs.setIntPref('ui.systemUsesDarkTheme', dark ? 1 : 0);
      gBrowser.selectedBrowser.style.cssText = \`min-width: 0; max-width: \${width}px; max-height: \${height}px\``;
    await inFirefox(driver, script, width, height, dark);
  },

  async chooseColours(driver) {
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

const webkit = {
  cannot: {
    'show a page as narrow as a phone': 'its window is at least 447 pixels wide',
    'read the clipboard': 'MiniBrowser refuses the clipboard to every page and has no way to allow it',
    'leave a page with Tab': 'MiniBrowser goes on with the first element of the page, whichever page it is',
    'choose the colour scheme': 'MiniBrowser takes it from the desktop',
    'choose the colours': 'WebKit has no such mode',
    touch: 'its driver makes a mouse of a finger',
    'make its window lower': 'WebKitWebDriver calls the height of 420 pixels invalid',
    'read the console': LACKS_A_LOG,
    'switch scripts off': LACKS_A_COMMAND,
    'say what keeps a page from being installed': LACKS_A_COMMAND,
  },
  switchesOff: [],
  // MiniBrowser has no mode without a window.
  needsScreen: true,
  driver: process.env.WEBKITDRIVER ?? 'WebKitWebDriver',
  driverArguments: (port) => [`--port=${port}`],

  capabilities({ proxy }) {
    const binary = process.env.MINIBROWSER;
    return new Capabilities({
      browserName: 'MiniBrowser',
      // With a proxy of WebDriver's, one start in five hangs.
      'webkitgtk:browserOptions': {
        args: ['--automation', `--proxy=http://127.0.0.1:${proxy}`, '--ignore-host=127.0.0.1'],
        ...(binary && { binary }),
      },
    });
  },

  async prepare() {},
  setScreen: setPageSize,
  async allowClipboard() {},
  consoleProblems: async () => [],
};

/** By name. The environment variable ENGINE chooses. What an engine `cannot` do, it has no function for, or one without effect. */
const ENGINES = { chromium, firefox, webkit };

/** An X server without a screen, if there is none: its environment, and how to end it. */
async function startScreen() {
  if (process.platform !== 'linux' || process.env.DISPLAY) return { environment: { ...process.env }, close() {} };
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

/** A proxy that passes nothing on, and keeps what it was asked for in `asked`, except what is `expected`. */
async function startProxy(expected = /^$/) {
  const asked = [];
  const refuse = (request, answer) => {
    const asks = `${request.method} ${request.url}`;
    if (!expected.test(asks)) asked.push(asks);
    answer();
  };
  const server = createServer((request, response) => refuse(request, () => response.writeHead(502).end()));
  // https, and sockets.
  server.on('connect', (request, socket) => {
    // A browser that is ended hangs up on it.
    socket.on('error', () => {});
    refuse(request, () => socket.end('HTTP/1.1 502 Bad Gateway\r\n\r\n'));
  });
  server.listen(0, '127.0.0.1');
  await once(server, 'listening');
  const close = () => {
    server.closeAllConnections();
    server.close();
  };
  return { asked, port: server.address().port, close };
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
  const [port, otherPort] = [await freePort(), await freePort()];
  const url = `http://127.0.0.1:${port}`;
  const child = spawn(engine.driver, engine.driverArguments(port, otherPort), { stdio: 'ignore', env: environment });
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
  const screen = engine.needsScreen ? await startScreen() : { environment: { ...process.env }, close() {} };
  // The services of a desktop, of which none may be there, are not waited for.
  Object.assign(screen.environment, { DBUS_SESSION_BUS_ADDRESS: 'disabled:', NO_AT_BRIDGE: '1' });
  const proxy = await startProxy(engine.ownRequests);
  let running = await startDriver(engine, screen.environment);
  const renew = async () => {
    running.close('SIGKILL');
    running = await startDriver(engine, screen.environment);
  };

  return {
    name,
    engine,
    /** `elsewhere`, on the driver, lists what has been asked of other computers since. */
    async open(options) {
      for (let attempt = 1; attempt <= ATTEMPTS; attempt += 1) {
        const builder = new Builder().disableEnvironmentOverrides().usingServer(running.url);
        const driver = await inTime(builder.withCapabilities(engine.capabilities({ ...options, proxy: proxy.port })).build());
        if (driver) {
          await engine.prepare(driver);
          proxy.asked.length = 0;
          return Object.assign(driver, { elsewhere: proxy.asked });
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
      proxy.close();
      screen.close();
    },
  };
}
