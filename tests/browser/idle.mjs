// Measures what the page costs while nobody does anything, for `cargo xtask idle`: processor time of all processes of Chromium, for an
// empty page, for one with nothing but a loop of animation frames, and for the program at rest and with a blinking caret.

import { readdir, readFile } from 'node:fs/promises';
import { setTimeout as sleep } from 'node:timers/promises';
import { startBench, until } from './page.mjs';

const SECONDS = Number(process.env.IDLE_SECONDS ?? 20);
/** What a page does when it is opened is over by then. */
const SETTLED_MS = 5000;
/** Above an empty page, in percent of a core. */
const GOALS = { 'the program at rest': 0.5, 'the program with a caret': 2 };

/** Processor time, in clock ticks, of this process's descendants: the driver, the browser and all of its processes. */
async function ticks() {
  const stats = [];
  for (const name of await readdir('/proc')) {
    if (!/^\d+$/.test(name)) continue;
    const text = await readFile(`/proc/${name}/stat`, 'utf8').catch(() => '');
    // Behind the name of the program, which may hold anything.
    const fields = text.slice(text.lastIndexOf(')') + 2).split(' ');
    if (fields.length > 12) stats.push({ pid: Number(name), parent: Number(fields[1]), ticks: Number(fields[11]) + Number(fields[12]) });
  }
  const inside = new Set([process.pid]);
  for (let before = 0; before !== inside.size; ) {
    before = inside.size;
    for (const { pid, parent } of stats) if (inside.has(parent)) inside.add(pid);
  }
  return stats.filter(({ pid }) => pid !== process.pid && inside.has(pid)).reduce((sum, one) => sum + one.ticks, 0);
}

const TICKS_PER_SECOND = 100;

async function measured(open) {
  await open();
  await sleep(SETTLED_MS);
  const before = await ticks();
  await sleep(SECONDS * 1000);
  return ((await ticks()) - before) / TICKS_PER_SECOND / SECONDS * 100;
}

const bench = await startBench();
let failed = false;
try {
  const page = await bench.page(undefined);
  const { added } = bench.server.state;
  added.set('empty.html', '<!doctype html><title>Empty</title>');
  added.set('loop.html', '<!doctype html><title>Loop</title><script>const loop = () => requestAnimationFrame(loop); loop();</script>');
  const other = (name) => () => page.driver.get(`${page.server.url}${name}`);
  const pages = {
    'an empty page': other('empty.html'),
    'a page with nothing but a loop of animation frames': other('loop.html'),
    'the program at rest': async () => {
      await page.start();
      await page.run('document.activeElement.blur()');
    },
    'the program with a caret': async () => {
      await page.start();
      const field = await page.field('Focal length (fx)');
      await page.run('arguments[0].focus()', field);
      await until('the focus', () => page.run('return document.activeElement === arguments[0]', field));
    },
  };
  let empty;
  for (const [name, open] of Object.entries(pages)) {
    const percent = await measured(open);
    empty ??= percent;
    const goal = GOALS[name];
    const isOver = goal !== undefined && percent > empty + goal;
    failed ||= isOver;
    console.log(`${percent.toFixed(2).padStart(6)} % of a core: ${name}${goal ? ` (at most ${goal} more than empty${isOver ? ': MISSED' : ''})` : ''}`);
  }
} finally {
  await bench.close();
}
process.exitCode = failed ? 1 : 0;
