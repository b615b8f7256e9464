// Starts the browser that the tests run in.

import { spawn } from 'node:child_process';
import { once } from 'node:events';
import net from 'node:net';
import { setTimeout as sleep } from 'node:timers/promises';
import { Builder } from 'selenium-webdriver';
import { settings } from '../settings.mjs';
import { chromium } from './chromium.mjs';
import { firefox } from './firefox.mjs';
import { startProxy } from './proxy.mjs';
import { startScreen } from './screen.mjs';
import { webkit } from './webkit.mjs';

/** By name. What an engine `cannot` do, it has no function for, or one without effect. */
export const ENGINES = { chromium, firefox, webkit };

/** Long for a browser to start or to end, even where much else runs. WebKitWebDriver, once in some hundred times, answers neither. */
const PATIENCE_MS = 120_000;
const ATTEMPTS = 3;

/** What `work` comes to; undefined if that takes too long. */
function inTime(work) {
  return Promise.race([work, sleep(PATIENCE_MS, undefined, { ref: false })]);
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
  const end = Date.now() + PATIENCE_MS;
  while (Date.now() < end) {
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

/** A driver that listens: where, and how to end it. A port that is free now may be somebody else's a moment later. */
async function startDriver(engine, environment) {
  for (let attempt = 1; ; attempt += 1) {
    try {
      return await tryDriver(engine, environment);
    } catch (error) {
      if (attempt === ATTEMPTS) throw error;
    }
  }
}

async function tryDriver(engine, environment) {
  const [port, otherPort] = [await freePort(), await freePort()];
  const url = `http://127.0.0.1:${port}`;
  // A group of its own, so that the browser ends with its driver even where that is killed.
  const detached = process.platform !== 'win32';
  const child = spawn(settings.driver, engine.driverArguments(port, otherPort), { stdio: 'ignore', env: environment, detached });
  const failed = once(child, 'error').then(([error]) => {
    throw new Error(`${settings.driver} could not be started: ${error.message}`);
  });
  const ended = once(child, 'exit').then(([code]) => {
    throw new Error(`${settings.driver} ended at once with exit code ${code}.`);
  });
  // Later it ends because the tests do.
  ended.catch(() => {});
  failed.catch(() => {});
  if (!(await Promise.race([answers(url), failed, ended]))) throw new Error(`${settings.driver} does not answer.`);
  const close = (signal) => {
    try {
      if (detached) process.kill(-child.pid, signal);
      else child.kill(signal);
    } catch {
      // It has ended.
    }
  };
  return { url, close };
}

/** A new tab, and no other: nothing of the page before is left. */
async function openTab(driver) {
  const before = await driver.getAllWindowHandles();
  await driver.switchTo().newWindow('tab');
  const tab = await driver.getWindowHandle();
  for (const handle of before) {
    await driver.switchTo().window(handle);
    await driver.close();
  }
  await driver.switchTo().window(tab);
}

/** Starts the driver of the chosen engine. `open` gives a browser with one empty tab; `close` ends everything. */
export async function startEngine() {
  const engine = ENGINES[settings.engine];
  const screen = await startScreen(engine.needsScreen);
  const proxy = await startProxy();
  let running = await startDriver(engine, screen.environment);
  /** The browser that runs, and the options that it was started with. */
  let open = null;

  const renew = async () => {
    running.close('SIGKILL');
    running = await startDriver(engine, screen.environment);
  };
  const end = async () => {
    const ended = !open || (await inTime(open.driver.quit().then(() => true, () => false)));
    open = null;
    if (!ended) await renew();
  };
  const start = async (options) => {
    for (let attempt = 1; attempt <= ATTEMPTS; attempt += 1) {
      const capabilities = engine.capabilities({ ...options, browser: settings.browser, proxy: proxy.port });
      const builder = new Builder().disableEnvironmentOverrides().usingServer(running.url).withCapabilities(capabilities);
      const driver = await inTime(builder.build());
      if (driver) {
        await driver.manage().setTimeouts({ script: PATIENCE_MS, pageLoad: PATIENCE_MS });
        await engine.prepare(driver);
        return driver;
      }
      await renew();
    }
    throw new Error(`${settings.engine} does not start.`);
  };

  return {
    engine,
    /** `elsewhere`, on the driver, lists what the page or its worker has asked of other computers since. */
    async open(options) {
      const key = JSON.stringify(options);
      if (open?.key !== key) {
        await end();
        open = { key, driver: await start(options) };
      } else if (!(await inTime(openTab(open.driver).then(() => true, () => false)))) {
        // It did not survive the last test.
        await end();
        open = { key, driver: await start(options) };
      }
      await engine.reset(open.driver);
      await engine.consoleProblems(open.driver);
      proxy.asked.length = 0;
      return Object.assign(open.driver, { elsewhere: proxy.asked });
    },
    async close() {
      await end();
      running.close();
      proxy.close();
      screen.close();
    },
  };
}
