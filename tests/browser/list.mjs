// Prints every test of the files that are named: the file, a tab, the name. No browser is started.

import path from 'node:path';
import { pathToFileURL } from 'node:url';

process.env.BROWSER_TESTS = JSON.stringify({ engine: 'chromium', lists: true });
const { listed } = await import('./harness.mjs');
for (const file of process.argv.slice(2)) {
  await import(pathToFileURL(path.resolve(file)));
  for (const name of listed.splice(0)) console.log(`${file}\t${name}`);
}
