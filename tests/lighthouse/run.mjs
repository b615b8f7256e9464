// Audits the page with Lighthouse, several times as a desktop computer and as often as a phone, for `cargo xtask lighthouse`.
// Prints medians and what costs points. Fails below the scores in floors.json: those of speed only on a machine that is as fast as
// the one they were made for, by Lighthouse's own measure (benchmarkIndex); on a slower one they are reported.

import { readFile } from 'node:fs/promises';
import path from 'node:path';
import { launch } from 'chrome-launcher';
import lighthouse, { desktopConfig, defaultConfig } from 'lighthouse';
import { startServer } from './server.mjs';

if (!process.env.LIGHTHOUSE) throw new Error('Run this with `cargo xtask lighthouse`, which finds the browser and builds the page.');
/** The folder of the page, the browser, and how many audits there are for each device. */
const { dist: DIST, browser: BROWSER, runs: RUNS } = JSON.parse(process.env.LIGHTHOUSE);
/** What a machine's speed has a part in. */
const SPEED = 'performance';
const CONFIGS = { desktop: desktopConfig, mobile: defaultConfig };
const TIMES = ['first-contentful-paint', 'largest-contentful-paint', 'total-blocking-time', 'speed-index', 'interactive'];
/** An audit below this is shown as a cause. */
const GOOD = 0.9;
// No graphics card is asked for, so that every machine draws the same way.
const FLAGS = [
  '--headless=new',
  '--no-sandbox',
  '--enable-unsafe-swiftshader',
  '--use-angle=swiftshader',
  '--disable-quic',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-sync',
];

const median = (numbers) => [...numbers].sort((a, b) => a - b)[Math.floor(numbers.length / 2)];
const points = (category) => Math.round((category.score ?? 0) * 100);

/** One audit by a browser that has seen nothing before. */
async function audit(url, config) {
  const chrome = await launch({ chromePath: BROWSER, chromeFlags: FLAGS });
  try {
    const { lhr } = await lighthouse(url, { port: chrome.port, output: 'json', logLevel: 'error' }, config);
    if (lhr.runtimeError) throw new Error(`Lighthouse could not audit the page: ${lhr.runtimeError.message}`);
    // A page that only says why it cannot run is quick, too.
    const marks = lhr.audits['user-timings'].details.items.map(({ name }) => name);
    if (!marks.includes('first-frame')) throw new Error('The program did not start, so there is nothing to audit.');
    return lhr;
  } finally {
    chrome.kill();
  }
}

/** What keeps a category from 100, in words, the heaviest first. */
function causes(report, category) {
  const { auditRefs } = report.categories[category];
  return auditRefs
    .map(({ id, weight }) => ({ ...report.audits[id], weight }))
    .filter(({ score, weight }) => weight > 0 && score !== null && score < GOOD)
    .sort((a, b) => b.weight * (1 - b.score) - a.weight * (1 - a.score))
    .map(({ title, displayValue, score, weight, details }) => {
      const places = (details?.items ?? []).slice(0, 3).map((item) => item.node?.snippet ?? item.description ?? item.url).filter(Boolean);
      const lost = category === 'performance' ? ` (costs ${Math.round(weight * (1 - score))})` : '';
      return [`${title}${displayValue ? `: ${displayValue}` : ''}${lost}`, ...places.map((place) => `  ${place}`)].join('\n    ');
    });
}

/** Where the time of the main thread goes, and the longest tasks. */
function work(report) {
  const ms = (number) => `${Math.round(number)} ms`;
  const groups = (report.audits['mainthread-work-breakdown']?.details?.items ?? []).slice(0, 4);
  const tasks = (report.audits['long-tasks']?.details?.items ?? []).slice(0, 4);
  const phases = (report.audits['lcp-breakdown-insight']?.details?.items ?? []).flatMap(({ items }) => items ?? []);
  const element = report.audits['largest-contentful-paint-element']?.details?.items?.[0]?.items?.[0]?.node?.snippet;
  return [
    `largest contentful paint: ${element ?? 'of an unknown element'}: ${phases.filter(({ duration }) => duration).map(({ label, duration }) => `${label} ${ms(duration)}`).join(', ')} (on this computer, unthrottled)`,
    `blocking: ${(report.audits['long-tasks']?.details?.items ?? []).map(({ url, duration }) => `${ms(Math.max(0, duration - 50))} by ${url.split('/').pop() || 'index.html'}`).join(', ')}`,
    `main thread: ${groups.map(({ groupLabel, duration }) => `${groupLabel} ${ms(duration)}`).join(', ')}`,
    `longest tasks: ${tasks.map(({ url, startTime, duration }) => `${ms(duration)} at ${ms(startTime)} (${url.split('/').pop() || 'index.html'})`).join(', ')}`,
  ];
}

const floors = JSON.parse(await readFile(path.join(import.meta.dirname, 'floors.json'), 'utf8'));
const server = await startServer(DIST);
const failures = [];
try {
  for (const [device, config] of Object.entries(CONFIGS)) {
    const reports = [];
    for (let run = 0; run < RUNS; run += 1) reports.push(await audit(server.url, config));

    const speed = median(reports.map((report) => report.environment.benchmarkIndex));
    const isFast = speed >= floors.benchmarkIndex;
    console.log(`\n${device}, medians of ${RUNS}; this machine: ${Math.round(speed)}, the one of the floors: ${floors.benchmarkIndex}`);
    for (const [category, floor] of Object.entries(floors[device])) {
      const scores = reports.map((report) => points(report.categories[category]));
      const score = median(scores);
      console.log(`  ${category.padEnd(26)} ${String(score).padStart(5)}   floor ${floor}   each ${scores.join(' ')}`);
      if (score >= floor) continue;
      if (isFast || category !== SPEED) failures.push(`${device}: ${category} is ${score}, below ${floor}.`);
      else console.log(`  ${category} is below its floor, which is not judged: this machine is slower than the one it was made for.`);
    }
    for (const time of TIMES) {
      const values = reports.map((report) => report.audits[time].numericValue);
      console.log(`  ${time.padEnd(26)} ${String(Math.round(median(values))).padStart(5)} ms`);
    }
    const typical = reports.toSorted((a, b) => a.categories.performance.score - b.categories.performance.score)[Math.floor(RUNS / 2)];
    const lines = Object.keys(floors[device]).flatMap((category) => causes(typical, category));
    for (const line of [...lines, ...work(typical)]) console.log(`  - ${line}`);
  }
} finally {
  server.close();
}
if (failures.length > 0) {
  console.error(`\n${failures.join('\n')}`);
  process.exitCode = 1;
}
