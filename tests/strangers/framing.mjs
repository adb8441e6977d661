// framing.mjs READER COUNT: made-up requests, right, wrong and doubtful, as our reader (read_requests) and the one of Node (llhttp, not
// lenient) take them. What llhttp refuses we refuse; what both take is the same requests with the same bodies. We may refuse more. Two
// things are not the reader's: which methods there are (a word that llhttp does not know ends the comparison: we answer 405), and that
// nothing is answered after "Connection: close".
import { strict as assert } from "node:assert";
import { spawnSync } from "node:child_process";

const [reader, count] = process.argv.slice(2);
process.noDeprecation = true;
const { HTTPParser, methods, allMethods } = process.binding("http_parser");
const names = allMethods ?? methods;

let seed = 38;
const draw = () => {
  seed = (Math.imul(seed, 1664525) + 1013904223) >>> 0;
  return seed / 2 ** 32;
};
const one = (list) => list[Math.floor(draw() * list.length)];
const often = (usual, others, share = 0.3) => (draw() < share ? one(others) : usual);

const METHODS = ["GET", "HEAD", "OPTIONS", "POST", "PUT", "DELETE"];
const ODD_METHODS = ["CONNECT", "get", "G T", "", "PRI", "POST\t", "X-NEW"];
const TARGETS = ["/", "/a?b=c", "/a%20b", "http://h/a", "*"];
const ODD_TARGETS = ["/\xe4", "/a b", "/\x7f", "", "/\x00", "/a#b", "/" + "x".repeat(300)];
const LENGTHS = ["0", "5", "4", "10", "+5", "-1", "5, 5", "5 ", "0x5", "", "05", "5;5", "99999999999999999999", "5\x0b"];
const CODINGS = ["chunked", "Chunked", "gzip", "chunked, gzip", "gzip, chunked", "chunked, chunked", "identity", "", " chunked", "chunked;q=1", "xchunked", "chunked,"];
const CHUNKS = ["5\r\nhello\r\n0\r\n\r\n", "5;a=b\r\nhello\r\n0\r\n\r\n", "5\r\nhello\r\n0\r\nX: y\r\n\r\n", "5\r\nhello\r\n0\r\nHost: evil\r\nContent-Length: 3\r\n\r\n",
  "5\nhello\n0\n\n", "5 \r\nhello\r\n0\r\n\r\n", "05\r\nhello\r\n0\r\n\r\n", "5\r\nhellox\r\n0\r\n\r\n", "g\r\nhello\r\n0\r\n\r\n", "-5\r\nhello\r\n0\r\n\r\n",
  "ffffffffffffffffff\r\nhello\r\n", "5\r\nhello\r\n0\r\n", "0\r\n\r\n", "5\r\nhello0\r\n\r\n", "0x5\r\nhello\r\n0\r\n\r\n", "5\r\nhel", "1\r\na\r\n3\r\nbcd\r\n0\r\n\r\n"];
const OTHERS = ["Accept: */*", "X: y", "X:y", "X:", "X:\ty ", "Connection: close", "Connection: keep-alive", "Expect: 100-continue"];
const ODD = ["X : y", " X: y", "X\r\n y", "X: a\r\n b", "X: a\nY: b", "X: a\rY: b", ": y", "X", "X\x00: y", "X: \x00", "X: \xe4", "X[: y", "\x80: y", "X: a\r\r\n", "Host: b", "Transfer-Encoding : chunked", "Content-Length\t: 5"];

function request() {
  const lines = [`${often(one(METHODS), ODD_METHODS, 0.1)} ${often(one(TARGETS), ODD_TARGETS, 0.15)} ${often("HTTP/1.1", ["HTTP/1.0", "HTTP/2.0", "HTTP/1.2", "HTTP/1.1 ", "http/1.1", "HTTP/0.9", "HTTP/11", ""], 0.15)}`];
  lines.push(often("Host: h", ["Host:h", "Host: ", "X-Host: h"], 0.1));
  let body = "";
  const framing = draw();
  if (framing < 0.3) {
    lines.push(`Content-Length: ${often("5", LENGTHS)}`);
    body = "hello";
  } else if (framing < 0.65) {
    lines.push(`Transfer-Encoding: ${often("chunked", CODINGS)}`);
    body = often(CHUNKS[0], CHUNKS, 0.6);
  } else if (framing < 0.75) {
    lines.push(one([`Content-Length: 5\r\nContent-Length: ${one(["5", "6"])}`, "Content-Length: 5\r\nTransfer-Encoding: chunked", "Transfer-Encoding: chunked\r\nTransfer-Encoding: chunked", "Transfer-Encoding: gzip\r\nTransfer-Encoding: chunked"]));
    body = one(["hello", CHUNKS[0]]);
  }
  while (draw() < 0.4) lines.push(often(one(OTHERS), ODD, 0.35));
  for (let i = lines.length - 1; i > 1; --i) {
    const j = 1 + Math.floor(draw() * i);
    [lines[i], lines[j]] = [lines[j], lines[i]];
  }
  const end = often("\r\n", ["\n", "\r", "\r\n\r\n"], 0.03);
  return lines.join(end) + often("\r\n\r\n", ["\n\n", "\r\n\n", "\r\n"], 0.04) + body;
}

function made() {
  let text = draw() < 0.03 ? "\r\n" : "";
  for (let left = 1 + Math.floor(draw() * 2.4); left > 0; --left) text += request();
  const bytes = Buffer.from(text, "latin1");
  if (draw() > 0.25) return bytes;
  const at = Math.floor(draw() * bytes.length);
  const kind = draw();
  if (kind < 0.4) {
    const flipped = Buffer.from(bytes);
    flipped[at] ^= 1 << Math.floor(draw() * 8);
    return flipped;
  }
  if (kind < 0.7) return Buffer.concat([bytes.subarray(0, at), bytes.subarray(at + 1)]);
  return Buffer.concat([bytes.subarray(0, at), Buffer.from([Math.floor(draw() * 256)]), bytes.subarray(at)]);
}

/** The requests that llhttp takes, and how it ends. */
function theirs(bytes) {
  const parser = new HTTPParser();
  parser.initialize(HTTPParser.REQUEST, {}, 80 * 1024, 0);
  const taken = [];
  let now = null;
  let is_upgrade = false;
  let url_before = "";
  parser[HTTPParser.kOnHeaders] = (headers, url) => void (url_before += now === null ? url : ""); // else trailers
  parser[HTTPParser.kOnHeadersComplete] = (major, minor, headers, method, url, code, message, upgrade) => {
    now = { method: names[method], url: url ?? url_before, body: [] };
    url_before = "";
    is_upgrade ||= upgrade;
    return 0;
  };
  parser[HTTPParser.kOnBody] = (part, from, size) => void now.body.push(size === undefined ? Buffer.from(part) : Buffer.from(part.subarray(from, from + size)));
  parser[HTTPParser.kOnMessageComplete] = () => {
    taken.push(`${now.method} ${now.url.replace(/\?$/, "")} ${Buffer.concat(now.body).toString("hex")}`);
    now = null;
  };
  const result = parser.execute(bytes);
  const is_refused = result instanceof Error;
  parser.close?.();
  const { code } = result;
  if (code === "HPE_CLOSED_CONNECTION" || code === "HPE_INVALID_METHOD") return { taken, end: "not compared" };
  if (code === "HPE_INVALID_VERSION" && bytes.includes("PRI ")) return { taken, end: "not compared" }; // of HTTP/2, to llhttp
  return { taken, end: is_refused ? `refused ${result.code}` : is_upgrade ? "upgrade" : "more" };
}

/** The same of ours, of many. */
function ours_of(all) {
  const input = all.map((it) => it.toString("hex") + "\n").join("");
  const { stdout, status, stderr } = spawnSync(reader, { input, maxBuffer: 1 << 30, encoding: "latin1" });
  assert.equal(status, 0, stderr);
  const lines = stdout.split("\n");
  assert.equal(lines.length, all.length + 1);
  return all.map((_, nth) => {
    const taken = lines[nth].split("\t");
    return { end: taken.pop(), taken };
  });
}

const all = Array.from({ length: Number(count) }, made);
const all_ours = ours_of(all);
const seen = {};
const faults = [];
const unfinished = []; // headers of which llhttp refuses a line, where we wait for the last one
all.forEach((bytes, nth) => {
  const ours = all_ours[nth];
  const his = theirs(bytes);
  const fault = (why) => faults.push(`${why}: ${JSON.stringify(bytes.toString("latin1"))}\n  ours ${JSON.stringify(ours)}\n  llhttp ${JSON.stringify(his)}`);
  const shared = Math.min(ours.taken.length, his.taken.length);
  const differ = ours.taken.slice(0, shared).some((it, i) => it !== his.taken[i]);
  const is_stricter = ours.end.startsWith("refused");
  if (differ) fault("another request");
  else if (his.end === "not compared") (() => {})();
  else if (ours.taken.length > his.taken.length && his.end !== "upgrade") fault("we take what llhttp does not");
  else if (his.end.startsWith("refused") && !is_stricter) unfinished.push(bytes);
  else if (ours.taken.length < his.taken.length && !is_stricter) fault("we wait for more of what llhttp has whole");
  const key = `${ours.end.split(" ")[0]}/${his.end.split(" ")[0]}`;
  seen[key] = (seen[key] ?? 0) + 1;
});
ours_of(unfinished.map((it) => Buffer.concat([it, Buffer.from("\r\n\r\n")]))).forEach((ours, nth) => {
  if (!ours.end.startsWith("refused")) faults.push(`llhttp refuses, we do not: ${JSON.stringify(unfinished[nth].toString("latin1"))}\n  ${JSON.stringify(ours)}`);
});
console.log(`${all.length} made-up requests, ours/llhttp: ${JSON.stringify(seen)}`);
for (const text of faults.slice(0, 12)) console.log(text);
assert.equal(faults.length, 0, `${faults.length} differences`);
