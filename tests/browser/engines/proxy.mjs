// A proxy that passes nothing on. Through it goes whatever a browser asks of other computers, so that what the page or its worker
// asks can be told from what the browser asks of its maker.

import { once } from 'node:events';
import { createServer as createHttp } from 'node:http';
import { createServer as createHttps } from 'node:https';
import { connect } from 'node:net';
import { generate } from 'selfsigned';

/** The pages of these tests; their server lets them say so to everybody (Referrer-Policy: unsafe-url). */
const OURS = /^http:\/\/127\.0\.0\.1:/;
/** The first byte of a TLS connection (RFC 8446, 5.1: handshake). */
const TLS = 22;

/** Whether a page or worker asks, and not the browser: it names one of ours, or says that another site is asked. */
function isAskedByPage({ headers }) {
  const site = headers['sec-fetch-site'];
  return OURS.test(headers.origin) || OURS.test(headers.referer) || (site !== undefined && site !== 'none');
}

/** `asked` lists what the page or its worker has asked of other computers: method and address. */
export async function startProxy() {
  const asked = [];
  const hear = (address) => (request, response) => {
    if (isAskedByPage(request)) asked.push(`${request.method} ${address(request)}`);
    response.writeHead(502).end();
  };
  const hearSocket = (address) => (request, socket) => {
    if (isAskedByPage(request)) asked.push(`${request.method} ${address(request)}`);
    socket.end('HTTP/1.1 502 Bad Gateway\r\n\r\n');
  };
  // Nobody has to trust it: the browsers are told to accept any.
  const { private: key, cert } = await generate([{ name: 'commonName', value: 'proxy.test' }], { keySize: 2048 });
  const inside = (scheme) => ({ headers, url }) => `${scheme}://${headers.host}${url}`;
  const secure = createHttps({ key, cert }, hear(inside('https'))).on('upgrade', hearSocket(inside('wss')));
  const plain = createHttp(hear(inside('http'))).on('upgrade', hearSocket(inside('ws')));

  const server = createHttp(hear(({ url }) => url)).on('upgrade', hearSocket(({ url }) => url));
  // A tunnel, for https and for sockets: what is asked stands inside it.
  server.on('connect', (request, socket) => {
    // A browser that is ended hangs up.
    socket.on('error', () => {});
    socket.once('data', (first) => {
      const inner = connect((first[0] === TLS ? secure : plain).address().port, '127.0.0.1');
      inner.on('error', () => socket.destroy());
      inner.write(first);
      socket.pipe(inner).pipe(socket);
    });
    socket.write('HTTP/1.1 200 Connection established\r\n\r\n');
  });
  for (const one of [server, secure, plain]) {
    one.on('clientError', (error, socket) => socket.destroy());
    one.listen(0, '127.0.0.1');
    await once(one, 'listening');
  }
  const close = () => {
    for (const one of [server, secure, plain]) {
      one.closeAllConnections();
      one.close();
    }
  };
  return { asked, port: server.address().port, close };
}
