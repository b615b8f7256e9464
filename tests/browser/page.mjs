// The page as a person meets it: what it shows, its fields and buttons, the keyboard, the clipboard.

import { setTimeout as sleep } from 'node:timers/promises';
import { PNG } from 'pngjs';
import { Key } from 'selenium-webdriver';
import { startEngine } from './engines/index.mjs';
import { EMPTY, startServer } from './server.mjs';

export const STORAGE_KEY = 'depth-calculator/v1';
/** Where a tab remembers that the page has started the program again (assets/web/start.js). */
const RESTARTED = 'depth-calculator/restarted';
const MIRROR = '#accessible-mirror';
const SELECTORS = {
  button: 'button, [role=button]',
  choice: '[role=menuitemcheckbox], [role=option]',
  field: 'input, textarea, [role=textbox], [role=spinbutton]',
  image: 'img, [role=img]',
  link: 'a, [role=link]',
  radio: 'input[type=radio], [role=radio]',
  tab: '[role=tab]',
};
const CANDIDATES = `
  const [css, name] = arguments;
  const labels = (one) => (one.getAttribute('aria-labelledby') ?? '').split(' ').map((id) => document.getElementById(id)?.textContent);
  return [...document.querySelectorAll(css)].filter((one) =>
    [one.getAttribute('aria-label'), labels(one).join(' '), one.textContent].some((words) => words?.trim() === name));`;
/** Only a program that hangs takes so long, however much else the machine does. */
const PATIENCE_MS = 120_000;
/** How a page can be without what its engine cannot switch off. */
const WITHOUT = {
  webgl: 'HTMLCanvasElement.prototype.getContext = () => null',
  webassembly: 'delete globalThis.WebAssembly',
  letters: 'CanvasRenderingContext2D.prototype.measureText = () => { throw new Error("no letters") }',
};

const PHONE = { width: 390, height: 844, scale: 3 };

/** The page that was opened last. */
export const current = { page: undefined };

/** A server and a browser for one file of tests. */
export async function startBench() {
  const server = await startServer();
  const session = await startEngine();
  return {
    server,
    /** A page in a browser that knows nothing of earlier ones; nothing is loaded yet. */
    async page(test, options = {}) {
      await server.renew();
      const driver = await session.open(options);
      const page = new Page(session.engine, server, driver, test);
      current.page = page;
      await page.setScreen({ width: 1280, height: 900 });
      const { without } = options;
      if (without && !session.engine.switchesOff.includes(without)) await page.runBefore(WITHOUT[without]);
      return page;
    },
    async close() {
      await session.close();
      server.close();
    },
  };
}

/** Calls `look` until it answers with something true, and returns that. */
export async function until(what, look) {
  const end = Date.now() + PATIENCE_MS;
  for (;;) {
    const seen = await look();
    if (seen) return seen;
    if (Date.now() > end) throw new Error(`Waited ${PATIENCE_MS / 1000} s in vain: ${what}`);
    await sleep(50);
  }
}

/** The most frequent color of a picture (0xrrggbb), the part of the picture that has it, and its lightness, 0 to 255. */
export function background(png) {
  const { data } = PNG.sync.read(png);
  const counts = new Map();
  for (let at = 0; at < data.length; at += 4) {
    const color = data.readUIntBE(at, 3);
    counts.set(color, (counts.get(color) ?? 0) + 1);
  }
  const [color, count] = [...counts].reduce((most, next) => (next[1] > most[1] ? next : most));
  return { color, share: count / (data.length / 4), lightness: (((color >> 16) & 255) + ((color >> 8) & 255) + (color & 255)) / 3 };
}

export class Page {
  constructor(engine, server, driver, test) {
    Object.assign(this, { engine, server, driver, test });
  }

  setScreen(screen) {
    return this.engine.setScreen(this.driver, screen);
  }

  run(script, ...values) {
    return this.driver.executeScript(script, ...values);
  }

  /** A phone, whose browser draws with `scale` device pixels in a CSS pixel, or says so. */
  imitatePhone(screen = PHONE) {
    return this.engine.imitatePhone(this.driver, screen);
  }

  /** Has a script run at the start of the page, before its own. */
  async runBefore(script) {
    this.server.state.added.set('before.js', script);
    await this.server.changePage((html) => html.replace('<head>', '<head><script src="before.js"></script>'));
  }

  /** Loads the page and waits until the program has drawn its first frame. */
  async start() {
    await this.driver.get(this.server.url);
    await this.started();
  }

  async reload() {
    await this.driver.navigate().refresh();
    await this.started();
  }

  async started() {
    await until('the first frame', async () => {
      const failure = await this.failure();
      if (failure) throw new Error(`The page shows: ${failure}`);
      return (await this.firstFrameMs()) !== null;
    });
  }

  /** Runs a script that ends in a new document, and waits until the program has drawn its first frame there. */
  async renew(script, ...values) {
    await this.run(`document.documentElement.dataset.is = 'old'; ${script}`, ...values);
    await this.renewed();
  }

  /** Waits for the document that follows one which was marked as old, and for the program there. */
  async renewed() {
    // While one document goes and the other comes, a browser answers with an error, or with nothing at all.
    const which = () => this.run("return document.documentElement?.dataset.is ?? 'new'").catch(() => 'none');
    await until('the next document', async () => (await which()) === 'new');
    await this.started();
  }

  /** Why the page has started the program again, which stopped soon after its start (assets/web/start.js); null if it has not. */
  whyStartedAgain() {
    return this.run('return sessionStorage.getItem(arguments[0])', RESTARTED).catch(() => null);
  }

  /** From now on the page says why the program stops, as if it had started it again before. */
  async startsNoMore() {
    this.mayStartAgain = true;
    await this.run("sessionStorage.setItem(arguments[0], '')", RESTARTED);
  }

  /** Milliseconds from the navigation to the first frame, `null` before it. */
  firstFrameMs() {
    return this.run("return performance.getEntriesByName('first-frame')[0]?.startTime ?? null");
  }

  /** What the page says when the program cannot run; empty while it can. */
  failure() {
    // The details are closed until somebody opens them, and say nothing until then.
    return this.run(
      "const [alert] = [...document.querySelectorAll('body > [role=alert]')].filter((one) => !one.hidden);" +
        "return alert ? `${alert.innerText}\\n${alert.querySelector('details').textContent}`.trim() : ''",
    );
  }

  /** Clicks a button of the page around the program: in an alert, or in a region beside it. */
  async click(name) {
    const found = await until(`the button "${name}"`, async () => {
      const shown = await this.driver.findElements({ css: ':is([role=alert], [role=region]) > button, [role=alert] button' });
      for (const button of shown) {
        if ((await button.isDisplayed()) && (await button.getAccessibleName()) === name) return button;
      }
      return undefined;
    });
    await found.click();
  }

  /** Clicks one of the buttons of the page that says why the program cannot run, and waits for the program. */
  async startAgain(button) {
    await this.run("document.documentElement.dataset.is = 'old'");
    await this.click(button);
    // What the page says of the new program is its own.
    this.mayStartAgain = false;
    await this.renewed();
  }

  /** Loads the page and waits for it to say why the program cannot run. */
  async startFailing() {
    await this.driver.get(this.server.url);
    return until('a message', () => this.failure());
  }

  /** What the page or its worker has asked of other computers, as the proxy heard it. */
  elsewhere() {
    return this.driver.elsewhere;
  }

  /** The origins that the page says it has asked since it was loaded. */
  async askedOrigins() {
    const urls = await this.run("return performance.getEntriesByType('resource').map((entry) => entry.name)");
    return [...new Set(urls.filter((url) => !/^(data|blob):/.test(url)).map((url) => new URL(url).origin))];
  }

  consoleProblems() {
    const reason = this.engine.cannot['read the console'];
    if (reason) this.test.diagnostic(`The console is not looked at: ${reason}.`);
    return this.engine.consoleProblems(this.driver);
  }

  /** The text that any tab has stored last, with which a new one starts, `null` if there is none. */
  stored() {
    return this.run('return localStorage.getItem(arguments[0])', STORAGE_KEY);
  }

  /** The text that this tab has stored for its next start; empty if it starts with nothing. */
  own() {
    return this.run('return sessionStorage.getItem(arguments[0])', STORAGE_KEY);
  }

  /** Replaces what the page keeps, before its next start. */
  async store(text) {
    await this.driver.get(`${this.server.origin}${EMPTY}`);
    await this.run('sessionStorage.clear(); localStorage.setItem(arguments[0], arguments[1])', STORAGE_KEY, text);
  }

  /** What is shown of the page around the mirror with this role, of HTML or ARIA, and a name like this; undefined if nothing is. */
  async around(css, name) {
    for (const one of await this.driver.findElements({ css })) {
      if ((await one.isDisplayed()) && name.test(await one.getAccessibleName())) return one;
    }
    return undefined;
  }

  /** What the program is painted on. */
  canvas() {
    return until('the canvas', () => this.around('[role=group]', /^Depth Calculator$/));
  }

  /** The bar that shows how much of the program has arrived, while there is one. */
  bar() {
    return this.around('progress', /^(Loading|Starting)/);
  }

  /** The browser takes the graphics away, as some do when memory is short. */
  async loseGraphics() {
    await this.run("arguments[0].getContext('webgl2').getExtension('WEBGL_lose_context').loseContext()", await this.canvas());
  }

  /** The element with one of these roles and this name. The canvas has none: they are those of its accessible mirror. */
  async element(name, ...roles) {
    const css = `${MIRROR} :is(${roles.map((role) => SELECTORS[role]).join()})`;
    return until(`"${name}" (${roles.join(' or ')})`, async () => {
      // A script is quick to say which may have the name; what assistive technology is told is asked of those alone.
      for (const candidate of await this.run(CANDIDATES, css, name)) {
        if ((await candidate.getAccessibleName()) === name) return candidate;
      }
      return undefined;
    });
  }

  /** The field with this name. */
  field(name) {
    return this.element(name, 'field');
  }

  /** What stands in the field with this name. */
  async value(name) {
    return (await this.field(name)).getProperty('value');
  }

  /** Replaces what stands in a field, as somebody who came to it with the keyboard. */
  async fill(name, text) {
    const field = await this.field(name);
    await this.run('arguments[0].focus(); arguments[0].select()', field);
    await this.type(text);
    await until(`"${text}" in "${name}"`, async () => (await this.value(name)) === text);
  }

  /** Presses the button, link, tab or choice with this name, as assistive technology does. */
  async press(name) {
    await this.run('arguments[0].click()', await this.element(name, 'button', 'link', 'tab', 'choice', 'radio'));
  }

  /** Shows a screen: by its tab, or on a phone by the menu that all are in. */
  async show(screen) {
    const named = (pattern) =>
      this.run(
        "return [...document.querySelectorAll(arguments[0] + ' :is([role=tab], [role^=menuitem], [role=button], button)')].find((one) => new RegExp(arguments[1]).test((one.getAttribute('aria-label') ?? one.textContent).trim())) ?? null",
        MIRROR,
        pattern,
      );
    const click = (element) => this.run('arguments[0].click()', element);
    await click(await until('tabs or a menu of the screens', () => named(`^(Screens: .*|${screen})$`)));
    await this.frames();
    const entry = await named(`^${screen}$`);
    if (entry) await click(entry);
  }

  /** The middle of an element, in whole pixels of the window. */
  middle(element) {
    return this.within(element, 0.5);
  }

  /** Near the right end of an element, in whole pixels of the window. */
  rightEnd(element) {
    return this.within(element, 0.95);
  }

  /** Half-way down an element, at this part of its width. */
  within(element, part) {
    return this.run(
      'const { x, y, width, height } = arguments[0].getBoundingClientRect(); return { x: Math.round(x + width * arguments[1]), y: Math.round(y + height / 2) }',
      element,
      part,
    );
  }

  /** Moves the mouse to where the program has painted an element of the mirror, once it lies still. */
  async moveTo(element) {
    let place = await this.middle(element);
    for (let before; String([before?.x, before?.y]) !== String([place.x, place.y]); place = await this.middle(element)) {
      before = place;
      await this.frames();
    }
    await this.driver.actions().move(place).perform();
  }

  /** Clicks with the mouse where the program has painted what has this name. */
  async point(name) {
    await this.moveTo(await this.element(name, 'button', 'link', 'tab', 'choice'));
    await this.driver.actions().press().release().perform();
  }

  /** Presses Tab until the element with this name has the keyboard. */
  async tabTo(name) {
    for (let tabs = 0; tabs < 60; tabs += 1) {
      const active = await this.driver.switchTo().activeElement();
      if ((await active.getAccessibleName()) === name) return;
      await this.type(Key.TAB);
    }
    throw new Error(`Tab does not lead to "${name}".`);
  }

  /** Everything that the program says, as a screen reader would read it. */
  text() {
    return this.run('return document.querySelector(arguments[0])?.innerText ?? ""', MIRROR);
  }

  /** Waits until the program says something. */
  says(pattern) {
    return until(`${pattern}`, async () => pattern.test(await this.text()));
  }

  /** Types into whatever has the keyboard. */
  async type(...keys) {
    await this.driver.actions().sendKeys(...keys).perform();
    await this.frames();
  }

  /** Waits until the program has seen the last key and moved its focus: nobody types faster than that. */
  frames() {
    // Those of a page that rests go on when it is told to.
    return this.driver.executeAsyncScript(
      'const done = arguments[0]; const next = (left) => { globalThis.restFor?.(0); requestAnimationFrame(() => (left > 0 ? next(left - 1) : done())); }; next(2)',
    );
  }

  /** Allows the page to be asked for the clipboard, and empties it. */
  async prepareClipboard() {
    await this.engine.allowClipboard(this.driver, this.server.origin);
    await this.run("return navigator.clipboard.writeText('')");
  }

  /** What is on the clipboard. Firefox refuses to read one that is just being handed from one owner to the next: then nothing is there yet. */
  clipboard() {
    return this.run(`return navigator.clipboard.readText().catch((refusal) => {
      if (refusal.name !== 'NotAllowedError') throw refusal;
      return '';
    })`);
  }

  /** A PNG of what the window shows. */
  async screenshot() {
    return Buffer.from(await this.driver.takeScreenshot(), 'base64');
  }
}

export { Key };
