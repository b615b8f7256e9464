// A desktop on which Orca, the screen reader of Linux, listens to a browser: on a screen without glass, without the settings and the
// services of whoever runs it. It needs a session bus of its own (`dbus-run-session`).

import { execFileSync, spawn } from 'node:child_process';
import { mkdir, mkdtemp, open, readFile, rm, writeFile } from 'node:fs/promises';
import os from 'node:os';
import path from 'node:path';
import { setTimeout as sleep } from 'node:timers/promises';
import { startXvfb } from '../engines/screen.mjs';
import { until } from '../page.mjs';

/** So long Orca does nothing before what it said is taken to be all: a polite message waits for 400 ms. */
const QUIET_MS = 1500;

/** Tells programs that somebody listens: else they say nothing. */
function announceScreenReader() {
  for (const name of ['IsEnabled', 'ScreenReaderEnabled']) {
    const set = ['--method', 'org.freedesktop.DBus.Properties.Set', 'org.a11y.Status', name, '<true>'];
    execFileSync('gdbus', ['call', '--session', '--dest', 'org.a11y.Bus', '--object-path', '/org/a11y/bus', ...set], { stdio: 'ignore' });
  }
}

/**
 * Starts it, and makes it the desktop of this process. `said` gives what Orca says until it says no more; `press` presses a key of the
 * keyboard, as xdotool calls it; `close` ends everything.
 */
export async function startDesktop() {
  const home = await mkdtemp(path.join(os.tmpdir(), 'speech-'));
  const log = path.join(home, 'orca.log');
  const settings = path.join(home, '.local/share/orca');
  await mkdir(settings, { recursive: true });
  await writeFile(log, '');
  // By itself Orca writes down what it says when that has become much.
  await writeFile(path.join(settings, 'orca-customizations.py'), `import orca.debug\norca.debug.debugFile = open(${JSON.stringify(log)}, "a", buffering=1)\n`);
  const { display, child } = await startXvfb();
  for (const name of Object.keys(process.env)) if (/^(XDG_|WAYLAND_)/.test(name)) delete process.env[name];
  const own = { HOME: home, DISPLAY: display, GDK_BACKEND: 'x11', MOZ_ENABLE_WAYLAND: '0', GSETTINGS_BACKEND: 'memory', XDG_SESSION_TYPE: 'x11' };
  Object.assign(process.env, own);
  announceScreenReader();
  const children = [child];
  const run = (program, ...words) => {
    const started = spawn(program, words, { stdio: 'ignore' });
    started.on('error', (error) => console.error(`${program} could not be started: ${error.message}`));
    children.push(started);
  };
  // Somebody has to give the keyboard to a window. Without keys of its own: Orca has those with which openbox moves windows about.
  const windows = path.join(home, 'openbox.xml');
  await writeFile(windows, '<openbox_config xmlns="http://openbox.org/3.4/rc"><keyboard/></openbox_config>');
  run('openbox', '--config-file', windows);
  run('orca', '--replace', '--disable=braille', `--debug-file=${log}`);
  await until('Orca', async () => /SPEECH: Initialized/.test(await readFile(log, 'utf8')));
  const file = await open(log);
  const close = async () => {
    await file.close();
    children.reverse().forEach((one) => one.kill());
    await rm(home, { recursive: true, force: true, maxRetries: 5 });
  };
  const press = (key) => execFileSync('xdotool', ['key', key]);
  return { said: () => said(file), press, close };
}

/** What Orca says from where `file` has been read to, once it has been quiet. */
async function said(file) {
  let text = '';
  const more = async () => {
    const { buffer, bytesRead } = await file.read({ buffer: Buffer.alloc(1 << 20) });
    text += buffer.toString('utf8', 0, bytesRead);
    return bytesRead > 0;
  };
  for (let quietMs = 0; quietMs < QUIET_MS; quietMs += 100) {
    await sleep(100);
    if (await more()) quietMs = 0;
  }
  const words = [...text.matchAll(/SPEECH OUTPUT: '(.*)'(?:\[?\{.*)?$/gm)].map(([, one]) => one.trim());
  return words.filter(Boolean);
}
