// Serves the built page as a good static host does: compressed beforehand, and cached where names change with the content.

import { createServer } from 'node:http';
import { once } from 'node:events';
import { readFile, readdir } from 'node:fs/promises';
import path from 'node:path';
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
    response.writeHead(200, headers).end(file.bodies[encoding]);
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
