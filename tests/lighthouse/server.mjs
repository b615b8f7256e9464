// Serves the built page as a good static host does: compressed beforehand, cached where names change with the content, and
// over a line of 10 Mbit/s. At the speed of a file on the same computer everything would have arrived before the browser
// has painted anything, and what the simulated phone waits for would count as waited for by the first words on the page.

import { createServer } from 'node:http';
import { once } from 'node:events';
import { readFile, readdir } from 'node:fs/promises';
import path from 'node:path';
import { setTimeout as sleep } from 'node:timers/promises';
import { brotliCompressSync, gzipSync } from 'node:zlib';

const TYPES = {
  '.css': 'text/css; charset=utf-8',
  '.html': 'text/html; charset=utf-8',
  '.js': 'text/javascript; charset=utf-8',
  '.json': 'application/json',
  '.png': 'image/png',
  '.svg': 'image/svg+xml',
  '.txt': 'text/plain; charset=utf-8',
  '.wasm': 'application/wasm',
  '.webmanifest': 'application/manifest+json',
  '.xml': 'application/xml',
};
/** Trunk writes the hash of the content into the name. */
const HASHED = /-[0-9a-f]{16}(_bg)?\.\w+$/;

/** Every file of `folder` by the path it is asked for, with what is sent for each encoding. */
async function read(folder) {
  const files = new Map();
  for (const entry of await readdir(folder, { recursive: true, withFileTypes: true })) {
    if (!entry.isFile()) continue;
    const file = path.join(entry.parentPath ?? entry.path, entry.name);
    const content = await readFile(file);
    const worthwhile = path.extname(file) !== '.png';
    files.set(`/${path.relative(folder, file).replaceAll(path.sep, '/')}`, {
      type: TYPES[path.extname(file)] ?? 'application/octet-stream',
      cache: HASHED.test(file) ? 'public, max-age=31536000, immutable' : 'no-cache',
      bodies: worthwhile ? { br: brotliCompressSync(content), gzip: gzipSync(content), identity: content } : { identity: content },
    });
  }
  files.set('/', files.get('/index.html'));
  return files;
}

const PIECE_BYTES = 12_500;
const PIECE_MS = 10;

/** Sends `body` at 10 Mbit/s. */
async function send(response, body) {
  for (let at = 0; at < body.length && !response.destroyed; at += PIECE_BYTES) {
    if (at > 0) await sleep(PIECE_MS);
    response.write(body.subarray(at, at + PIECE_BYTES));
  }
  response.end();
}

/** Serves `folder` on a free port of this computer. */
export async function startServer(folder) {
  const files = await read(folder);
  const server = createServer((request, response) => {
    const file = files.get(new URL(request.url, 'http://host').pathname);
    if (!file) {
      response.writeHead(404, { 'content-type': 'text/plain; charset=utf-8' }).end('There is no such file.');
      return;
    }
    const accepted = (request.headers['accept-encoding'] ?? '').split(/[\s,]+/);
    const encoding = ['br', 'gzip'].find((name) => accepted.includes(name) && file.bodies[name]) ?? 'identity';
    const headers = { 'content-type': file.type, 'cache-control': file.cache, vary: 'accept-encoding' };
    if (encoding !== 'identity') headers['content-encoding'] = encoding;
    response.writeHead(200, headers);
    send(response, file.bodies[encoding]);
  });
  server.listen(0, '127.0.0.1');
  await once(server, 'listening');
  return {
    url: `http://127.0.0.1:${server.address().port}/`,
    close() {
      server.closeAllConnections();
      server.close();
    },
  };
}
