// Prints what a screen reader says of the page, for `cargo xtask speech`, and compares it with what it said before: ENGINE.txt beside this
// file. With `SPEECH_UPDATE` it writes that file anew.

import { readFile, writeFile } from 'node:fs/promises';
import { startBench } from '../page.mjs';
import { settings } from '../settings.mjs';
import { startDesktop } from './desktop.mjs';
import { steps } from './steps.mjs';

const FILE = new URL(`${settings.engine}.txt`, import.meta.url);
/** What Orca says of the loading of any page and of what the focus has left, in an order that chance decides. */
const OF_THE_BROWSER = /^(Loading\.|Finished loading|document web|.* document web\.$|\d+ percent\.|leaving )/;

/** What was said, without what is selected: that is said with the field, after it or not at all, as chance has it. */
function lasting(words) {
  const isOfSelection = (one, next) => one === 'selected' || next === 'selected' || one === 'Selection deleted.';
  const rest = words.filter((one, at) => !OF_THE_BROWSER.test(one) && !isOfSelection(one, words[at + 1]));
  return rest.map((one) => one.replace(/(?<!^not) selected\.$/, '.'));
}

/** Everything that was said, with what was done before it. */
async function listen() {
  const desktop = await startDesktop();
  let bench;
  try {
    bench = await startBench();
    const page = await bench.page(undefined);
    // Of the browser's own window.
    await desktop.said();
    const lines = [];
    for (const [what, act] of steps(page, desktop.press)) {
      await act();
      const heard = [`> ${what}`, ...lasting(await desktop.said()).map((one) => `  ${one}`)];
      console.log(heard.join('\n'));
      lines.push(...heard);
    }
    return `${lines.join('\n')}\n`;
  } finally {
    await bench?.close();
    await desktop.close();
  }
}

const now = await listen();
if (process.env.SPEECH_UPDATE) {
  await writeFile(FILE, now);
} else {
  const before = await readFile(FILE, 'utf8');
  const [old, fresh] = [before, now].map((text) => text.split('\n'));
  const at = fresh.findIndex((line, index) => line !== old[index]);
  if (now !== before) {
    const step = fresh.slice(0, at + 1).findLast((line) => line.startsWith('>'));
    console.log(`\nDifferent after “${step}”: said is “${(fresh[at] ?? '').trim()}”, expected was “${(old[at] ?? '').trim()}”.`);
    console.log('If it is as good or better, `cargo xtask speech --update` writes it down.');
    process.exitCode = 1;
  }
}
// A service of the desktop may hold on to this process.
process.exit();
