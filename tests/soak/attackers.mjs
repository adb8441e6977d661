// attackers.mjs KIND URLS SCALE: one kind of attack on the server of URLS (JSON, see attack.mjs),
// by SCALE times as many clients as it has by itself, until SIGTERM. Prints as JSON how many
// connections it opened, the most at once, and what it was answered.
import { connect } from "node:net";

const [kind, urls_json, scale] = process.argv.slice(2);
const urls = JSON.parse(urls_json);
const { hostname, port } = new URL(urls.small);

const sleep = (ms) => new Promise((done) => setTimeout(done, ms));
const between = (least, most) => least + Math.random() * (most - least);
const request = (url) => {
  const { pathname, search } = new URL(url);
  return `GET ${pathname}${search} HTTP/1.1\r\nHost: ${hostname}\r\n\r\n`;
};
// From this machine's usual address, as behind a proxy that says nothing about its clients, or each
// time from another one.
const many = process.env.SLACKWATER_ATTACK_FROM === "many";
const octet = () => 1 + Math.floor(Math.random() * 254);
const from = () => (many ? `127.${octet()}.${octet()}.${octet()}` : undefined);
const HALF = `GET /collections HTTP/1.1\r\nHost: ${hostname}\r\nX-Slow: `;

const tally = { opened: 0, open: 0, most: 0, bytes: 0, statuses: {} };

// A connection that notes what comes. Read slowly: 4 kB each tenth of a second is 40 kB/s, little
// more than the server asks for; it is not closed for being slower.
function open({ slowly = false } = {}) {
  const read = slowly
    ? { buffer: Buffer.alloc(4096), callback: (n, bytes) => (note(bytes, n), false) }
    : { buffer: Buffer.alloc(65536), callback: (n, bytes) => (note(bytes, n), true) };
  const socket = connect({ host: hostname, port, localAddress: from(), onread: read });
  socket.setNoDelay(true);
  let is_open = false;
  function note(bytes, n) {
    tally.bytes += n;
    const status = /^HTTP\/1.1 (\d{3})/.exec(bytes.toString("latin1", 0, 16))?.[1];
    if (status) tally.statuses[status] = (tally.statuses[status] ?? 0) + 1;
    if (slowly) setTimeout(() => socket.destroyed || socket.resume(), 100);
    else if (status) socket.emit("answered");
  }
  socket.on("connect", () => {
    is_open = true;
    tally.opened += 1;
    tally.open += 1;
    tally.most = Math.max(tally.most, tally.open);
  });
  socket.on("error", () => {});
  socket.closed_once = new Promise((done) =>
    socket.on("close", () => {
      if (is_open) tally.open -= 1;
      done();
    }),
  );
  return socket;
}
const opened = (socket) =>
  Promise.race([new Promise((done) => socket.once("connect", done)), socket.closed_once]);

// Each attack is many clients that live the same life again and again.
const half_request = async () => {
  const socket = open();
  socket.write(HALF);
  await socket.closed_once;
};
const dripping = async () => {
  const socket = open();
  socket.write(HALF);
  const drip = setInterval(() => socket.write("x"), between(700, 1300));
  await socket.closed_once;
  clearInterval(drip);
};
const renewing = async () => {
  const socket = open();
  socket.write(HALF);
  await sleep(between(50, 150));
  socket.destroy();
};
const resetting = (asked) => async () => {
  const socket = open();
  await opened(socket);
  socket.write(request(asked()));
  await sleep(between(0, 50));
  socket.resetAndDestroy();
  await sleep(between(25, 75));
};
const reading_slowly = (asked) => async () => {
  const socket = open({ slowly: true });
  socket.write(request(asked()));
  await socket.closed_once;
};
// The whole answer as fast as it comes, then the next on the same connection.
const reading_all = (asked) => async () => {
  const { pathname, search } = new URL(asked());
  const socket = open();
  socket.write(
    `GET ${pathname}${search} HTTP/1.1\r\nHost: ${hostname}\r\nConnection: close\r\n\r\n`,
  );
  await socket.closed_once;
};
// Opened for nothing, for one small answer, or dropped with a reset.
const churning = async () => {
  const socket = open();
  await opened(socket);
  const fate = Math.random();
  if (fate < 0.5) {
    const answered = new Promise((done) => socket.once("answered", done));
    socket.write(request(urls.health));
    await Promise.race([answered, socket.closed_once, sleep(1000)]);
    socket.destroy();
  } else if (fate < 0.75) {
    socket.destroy();
  } else {
    socket.resetAndDestroy();
  }
  await sleep(between(5, 25));
};

const small = () => urls.small;
const polygon = () => urls.polygon;
const gridded = () => urls.gridded_polygon;
const middling = () => urls.middling;
const largest = () => urls.largest;
const kinds = {
  none: [0, half_request],
  half: [300, half_request],
  drip: [1500, dripping],
  renew: [300, renewing],
  resets: [256, resetting(small)],
  polygons: [64, resetting(polygon)],
  gridded: [64, resetting(gridded)],
  slow: [256, reading_slowly(middling)],
  slow_largest: [200, reading_slowly(largest)],
  slow_ten: [10, reading_slowly(largest)],
  largest: [8, reading_all(largest)],
  churn: [64, churning],
};

process.on("SIGTERM", () => {
  console.log(JSON.stringify(tally));
  process.exit(0);
});
const [count, life] = kinds[kind];
const clients = Math.ceil(count * Number(scale));
for (let i = 0; i < clients; i += 1) {
  setTimeout(
    async () => {
      for (;;) {
        await life();
        await sleep(between(5, 15)); // who is refused comes again, but not without a rest
      }
    },
    between(0, 500),
  );
}
setInterval(() => {}, 1000); // `none` waits too
