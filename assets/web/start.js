// Fetches and starts the program, shows how far it is, and says in words why it does not run.
// The program hides #loading when it has drawn its first frame (src/platform/web).

const element = (id) => document.getElementById(id);
const CURRENT_BROWSER = 'Use a current version of Firefox, Chrome, Edge or Safari.';

/** Why the program cannot run: what happened, what to do, and details for a bug report. */
class Failure extends Error {
  constructor(what, todo, detail = '') {
    super(what);
    this.todo = todo;
    this.detail = detail;
  }
}

/** Shows a failure in place of everything else. The first one is the cause; later ones are its consequences. */
function show(failure) {
  if (!element('fatal').hidden) return;
  element('fatal-what').textContent = failure.message;
  element('fatal-todo').textContent = failure.todo;
  element('fatal-detail').textContent = failure.detail;
  element('fatal-more').hidden = !failure.detail;
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
    new Failure('The program could not be downloaded.', 'Check the connection and reload the page.', `${url}: ${reason}`);
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
  // Trunk writes both names, with their hashes, into the page.
  const script = document.querySelector('link[rel="modulepreload"]');
  const program = document.querySelector('link[rel="preload"][type="application/wasm"]');
  const arriving = Promise.all([
    download(program.href, Number(program.dataset.bytes)),
    import(script.href).catch((error) => {
      throw new Failure('The program could not be downloaded.', 'Check the connection and reload the page.', String(error));
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
    throw new Failure('The program arrived, but this browser could not start it.', CURRENT_BROWSER, String(error));
  }
}

/** Traps that no panic announces: memory or stack exhausted. A panic has already been shown by the program. */
function onUncaught(error) {
  if (typeof WebAssembly === 'object' && (error instanceof WebAssembly.RuntimeError || error instanceof RangeError)) {
    show(new Failure('The program has stopped because of an error in it.', 'Reload the page to go on.', `${error}\n${error.stack}`));
  }
}

/** Puts aside what the program has stored, which may be why it does not run. */
function startAfresh() {
  const { key } = element('afresh').dataset;
  const stored = localStorage.getItem(key);
  if (stored !== null) localStorage.setItem(`${key}/set aside`, stored);
  localStorage.removeItem(key);
  location.reload();
}

/** Makes room for the keyboard of a phone, where the browser only lays it over the page. */
function followKeyboard() {
  const { height, scale } = visualViewport;
  // Whoever has enlarged the page sees a part of it, as wanted.
  const covered = scale < 1.01 && height < innerHeight - 1;
  element('app').style.height = covered ? `${height}px` : '';
}

addEventListener('error', (event) => onUncaught(event.error));
addEventListener('unhandledrejection', (event) => onUncaught(event.reason));
element('reload').addEventListener('click', () => location.reload());
element('afresh').addEventListener('click', startAfresh);
globalThis.visualViewport?.addEventListener('resize', followKeyboard);
element('app').addEventListener('webglcontextlost', () => {
  show(
    new Failure(
      'The browser took the graphics away from this page, as some do when memory is short or a device sleeps.',
      'Reload the page to go on.',
    ),
  );
});

start().catch((error) => {
  show(error instanceof Failure ? error : new Failure('The program could not be started.', CURRENT_BROWSER, String(error)));
});
