// Whoever does not see the canvas, or uses no mouse: axe-core and IBM Equal Access on every screen, and the way of the keyboard.

import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { after, before, it, ONE_ENGINE, unless } from './harness.mjs';
import { background, Key, startBench, until } from './page.mjs';
import { FIELDS, SCREENS } from './states.mjs';

const script = (name) => readFile(createRequire(import.meta.url).resolve(name), 'utf8');
const AXE = await script('axe-core/axe.min.js');
const EQUAL_ACCESS = await script('accessibility-checker-engine/ace.js');
const MIRROR = '#accessible-mirror';
const WIDTHS = [390, 1280];
const FX = 'Focal length (fx)';

let bench;
before(async () => {
  bench = await startBench();
});
after(() => bench.close());

/** What the checkers find wrong, one line per element. */
async function violations(page) {
  return [...(await foundByAxe(page)), ...(await foundByEqualAccess(page))];
}

async function foundByEqualAccess(page) {
  await page.run(`if (!globalThis.ace) { ${EQUAL_ACCESS}\n globalThis.ace = ace; }`);
  const [results, failure] = await page.driver.executeAsyncScript(
    `const [mirror, done] = arguments;
    // Contrast as above. What is inert does not exist for anybody, which this checker does not know.
    const counts = ({ ruleId, node }) => {
      const element = node.nodeType === Node.ELEMENT_NODE ? node : node.parentElement;
      return !element?.closest('[inert]') && !(ruleId === 'text_contrast_sufficient' && element?.closest(mirror));
    };
    new ace.Checker().check(document, ['WCAG_2_2']).then(
      ({ results }) => done([results.filter(counts).map(({ ruleId, value, message, snippet }) => ({ ruleId, value, message, snippet })), null]),
      (error) => done([null, String(error)]),
    )`,
    MIRROR,
  );
  assert.equal(failure, null);
  assert.ok(results.length > 10, `IBM Equal Access had next to nothing to look at: ${results.length} results`);
  return results
    .filter(({ value }) => value.join() === 'VIOLATION,FAIL')
    .map(({ ruleId, message, snippet }) => `${ruleId} (${message}): ${snippet.replace(/ style="[^"]*"/, '')}`);
}

async function foundByAxe(page) {
  await page.run(`if (!globalThis.axe) { ${AXE} }`);
  const [outcome, failure] = await page.driver.executeAsyncScript(
    `const [mirror, done] = arguments;
    // What the mirror says is painted on the canvas, and the contrast of that is tested where the colors are chosen;
    // the mirror itself is a thousandth opaque.
    (async () => {
      const all = await axe.run(document, { resultTypes: ['violations'], rules: { 'color-contrast': { enabled: false } } });
      const contrast = await axe.run({ exclude: [mirror] }, { resultTypes: ['violations'], runOnly: { type: 'rule', values: ['color-contrast'] } });
      return { violations: [...all.violations, ...contrast.violations], passed: all.passes.length };
    })().then(
      (outcome) => done([outcome, null]),
      (error) => done([null, String(error)]),
    )`,
    MIRROR,
  );
  assert.equal(failure, null);
  assert.ok(outcome.passed > 10, `axe-core had next to nothing to look at: ${outcome.passed} rules passed`);
  return outcome.violations.flatMap(({ id, help, nodes }) =>
    nodes.map(({ html, failureSummary }) => `${id} (${help}): ${html.replace(/ style="[^"]*"/, '')}: ${failureSummary.replace(/\s+/g, ' ')}`),
  );
}

/** Chooses light or dark in the program, which every engine can do. */
async function choose(page, theme) {
  await page.press('Light or dark');
  await page.press(theme);
  await until(`${theme} in the storage`, async () => JSON.parse((await page.stored()) ?? '{}').theme === theme.toLowerCase());
}

for (const [name, reach] of Object.entries(SCREENS)) {
  it(`the checkers find nothing wrong with ${name}, narrow and dark, wide and light`, { engines: ONE_ENGINE }, async (test) => {
    const page = await bench.page(test);
    const found = [];
    for (const [width, theme] of [[390, 'Dark'], [1280, 'Light']]) {
      await page.setScreen({ width, height: 900 });
      await page.start();
      await choose(page, theme);
      await reach(page);
      found.push(...(await violations(page)).map((violation) => `${width} pixels wide, ${theme}: ${violation}`));
      await page.run('localStorage.clear(); sessionStorage.clear()');
    }
    assert.deepEqual(found, []);
  });
}

/** The pages that are not drawn by the program: their colors follow the system. */
const PAGES = {
  'the page that says why the program cannot run': async (page) => {
    bench.server.state.programs = 'missing';
    await page.startFailing();
  },
  'the page while the program loads': async (page) => {
    Object.assign(bench.server.state, { programs: 'held', pieces: 0 });
    // Else the next visit would have it from this computer, at once.
    bench.server.state.changed.set('sw.js', () => 'this is no script');
    await page.driver.get('about:blank');
    await page.run('location.href = arguments[0]', bench.server.url);
    await until('the page', () => page.bar());
  },
  'the Learn page': (page) => page.driver.get(`${bench.server.url}learn.html`),
};

for (const [name, reach] of Object.entries(PAGES)) {
  it(`the checkers find nothing wrong with ${name}`, { engines: ONE_ENGINE }, async (test) => {
    const page = await bench.page(test);
    for (const width of WIDTHS) {
      for (const dark of [false, true]) {
        await page.setScreen({ width, height: 900, dark });
        await reach(page);
        assert.deepEqual(await violations(page), [], `${width} pixels wide, ${dark ? 'dark' : 'light'}`);
        bench.server.state.pieces = 20;
      }
    }
  });
}

it('the checkers find nothing wrong with the offer of a new version', { engines: ONE_ENGINE }, async (test) => {
  const page = await bench.page(test);
  await page.start();
  // As assets/web/register.js shows it.
  await page.run("const bar = document.querySelector('[role=region][aria-label=\"New version\"]'); bar.hidden = false; bar.querySelector('p').textContent = 'A new version is ready.'");
  assert.deepEqual(await violations(page), []);
});

for (const [width, height] of [
  [320, 200],
  [320, 256],
  [640, 400],
]) {
  it(`whatever has the keyboard is whole in a window of ${width} × ${height}, in the dialogs too`, { needs: ['leave a page with Tab', 'show a page as narrow as a phone'] }, async (test) => {
    const page = await bench.page(test);
    await page.setScreen({ width, height });
    await page.start();
    const stops = await wholeStops(page);
    assert.ok(stops.length > 25, stops.join());
    for (const [opens, least] of Object.entries({ 'From lens, FOV or Q…': 5, 'OpenCV × 16, doffs…': 5, Keys: 2 })) {
      // The keyboard has left the page before, as it does after the last stop.
      await page.engine.reset(page.driver);
      await page.run('arguments[0].focus()', await page.element(opens, 'button'));
      await page.type(Key.ENTER);
      await until('the dialog', () => page.run(`return document.querySelector('${MIRROR} [role=dialog]')?.contains(document.activeElement)`));
      const inside = await wholeStops(page);
      assert.ok(inside.length >= least, `${opens}: ${inside}`);
      await page.press(opens === 'Keys' ? 'Close' : 'Cancel');
      await until('the dialog closed', () => page.run(`return document.querySelector('${MIRROR} [role=dialog]') === null`));
    }
  });
}

/** The names of what Tab visits from where the keyboard is, each once it is wholly in sight, until it leaves the document or begins again. */
async function wholeStops(page) {
  const names = [];
  const seen = new Set();
  for (let steps = 0; steps < 60; steps += 1) {
    const [id, name] = await until(`what has the keyboard after ${names.at(-1)} in sight`, () =>
      page.run(`
        const active = document.activeElement;
        if (active === document.body || !document.hasFocus()) return ['outside', ''];
        const { top, bottom, left, right } = active.getBoundingClientRect();
        const isWhole = top >= 0 && left >= 0 && bottom <= innerHeight && right <= innerWidth;
        return isWhole && [active.id, active.getAttribute('aria-label') || active.textContent];`),
    );
    if (id === 'outside' || seen.has(id)) break;
    seen.add(id);
    names.push(name);
    await page.type(Key.TAB);
  }
  return names;
}

/** The names of what Tab visits from where the page starts until it leaves the document, in order. */
async function journey(page) {
  const visited = [];
  for (let steps = 0; steps < 80; steps += 1) {
    await page.type(Key.TAB);
    const outside = await page.run('return document.activeElement === document.body || !document.hasFocus()');
    if (outside) return visited;
    const active = await page.driver.switchTo().activeElement();
    visited.push(await active.getAccessibleName());
  }
  assert.fail(`Tab does not leave the document: ${visited.join(', ')}`);
  return [];
}

it('Tab leads through everything in the order in which it is read, and out again', { needs: ['leave a page with Tab'] }, async (test) => {
  const page = await bench.page(test);
  await page.start();
  const stops = await page.run(`return [...document.querySelectorAll('${MIRROR} [tabindex="0"]')].map((stop) => stop.id)`);
  assert.ok(stops.length > 15, `${stops.length} stops`);
  // The program starts in its first field; from there the way leads to the end.
  const start = stops.indexOf(await page.run('return document.activeElement.id'));
  assert.ok(start >= 0, 'the keyboard is on none of them');
  const visited = await journey(page);
  assert.deepEqual(
    visited.filter((name) => FIELDS.includes(name)),
    FIELDS.slice(1),
  );
  assert.ok(visited.length >= stops.length - 1 - start, `of ${stops.length} stops Tab visits ${visited.join(', ')}`);
});

it('Escape does nothing where nothing is open', async (test) => {
  const page = await bench.page(test);
  await page.start();
  const field = await page.field(FX);
  await page.run('arguments[0].focus()', field);
  await page.type('7', Key.ESCAPE, '00');
  await until('all three digits', async () => (await page.value(FX)) === '700');
  assert.ok(await page.run('return document.activeElement === arguments[0]', field), 'the focus is where it was');
});

it('a dialog keeps the keyboard while it is open, and gives it back', async (test) => {
  const page = await bench.page(test);
  await page.start();
  await page.run('arguments[0].focus()', await page.element('From lens, FOV or Q…', 'button'));
  await page.type(Key.ENTER);
  const isOpen = () => page.run(`return document.querySelector('${MIRROR} [role=dialog]') !== null`);
  await until('the dialog', isOpen);
  await page.frames();
  const inside = () => page.run(`return document.querySelector('${MIRROR} [role=dialog]').contains(document.activeElement)`);
  assert.ok(await until('the keyboard in the dialog', inside));
  await page.type(Key.ESCAPE);
  await until('the dialog closed', async () => !(await isOpen()));
  await until('the keyboard where it came from', async () => {
    const active = await page.driver.switchTo().activeElement();
    return (await active.getAccessibleName()) === 'From lens, FOV or Q…';
  });
});

it('what belongs to the browser stays the browser’s', async (test) => {
  const page = await bench.page(test);
  await page.start();
  const field = await page.field(FX);
  await page.run('arguments[0].focus()', field);
  const kept = await page.run(
    `const keys = [
      { key: 'f', ctrlKey: true }, { key: 'l', ctrlKey: true }, { key: 'p', ctrlKey: true }, { key: 'r', ctrlKey: true },
      { key: '+', ctrlKey: true }, { key: '-', ctrlKey: true }, { key: '0', ctrlKey: true }, { key: 'F5' }, { key: 'F6' }, { key: 'F11' },
      { key: 'ArrowLeft', altKey: true },
    ];
    const targets = [arguments[0], document.querySelector('${MIRROR} button'), arguments[1], document.body];
    return targets.flatMap((target) => keys.filter((key) => !target.dispatchEvent(
      new KeyboardEvent('keydown', { ...key, code: key.key.length === 1 && /[a-z]/.test(key.key) ? 'Key' + key.key.toUpperCase() : key.key, bubbles: true, cancelable: true }),
    )).map((key) => target.localName + ': ' + JSON.stringify(key)));`,
    field,
    await page.canvas(),
  );
  assert.deepEqual(kept, []);
});

it('the field that is typed into stays in sight when the keyboard of a phone takes half the page', async (test) => {
  const page = await bench.page(test);
  await page.setScreen({ width: 500, height: 900 });
  await page.start();
  const field = await page.field(FIELDS[4]);
  const canvas = await page.canvas();
  await page.run('arguments[0].focus()', field);
  await page.frames();
  const seen = (height) => page.run(`Object.defineProperty(visualViewport, 'height', { configurable: true, value: ${height} }); visualViewport.dispatchEvent(new Event('resize'))`);
  // Some browsers make the page lower, others only tell how much of it the keyboard leaves.
  const keyboards = {
    ...(!unless('make its window lower') && { 'that makes the page lower': (height) => page.setScreen({ width: 500, height }) }),
    'that lies over the page': seen,
  };
  if (unless('make its window lower')) test.diagnostic(unless('make its window lower'));
  for (const [name, leave] of Object.entries(keyboards)) {
    await leave(420);
    await until(`the field in sight above a keyboard ${name}`, () =>
      page.run("const { top, bottom } = arguments[0].getBoundingClientRect(); return arguments[1].clientHeight <= 420 && top >= 0 && bottom <= 420", field, canvas),
    );
    await leave(900);
    await until('the whole page again', () => page.run('return arguments[0].clientHeight > 420', canvas));
  }
});

it('colors that somebody has chosen for everything are those of the program', { needs: ['choose the colors'] }, async (test) => {
  const page = await bench.page(test);
  await page.start();
  await choose(page, 'Dark');
  await until('the dark program', async () => background(await page.screenshot()).lightness < 128);
  await page.engine.chooseColors(page.driver);
  const canvas = await page.run("document.body.style.cssText = 'forced-color-adjust:none;color:Canvas'; return getComputedStyle(document.body).color");
  const [red, green, blue] = canvas.match(/\d+/g).map(Number);
  await until(`a background of ${canvas}`, async () => background(await page.screenshot()).color === red * 65536 + green * 256 + blue);
});
