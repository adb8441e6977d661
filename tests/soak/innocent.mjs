// innocent.mjs URL SECONDS: a client as there are many: 50 requests a second, in turn on a new
// connection and on a kept one. Prints as JSON how many of each were served (200, whole, within
// 5 s), what the others met, and how long the served took. `late_ms` is how late this process
// itself was, of the slowest hundredth of its turns: what is slower than that is the server.
import { Agent, get } from "node:http";

const [url, seconds] = process.argv.slice(2);
const EVERY_MS = 20;
const LIMIT_MS = 5000;

const agents = {
  new: new Agent({ keepAlive: false }),
  kept: new Agent({ keepAlive: true, maxSockets: 1 }),
};
const tallies = {};
for (const kind of Object.keys(agents)) {
  tallies[kind] = { asked: 0, took_ms: [], failures: {}, connections: new Set() };
}

// From the moment it wants to ask: what waits for its turn on the kept connection counts too.
function ask(kind) {
  return new Promise((done) => {
    const tally = tallies[kind];
    tally.asked += 1;
    const from_ms = performance.now();
    const end = (failure) => {
      clearTimeout(limit);
      if (failure) tally.failures[failure] = (tally.failures[failure] ?? 0) + 1;
      else tally.took_ms.push(performance.now() - from_ms);
      done();
    };
    const request = get(url, { agent: agents[kind] }, (answer) => {
      answer.resume();
      answer.on("end", () => end(answer.statusCode === 200 ? null : answer.statusCode));
      answer.on("error", (error) => end(error.code));
    });
    const limit = setTimeout(() => request.destroy({ code: "later than 5 s" }), LIMIT_MS);
    request.on("socket", (socket) => tally.connections.add(socket.localPort ?? socket));
    request.on("error", (error) => end(error.code));
  });
}

const quantile = (sorted, share) => sorted[Math.ceil(sorted.length * share) - 1] ?? null;
const ascending = (numbers) => numbers.sort((a, b) => a - b);

const late_ms = [];
const waiting = [];
const begun_ms = performance.now();
const turns = Math.round((seconds * 1000) / EVERY_MS);
for (let turn = 0; turn < turns; turn += 1) {
  const due_ms = begun_ms + turn * EVERY_MS;
  const wait_ms = due_ms - performance.now();
  await new Promise((done) => (wait_ms > 0 ? setTimeout(done, wait_ms) : setImmediate(done)));
  late_ms.push(performance.now() - due_ms);
  waiting.push(ask(turn % 2 === 0 ? "new" : "kept"));
}
await Promise.all(waiting);

const found = { late_ms: quantile(ascending(late_ms), 0.99) };
for (const [kind, { asked, took_ms, failures, connections }] of Object.entries(tallies)) {
  ascending(took_ms);
  found[kind] = {
    asked,
    served: took_ms.length,
    failures,
    connections: connections.size,
    p50_ms: quantile(took_ms, 0.5),
    p99_ms: quantile(took_ms, 0.99),
  };
}
console.log(JSON.stringify(found));
for (const agent of Object.values(agents)) agent.destroy();
