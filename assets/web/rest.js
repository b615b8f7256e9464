// Lets the page rest while the program paints nothing: eframe asks for one animation frame after another, for ever, and each costs the
// browser nearly as much as if something had been drawn.
//
// Frames are held back when a few in a row have drawn nothing with WebGL. They go on at once with whatever happens to the page, and at
// the time for which egui has asked for its next frame, which the program says with `restFor` (src/platform/web/rest.rs).

/** So many frames in a row that draw nothing may come before the page rests … */
const FRAMES = 5;
/** … and so many where egui has said that it needs none for longer than this. */
const FRAMES_BEFORE_REST = 1;
const SOON_MS = 50;
/** Nobody rests longer, in case something happens that no event tells of. */
const LONGEST_MS = 1000;
/** All that people, their tools and other windows do to a page. */
const EVENTS =
  'pointerdown pointermove pointerup pointercancel pointerout mousedown mousemove mouseup click contextmenu wheel touchstart touchmove ' +
  'touchend touchcancel keydown keyup input change compositionstart compositionupdate compositionend selectionchange focusin focusout ' +
  'focus blur copy cut paste dragenter dragover dragleave drop resize scroll visibilitychange pageshow message storage hashchange ' +
  'popstate beforeprint afterprint';

const request = requestAnimationFrame.bind(globalThis);
const cancel = cancelAnimationFrame.bind(globalThis);

/** What is to be done in the next frame, and the browser's own number of that where it is not held back. */
const frames = new Map();
let last = 0;
let isHeld = false;
let hasDrawn = false;
/** Frames that may still draw nothing. */
let left = FRAMES;
/** The time of the last frame. */
let shownMs = 0;
/** When egui needs a frame. */
let dueMs = Infinity;
let timer;

function ask(id, frame) {
  frame.native = request((time) => {
    frames.delete(id);
    if (time !== shownMs) left -= 1;
    shownMs = time;
    frame.work(time);
  });
}

function wake(least = FRAMES) {
  left = Math.max(left, least);
  if (!isHeld) return;
  isHeld = false;
  clearTimeout(timer);
  for (const [id, frame] of frames) if (frame.native === undefined) ask(id, frame);
}

function hold() {
  isHeld = true;
  const now = performance.now();
  if (dueMs <= now) dueMs = Infinity;
  clearTimeout(timer);
  timer = setTimeout(wake, Math.min(dueMs - now, LONGEST_MS), FRAMES_BEFORE_REST);
}

globalThis.requestAnimationFrame = (work) => {
  last += 1;
  const frame = { work, native: undefined };
  frames.set(last, frame);
  if (hasDrawn) left = dueMs - performance.now() > SOON_MS ? FRAMES_BEFORE_REST : FRAMES;
  hasDrawn = false;
  if (left > 0) ask(last, frame);
  else hold();
  return last;
};

globalThis.cancelAnimationFrame = (id) => {
  const frame = frames.get(id);
  frames.delete(id);
  if (frame?.native !== undefined) cancel(frame.native);
};

/** egui needs no frame for so long, unless something happens. */
globalThis.restFor = (milliseconds) => {
  dueMs = performance.now() + milliseconds;
  if (milliseconds === 0) wake();
};

for (const name of ['drawElements', 'drawArrays', 'clear']) {
  const draw = globalThis.WebGL2RenderingContext?.prototype[name];
  if (!draw) continue;
  WebGL2RenderingContext.prototype[name] = function (...values) {
    hasDrawn = true;
    return draw.apply(this, values);
  };
}
for (const name of EVENTS.split(' ')) addEventListener(name, () => wake(), { capture: true, passive: true });
globalThis.visualViewport?.addEventListener('resize', () => wake());
