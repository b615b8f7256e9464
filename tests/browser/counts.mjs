// A reporter for node's test runner: how many tests passed, which failed, and which were left out and why, as JSON.

export default async function* counts(events) {
  const seen = { passed: 0, failed: [], leftOut: [] };
  for await (const { type, data } of events) {
    // A file is told as a test as well; it fails by itself where it cannot be read.
    if (!['test:pass', 'test:fail'].includes(type) || (type === 'test:pass' && data.name.endsWith('.mjs'))) continue;
    if (typeof data.skip === 'string') seen.leftOut.push({ name: data.name, why: data.skip });
    else if (data.skip !== undefined && data.skip !== false) seen.leftOut.push({ name: data.name, why: 'no reason is given' });
    else if (type === 'test:fail') seen.failed.push(data.name);
    else seen.passed += 1;
  }
  yield JSON.stringify(seen);
}
