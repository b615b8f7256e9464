// `it`, as node's test runner has it, with two more options: in which engines a test runs, and what an engine must be able to do.

import { after as nodeAfter, before as nodeBefore, test } from 'node:test';
import { ENGINES } from './engines/index.mjs';
import { current } from './page.mjs';
import { settings } from './settings.mjs';

/** For what no engine can do in another way than the others: texts, the program's own decisions, rules about HTML. */
export const ONE_ENGINE = ['chromium'];
/** For what takes long and hardly depends on the engine: in two that differ. */
export const TWO_ENGINES = ['chromium', 'firefox'];

const engine = ENGINES[settings.engine];
/** Names of the tests of the file that is being read, while tests are listed. */
export const listed = [];

/** What comes before and after the tests of a file. Without a test there is neither: node would do the first and never the second. */
const hooks = [];
export const before = (work) => hooks.push(() => nodeBefore(work));
export const after = (work) => hooks.push(() => nodeAfter(work));

/** Why the chosen engine cannot do this (a name in `cannot` of an engine), false if it can. */
export function unless(ability) {
  const reason = engine.cannot[ability];
  return reason !== undefined && `${settings.engine} cannot ${ability}: ${reason}`;
}

/**
 * Whether the program was broken by the compiler of WebKitGTK, in which one start in 200 reads beside its memory: the page has started it
 * again in the middle of the test, or says so. Nothing else is a reason to run a test again.
 */
async function isFaultOfCompiler(error) {
  if (!engine.breaksPrograms) return false;
  return /Out of bounds memory access|capacity overflow/.test(error.message) || (await whyStartedAgain()) !== null;
}

/** Why the program stopped on the page of this test, which did not mean it to; null if it did not. */
async function whyStartedAgain() {
  const { page } = current;
  return page === undefined || page.mayStartAgain ? null : page.whyStartedAgain();
}

/**
 * A test. `engines`: where it runs, everywhere if absent; elsewhere it does not exist. `needs`: what an engine must be able to do;
 * where it cannot, the test is left out by name.
 */
export function it(name, ...rest) {
  const run = rest.pop();
  const { engines, needs = [] } = rest.pop() ?? {};
  if (settings.lists) {
    listed.push(name);
    return;
  }
  if (engines && !engines.includes(settings.engine)) return;
  if (settings.names.length > 0 && !settings.names.includes(name)) return;
  for (const hook of hooks.splice(0)) hook();
  test(name, { skip: needs.map(unless).find(Boolean) ?? false }, async (context) => {
    try {
      await run(context);
      const why = engine.breaksPrograms ? null : await whyStartedAgain();
      if (why !== null) throw new Error(`The program stopped, and the page started it again: ${why}`);
    } catch (error) {
      if (!(await isFaultOfCompiler(error))) throw error;
      console.log(`Again, as the engine’s compiler has broken the program: ${name}\n${error.stack}`);
      await run(context);
    }
  });
}
