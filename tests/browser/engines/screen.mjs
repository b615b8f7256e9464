// A screen for browsers that draw nothing without one.

import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { access } from 'node:fs/promises';
import path from 'node:path';
import { settings } from '../settings.mjs';

const ATTEMPTS = 2;

async function isOnPath(program) {
  const folders = (process.env.PATH ?? '').split(path.delimiter);
  const found = await Promise.all(folders.map((folder) => access(path.join(folder, program)).then(() => true, () => false)));
  return found.includes(true);
}

/** An X server without glass: the number of its display, and the process. */
export async function startXvfb() {
  const child = spawn('Xvfb', ['-displayfd', '3', '-screen', '0', '2000x1400x24', '-nolisten', 'tcp', '-noreset'], {
    stdio: ['ignore', 'ignore', 'pipe', 'pipe'],
  });
  let words = '';
  child.stderr.on('data', (piece) => (words += piece));
  const failed = once(child, 'error').then(([error]) => {
    throw new Error(`Xvfb could not be started: ${error.message}`);
  });
  const ended = once(child, 'exit').then(([code]) => {
    throw new Error(`Xvfb ended at once with exit code ${code}: ${words.trim()}`);
  });
  // Later it ends because the tests do.
  ended.catch(() => {});
  failed.catch(() => {});
  const [display] = await Promise.race([once(child.stdio[3], 'data'), failed, ended]);
  return { display: `:${display.toString().trim()}`, child };
}

/**
 * The environment of a browser, and how to end its screen. On Linux, where Xvfb is there, no window ever opens on the screen of
 * whoever runs the tests.
 */
export async function startScreen(isNeeded) {
  // Whoever listens has a desktop and a screen of their own, which the browser is to be told of.
  if (settings.isHeard) return { environment: process.env, close() {} };
  // The services of a desktop, of which none may be there, are not waited for.
  const environment = { ...process.env, DBUS_SESSION_BUS_ADDRESS: 'disabled:', NO_AT_BRIDGE: '1' };
  if (process.platform !== 'linux' || !isNeeded) return { environment, close() {} };
  if (!(await isOnPath('Xvfb'))) {
    if (environment.DISPLAY || environment.WAYLAND_DISPLAY) return { environment, close() {} };
    throw new Error('A browser needs a screen, and there is neither one nor Xvfb.');
  }
  delete environment.WAYLAND_DISPLAY;
  delete environment.WAYLAND_SOCKET;
  for (let attempt = 1; ; attempt += 1) {
    try {
      const { display, child } = await startXvfb();
      return { environment: { ...environment, DISPLAY: display, GDK_BACKEND: 'x11', MOZ_ENABLE_WAYLAND: '0' }, close: () => child.kill() };
    } catch (error) {
      if (attempt === ATTEMPTS) throw error;
    }
  }
}
