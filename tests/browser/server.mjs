// Serves the built page as a static host does, from a folder below the root, and can fail on purpose.

import { createHash } from 'node:crypto';
import { createServer } from 'node:http';
import { once } from 'node:events';
import { readFile } from 'node:fs/promises';
import path from 'node:path';
import { setTimeout as sleep } from 'node:timers/promises';
import { settings } from './settings.mjs';

const DIST = path.resolve(settings.dist ?? '.');
/** The page must work from any folder. */
const BASE = '/some/folder/';

/** A page with nothing on it, of the same origin. */
export const EMPTY = '/empty';

const TYPES = {
  '.css': 'text/css; charset=utf-8',
  '.html': 'text/html; charset=utf-8',
  '.js': 'text/javascript; charset=utf-8',
  '.json': 'application/json',
  '.png': 'image/png',
  '.svg': 'image/svg+xml',
  '.wasm': 'application/wasm',
  '.webmanifest': 'application/manifest+json',
};

/**
 * `programs` says what happens to the WebAssembly file: 'sent', 'missing' (404), 'cut' (the connection
 * ends in the middle), 'held' (in twentieths, as many as `pieces` says so far), 'broken' (not a program) or 'old type' (sent with a wrong type).
 * `changed` holds, by a file's name, what to make of its text before it is sent, perhaps later; `added` the texts of scripts that
 * are not in the folder. The worker waits for this server as long as need be, unless it is `impatient`, as it is elsewhere: how fast
 * this computer is just now is no part of a test.
 */
export async function startServer() {
  const state = { programs: 'sent', pieces: 0, impatient: false, changed: new Map(), added: new Map() };
  /** A page from a port that was used before would find what that one left in the browser. */
  const used = new Set();
  let server;
  let origin;

  async function sendProgram(response, content) {
    switch (state.programs) {
      case 'missing':
        response.writeHead(404).end();
        return;
      case 'cut':
        // The connection ends when the first half is on its way.
        response.write(content.subarray(0, content.length / 2), () => response.destroy());
        return;
      case 'broken':
        response.end(Buffer.alloc(content.length, 'This is not a program. '));
        return;
      case 'held':
        response.setHeader('content-length', content.length);
        for (let piece = 0; piece < 20 && !response.destroyed; piece += 1) {
          while (state.pieces <= piece && !response.destroyed) await sleep(20);
          response.write(content.subarray((piece * content.length) / 20, ((piece + 1) * content.length) / 20));
        }
        response.end();
        return;
      case 'old type':
        response.setHeader('content-type', 'application/octet-stream');
        response.end(content);
        return;
      default:
        response.end(content);
    }
  }

  async function answer(request, response) {
    try {
      const { pathname } = new URL(request.url, 'http://host');
      if (pathname === EMPTY) {
        // With an icon of its own: what the browser says about one that is missing would come at any time.
        response.setHeader('content-type', TYPES['.html']);
        response.end('<!doctype html><title>Nothing</title><link rel="icon" href="data:,">');
        return;
      }
      const name = pathname.startsWith(BASE) ? pathname.slice(BASE.length) || 'index.html' : undefined;
      const file = name && path.join(DIST, name);
      if (!file?.startsWith(DIST + path.sep)) throw new Error('outside');
      let content = state.added.get(name) ?? (await readFile(file));
      if (name === 'sw.js' && !state.impatient) content = content.toString().replace(/PATIENCE_MS = \d+/, 'PATIENCE_MS = 600_000');
      response.setHeader('content-type', TYPES[path.extname(file)] ?? 'application/octet-stream');
      response.setHeader('cache-control', 'no-store');
      // Whoever is asked learns that this page asks: the proxy tells it from the browser by that.
      response.setHeader('referrer-policy', 'unsafe-url');
      if (file.endsWith('.wasm')) await sendProgram(response, content);
      else response.end((await state.changed.get(name)?.(content.toString())) ?? content);
    } catch {
      if (!response.headersSent) response.writeHead(404, { 'content-type': 'text/plain' });
      response.end('There is no such file.');
    }
  }

  async function listen() {
    do {
      server?.close();
      server = createServer(answer).listen(0, '127.0.0.1');
      await once(server, 'listening');
    } while (used.has(server.address().port));
    used.add(server.address().port);
    origin = `http://127.0.0.1:${server.address().port}`;
  }

  function close() {
    server.closeAllConnections();
    server.close();
  }

  await listen();
  return {
    get origin() {
      return origin;
    },
    get url() {
      return origin + BASE;
    },
    state,
    /** An origin that no page has been at, and files as they are: what a page has stored, kept or allowed is not there. */
    async renew() {
      close();
      Object.assign(state, { programs: 'sent', pieces: 0, impatient: false });
      state.changed.clear();
      state.added.clear();
      await listen();
    },
    /** From now on the page is what `change` makes of it, and the worker, which `changeWorker` may change, expects that one. */
    async changePage(change, changeWorker = (text) => text) {
      const digest = (text) => `sha256-${createHash('sha256').update(text).digest('base64')}`;
      const html = await readFile(path.join(DIST, 'index.html'), 'utf8');
      state.changed.set('index.html', change).set('sw.js', (text) => changeWorker(text).replace(digest(html), digest(change(html))));
    },
    close,
  };
}
