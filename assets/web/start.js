// Fetches and starts the program, shows how far it is, and says in words why it does not run.
// The program hides #loading when it has drawn its first frame (src/platform/web).

const element = (id) => document.getElementById(id);
const CURRENT_BROWSER = 'Use a current version of Firefox, Chrome, Edge or Safari.';

/** Why the program cannot run: what happened, what to do, and details for a bug report. */
class Failure extends Error {
  constructor(what, todo, detail = '', isOfProgram = false) {
    super(what);
    Object.assign(this, { todo, detail, isOfProgram });
  }
}

const LONG_MS = 10_000;

/** Whether the program has been in use for a while. */
function ranLong() {
  const [first] = globalThis.performance?.getEntriesByName('first-frame') ?? [];
  return first !== undefined && performance.now() - first.startTime > LONG_MS;
}

/** Shows a failure in place of everything else. */
function show(failure) {
  element('fatal-what').textContent = failure.message;
  element('fatal-todo').textContent = failure.todo;
  element('fatal-detail').textContent = failure.detail;
  element('fatal-more').hidden = !failure.detail;
  // Where the program has not run long, what it read at the start may be why it failed, and would be again.
  element('afresh').hidden = !failure.isOfProgram || ranLong();
  element('fatal-kept').hidden = element('fatal').dataset.kept === 'no';
  // What the program said last is no longer true, and its fields no longer take anything.
  document.querySelector('main').inert = true;
  element('loading').hidden = true;
  element('fatal').hidden = false;
}

function checkWebAssembly() {
  if (typeof WebAssembly !== 'object') {
    throw new Failure(
      'This browser does not run WebAssembly, which the program is made of.',
      `Some browsers switch it off in a strict security mode: allow it for this page. Otherwise: ${CURRENT_BROWSER}`,
    );
  }
}

/** On the canvas that the program will draw on: a context of its own only for this check would cost a tenth of a second. */
function checkGraphics() {
  if (element('app').getContext('webgl2')) return;
  throw new Failure(
    'This browser does not offer WebGL 2, with which the program draws.',
    `Switch on hardware acceleration in the browser's settings. Otherwise: ${CURRENT_BROWSER}`,
  );
}

/**
 * Has eframe compute the size of the canvas itself where the browser gives it in the wrong pixels: an emulated phone (Chrome's device
 * toolbar, Playwright) reports 3 device pixels in a CSS pixel and draws 1, and the page would be shown three times too large. Each
 * observer hears of a change in the order in which they were made, so eframe's, made later, finds what this leaves.
 */
function checkDevicePixels() {
  const name = 'devicePixelContentBoxSize';
  const { prototype } = globalThis.ResizeObserverEntry ?? {};
  if (!prototype || !(name in prototype)) return;
  new ResizeObserver(([entry], observer) => {
    const [drawn] = entry[name];
    const [styled] = entry.contentBoxSize;
    const isWrong = (side) => Math.abs(drawn[side] - styled[side] * devicePixelRatio) > 1;
    if (!isWrong('inlineSize') && !isWrong('blockSize')) return;
    delete prototype[name];
    observer.disconnect();
  }).observe(element('app'));
}

/** Settles when the page is on the screen, or soon if nobody is looking: a page in the background is not painted. */
function painted() {
  const seen = new Promise((resolve) => new PerformanceObserver(resolve).observe({ type: 'paint', buffered: true }));
  return Promise.race([seen, new Promise((resolve) => setTimeout(resolve, 1000))]);
}

const megabytes = (bytes) => (bytes / 1e6).toFixed(1);

/**
 * Fetches `url` and reports its progress on the page. `size` is the number of bytes after
 * decompression, 0 where it is not known. `arrived` in the answer becomes true with the last byte.
 */
async function download(url, size) {
  const failed = (reason) =>
    new Failure('The program could not be downloaded.', 'Check the connection and reload the page; if a new version has just been published, that finds it.', `${url}: ${reason}`);
  const answer = await fetch(url, { credentials: 'same-origin' }).catch((error) => {
    throw failed(error);
  });
  if (!answer.ok || !answer.body) throw failed(`HTTP status ${answer.status}`);

  // Content-Length counts compressed bytes, the stream does not.
  const total = size || (answer.headers.has('content-encoding') ? 0 : Number(answer.headers.get('content-length')));
  const progress = { arrived: false, failed };
  let bytes = 0;
  const counter = new TransformStream({
    transform(chunk, controller) {
      bytes += chunk.byteLength;
      if (total) element('bar').value = Math.min(bytes / total, 1);
      element('progress').textContent = total
        ? `Loading: ${megabytes(bytes)} of ${megabytes(total)} MB`
        : `Loading: ${megabytes(bytes)} MB`;
      controller.enqueue(chunk);
    },
    flush() {
      // WebKit ends a stream like this also where the connection has ended before the file.
      progress.arrived = bytes >= total;
      element('progress').textContent = 'Starting…';
    },
  });
  // Compiling while downloading needs this type, whatever the host says.
  const response = new Response(answer.body.pipeThrough(counter), { headers: { 'content-type': 'application/wasm' } });
  return { response, progress };
}

async function start() {
  checkWebAssembly();
  checkDevicePixels();
  // Trunk writes both names, with their hashes, into the page.
  const script = document.querySelector('link[rel="modulepreload"]');
  const program = document.querySelector('link[rel="preload"][type="application/wasm"]');
  const arriving = Promise.all([
    download(program.href, Number(program.dataset.bytes)),
    import(script.href).catch((error) => {
      throw new Failure('The program could not be downloaded.', 'Check the connection and reload the page; if a new version has just been published, that finds it.', String(error));
    }),
  ]);
  // What it fails with is said below; without this it would also count as unheard while the graphics are checked.
  arriving.catch(() => {});
  await painted();
  checkGraphics();
  const [{ response, progress }, { default: run }] = await arriving;
  try {
    await run({ module_or_path: response });
  } catch (error) {
    if (!progress.arrived) throw progress.failed(error);
    throw new Failure('The program arrived, but this browser could not start it.', CURRENT_BROWSER, String(error), isTrap(error));
  }
}

/** In it the tab remembers that it was started again, and why. */
const RESTARTED = 'depth-calculator/restarted';

/**
 * Starts again, once in a tab, a program that has hardly begun: a compiler of WebKitGTK 2.50 makes one start in 200 of it read beside
 * its memory, which ends in a trap or, where it reads a length there, in a panic. Nobody has entered anything yet that is not stored.
 * Returns whether it does.
 */
function startsAgain(failure) {
  if (ranLong() || ifAllowed(() => sessionStorage.getItem(RESTARTED) !== null) !== false) return false;
  return ifAllowed(() => {
    sessionStorage.setItem(RESTARTED, `${failure.message} ${failure.detail}`);
    location.reload();
    return true;
  });
}

/**
 * A screen reader begins to read a page when it has arrived, and the program may be there a moment later: until it is late, what stands
 * here meanwhile is for the eyes.
 */
const LATE_MS = 3000;
element('loading').inert = true;
setTimeout(() => (element('loading').inert = false), LATE_MS);

let isOver = false;
/** Whether the browser goes to another page: Firefox then ends scripts in the middle, and what the program does next fails. */
let isLeaving = false;

/** The program has stopped: the page starts it again, or shows why. The first failure is the cause; later ones are its consequences. */
function stop(failure) {
  if (isOver) return;
  isOver = true;
  if (isLeaving) return;
  if (!failure.isOfProgram || !startsAgain(failure)) show(failure);
}

/** What ends a program without a panic: memory or stack exhausted, or memory that is not there. */
const isTrap = (error) => typeof WebAssembly === 'object' && (error instanceof WebAssembly.RuntimeError || error instanceof RangeError);

/** A panic ends in a trap too, but has already been told by the program. */
function onUncaught(error) {
  if (!isTrap(error)) return;
  stop(new Failure('The program has stopped because of an error in it.', 'Reload the page to go on.', `${error}\n${error.stack}`, true));
}

/** Takes the text that a storage has under this key. */
function take(storage, key) {
  const text = storage.getItem(key);
  storage.removeItem(key);
  return text;
}

/** Calls `use`, unless the browser refuses: what cannot be read is not read by the program either. */
function ifAllowed(use) {
  try {
    return use();
  } catch {
    return null;
  }
}

/** Puts aside what this tab and the last have stored, which may be why the program does not run (src/platform/web/browser.rs). */
function startAfresh() {
  const { key } = element('afresh').dataset;
  const texts = new Set([ifAllowed(() => take(sessionStorage, key)), ifAllowed(() => take(localStorage, key))]);
  // Empty: the tab starts with nothing, whatever another has stored by then.
  ifAllowed(() => sessionStorage.setItem(key, ''));
  ifAllowed(() => sessionStorage.removeItem(RESTARTED));
  ifAllowed(() => {
    // Nothing that was set aside before is overwritten. Now that the texts are taken there is room for them.
    for (const text of texts) {
      let aside = `${key}/set aside`;
      for (let number = 2; localStorage.getItem(aside) !== null; number += 1) aside = `${key}/set aside ${number}`;
      if (text) localStorage.setItem(aside, text);
    }
  });
  location.reload();
}

/** Makes room for the keyboard of a phone, where the browser only lays it over the page. */
function followKeyboard() {
  const { height, scale, offsetTop } = visualViewport;
  // Whoever has enlarged the page sees a part of it, as wanted.
  const covered = scale < 1.01 && height < innerHeight - 1;
  element('app').style.height = covered ? `${height}px` : '';
  // Some browsers move what can be seen down the page instead.
  element('app').style.top = covered && offsetTop > 0 ? `${offsetTop}px` : '';
}

// The program itself says why it has stopped (src/platform/web/page.rs).
addEventListener('program-failed', ({ detail: [what, todo, detail] }) => stop(new Failure(what, todo, detail, true)));
addEventListener('error', (event) => onUncaught(event.error));
addEventListener('unhandledrejection', (event) => onUncaught(event.reason));
addEventListener('pagehide', () => (isLeaving = true));
addEventListener('pageshow', () => {
  // Somebody comes back to a page that was kept, and whose program was ended.
  if (isLeaving && isOver) location.reload();
  isLeaving = false;
});
element('reload').addEventListener('click', () => {
  // Whoever asks for it begins anew, and so does what the tab may do by itself.
  ifAllowed(() => sessionStorage.removeItem(RESTARTED));
  location.reload();
});
element('afresh').addEventListener('click', startAfresh);
globalThis.visualViewport?.addEventListener('resize', followKeyboard);
globalThis.visualViewport?.addEventListener('scroll', followKeyboard);
element('app').addEventListener('webglcontextlost', () => {
  stop(
    new Failure(
      'The browser took the graphics away from this page, as some do when memory is short or a device sleeps.',
      'Reload the page to go on.',
    ),
  );
});

start().catch((error) => {
  stop(error instanceof Failure ? error : new Failure('The program could not be started.', CURRENT_BROWSER, String(error)));
});
