// Has the page kept on this computer (sw.js), and offers a new version when there is one.
// Without any of this the page works, but not without a network.

const element = (id) => document.getElementById(id);
const thisBuild = document.querySelector('meta[name="build"]').content;

/** The program ends where the offer begins, so that nothing is covered by it: at a whole pixel. */
function makeRoom() {
  const { height } = element('update').getBoundingClientRect();
  document.body.style.setProperty('--offer', `${Math.ceil(height)}px`);
}

new ResizeObserver(makeRoom).observe(element('update'));

/** Offers to change to the build of `worker`. What somebody is doing is never interrupted. */
function offer(worker) {
  element('update').hidden = false;
  // After it has appeared, or screen readers do not say it.
  requestAnimationFrame(() => {
    element('update-what').textContent = 'A new version is ready.';
  });
  element('update-later').onclick = () => {
    element('update').hidden = true;
  };
  element('update-now').onclick = () => {
    // Another tab may have changed already.
    if (worker.state !== 'installed') {
      location.reload();
      return;
    }
    worker.addEventListener('statechange', () => {
      if (worker.state !== 'activating') location.reload();
    });
    worker.postMessage('activate');
  };
}

/** Pages come from the network first, so this one may be of the build that waits: then nothing has to be offered. */
function onWaiting(worker) {
  const { port1, port2 } = new MessageChannel();
  port1.onmessage = ({ data: build }) => {
    if (build === thisBuild) worker.postMessage('activate');
    else offer(worker);
  };
  worker.postMessage('build', [port2]);
}

async function register() {
  const registration = await navigator.serviceWorker.register('./sw.js', { updateViaCache: 'none' });
  const watch = (worker) => {
    worker?.addEventListener('statechange', () => {
      // The very first one replaces nothing.
      if (worker.state === 'installed' && registration.active) onWaiting(worker);
      if (worker.state === 'redundant' && !registration.active) {
        console.info('This page will not open without a network: its files did not arrive as they were built.');
      }
    });
  };
  if (registration.waiting) onWaiting(registration.waiting);
  // The browser looks for a new version by itself when the page is opened, and may have begun with it.
  watch(registration.installing);
  registration.addEventListener('updatefound', () => watch(registration.installing));
  // A calculator may stay open for days, and browsers look for a new version only when a page is opened.
  document.addEventListener('visibilitychange', () => {
    // Nothing is lost when there is no network.
    if (document.visibilityState === 'visible') registration.update().catch(() => {});
  });
}

// After the first frame: until then the network belongs to the program.
new PerformanceObserver((list, observer) => {
  if (list.getEntriesByName('first-frame').length === 0) return;
  observer.disconnect();
  // Browsers leave it out of pages that did not arrive securely.
  if (!('serviceWorker' in navigator)) return;
  register().catch((error) => console.info('This page will not open without a network:', error));
}).observe({ type: 'mark', buffered: true });
