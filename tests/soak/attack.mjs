// attack.mjs URL PID SECONDS SCALE: see `attack` beside it. The attackers are a process of their
// own and nice; the innocent client is another and is not, so that on two cores what is measured is
// the server and not a client that finds no core. All of them come from one address, as they do
// through a proxy that says nothing about its clients; with SLACKWATER_ATTACK_FROM=many attackers
// do not.
import { spawn } from "node:child_process";
import { readFileSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const [url, pid, seconds, scale] = process.argv.slice(2);
const here = dirname(fileURLToPath(import.meta.url));
const given = (name, otherwise) => Number(process.env[name] || otherwise);

const LEAST_SERVED = given("SLACKWATER_LEAST_SERVED", 0.99);
const MOST_P99_MS = given("SLACKWATER_MOST_P99_MS", 50);
const MOST_AFTER_MS = given("SLACKWATER_MOST_AFTER_MS", 1000);
// 165^2 places x 73 hours: 1 987 425 values.
const RESOLUTION = given("SLACKWATER_LARGEST_RESOLUTION", 165);
const VERTICES = 740; // of a polygon, in 15 kB
const NICENESS = "5";

const ATTACKS = {
  none: "none",
  half: "300 half-requests",
  drip: "1500 half-requests, a byte now and then",
  renew: "300 half-requests that renew quickly",
  resets: "256 resets with a request in flight",
  polygons: "64 resets on 15 kB polygons",
  gridded: "64 resets on 15 kB polygons with a grid",
  slow: "256 slow readers",
  slow_largest: "200 slow readers of the largest answers",
  slow_ten: "10 slow readers of the largest answers",
  largest: "8 largest answers, again and again",
  churn: "connection churn",
};

const sleep = (ms) => new Promise((done) => setTimeout(done, ms));
const json_of = async (path) => (await fetch(url + path)).json();

// --- what is asked ---

async function urls_of_attack() {
  const { features } = await json_of("/collections/currents/locations?f=json");
  const [small, ...wide] = features;
  const [longitude, latitude] = small.geometry.coordinates;
  const first = small.properties.datetime.split("/")[0];
  const currents = `${url}/collections/currents`;
  const around = (deg) =>
    [longitude - deg, latitude - deg, longitude + deg, latitude + deg].map((x) => x.toFixed(4));
  // A star about the columns of the wide site, of as many points as 15 kB hold.
  const points = Array.from({ length: VERTICES }, (_, i) => {
    const radius_deg = i % 2 === 0 ? 0.09 : 0.03;
    const angle_rad = (2 * Math.PI * i) / VERTICES;
    const x = longitude + radius_deg * Math.cos(angle_rad);
    return `${x.toFixed(5)}%20${(latitude + radius_deg * Math.sin(angle_rad)).toFixed(5)}`;
  });
  const area = `area?coords=POLYGON((${[...points, points[0]].join(",")}))`;
  const speed = "z=5&parameter-name=sea_water_speed";
  const cube = `cube?bbox=${around(0.005)}&z=5`;
  const grid = (n) => `resolution-x=${n}&resolution-y=${n}`;
  return {
    columns: wide.length,
    small: `${currents}/position?coords=POINT(${longitude}%20${latitude})&z=5`,
    polygon: `${currents}/${area}&${speed}&datetime=${first}`,
    // 51^2 cells x 740 vertices: as much as is still worked out beside short answers.
    gridded_polygon: `${currents}/${area}&${speed}&datetime=${first}&${grid(51)}`,
    middling: `${currents}/${cube}&${grid(14)}`,
    largest: `${currents}/${cube}&${grid(RESOLUTION)}&parameter-name=sea_water_speed&f=CSV`,
    health: `${url}/health`,
  };
}

// --- the server ---

const memory_mb = (of) =>
  Number(new RegExp(`${of}:\\s*(\\d+)`).exec(readFileSync(`/proc/${pid}/status`, "utf8"))[1]) /
  1024;

async function once(from, limit_ms = 60_000) {
  const from_ms = performance.now();
  try {
    const answer = await fetch(from, {
      headers: { connection: "close" },
      signal: AbortSignal.timeout(limit_ms),
    });
    const { byteLength: bytes } = await answer.arrayBuffer();
    return { status: answer.status, bytes, took_ms: performance.now() - from_ms };
  } catch (error) {
    return { status: error.cause?.code ?? error.name, bytes: 0, took_ms: Infinity };
  }
}

// --- one row ---

function started(command, ...args) {
  const child = spawn(command, args, { stdio: ["ignore", "pipe", "inherit"] });
  let said = "";
  child.stdout.on("data", (data) => (said += data));
  child.said = new Promise((done) => child.on("close", () => done(said)));
  return child;
}

async function row_of(kind, urls) {
  const script = (name) => join(here, name);
  writeFileSync(`/proc/${pid}/clear_refs`, "5"); // VmHWM is counted anew
  const attackers = started(
    ...["nice", "-n", NICENESS, process.execPath],
    ...[script("attackers.mjs"), kind, JSON.stringify(urls), scale],
  );
  await sleep(1000); // it has begun
  const innocent = started(process.execPath, script("innocent.mjs"), urls.small, seconds);
  const served = JSON.parse(await innocent.said);
  attackers.kill("SIGTERM");
  const attacked = JSON.parse(await attackers.said);
  const after = await once(urls.small, 10_000);
  return {
    kind,
    served,
    attacked,
    after,
    most_mb: memory_mb("VmHWM"),
    then_mb: memory_mb("VmRSS"),
  };
}

// "renewed": how often the kept connection was opened anew, for the server closed it or was late.
const HEADS = [
  ["new", 6],
  ["served", 9],
  ["p50 ms", 8],
  ["p99 ms", 8],
  ["kept", 6],
  ["served", 9],
  ["p50 ms", 8],
  ["p99 ms", 8],
  ["renewed", 9],
  ["late ms", 9],
  ["RSS MB", 8],
  ["after ms", 10],
  ["opened/s", 10],
  ["at once", 9],
];
function line(name, ...cells) {
  const padded = cells.map((cell, i) => String(cell).padStart(HEADS[i]?.[1] ?? 0));
  console.log(name.padEnd(40) + padded.join(""));
}
const ms = (number) => (Number.isFinite(number) && number !== null ? number.toFixed(1) : "-");
const percent = (of) => `${((100 * of.served) / of.asked).toFixed(2)}%`;
const counts = (of) =>
  Object.entries(of)
    .map(([what, count]) => `${what}: ${count}`)
    .join(", ");

function print(row) {
  const { new: fresh, kept, late_ms } = row.served;
  line(
    ATTACKS[row.kind],
    ...[fresh.asked, percent(fresh), ms(fresh.p50_ms), ms(fresh.p99_ms)],
    ...[kept.asked, percent(kept), ms(kept.p50_ms), ms(kept.p99_ms), kept.connections - 1],
    ...[ms(late_ms), row.most_mb.toFixed(0), ms(row.after.took_ms)],
    ...[Math.round(row.attacked.opened / seconds), row.attacked.most],
    `  ${counts(row.attacked.statuses)}`,
  );
  const failures = [...Object.entries(fresh.failures), ...Object.entries(kept.failures)];
  if (failures.length > 0)
    console.log(`    failed: new ${counts(fresh.failures)}; kept ${counts(kept.failures)}`);
}

// What the row breaks.
function faults_of(row, most_mb) {
  const faults = [];
  for (const kind of ["new", "kept"]) {
    const of = row.served[kind];
    if (!(of.served >= LEAST_SERVED * of.asked))
      faults.push(`${percent(of)} served on ${kind} ones`);
    if (!(of.p99_ms !== null && of.p99_ms <= MOST_P99_MS))
      faults.push(`p99 ${ms(of.p99_ms)} ms on ${kind} ones`);
  }
  if (row.most_mb > most_mb) faults.push(`${row.most_mb.toFixed(0)} MB`);
  if (row.after.status !== 200 || row.after.took_ms > MOST_AFTER_MS) {
    faults.push(`afterwards ${row.after.status} in ${ms(row.after.took_ms)} ms`);
  }
  return faults.map((fault) => `${ATTACKS[row.kind]}: ${fault}`);
}

const urls = await urls_of_attack();
const { columns, ...asked } = urls;
const rest_mb = memory_mb("VmRSS");
let largest_mb = 0;
for (const [name, each] of Object.entries(asked)) {
  const { status, bytes, took_ms } = await once(each);
  console.log(`attack: ${name}: ${status}, ${(bytes / 1e6).toFixed(2)} MB in ${ms(took_ms)} ms`);
  largest_mb = Math.max(largest_mb, bytes / 2 ** 20);
  if (status !== 200) throw new Error(`${name} is not there`);
}
console.log(
  `attack: the wide site has ${columns} columns; the server at rest ${rest_mb.toFixed(0)} MB`,
);
line("", ...HEADS.map(([head]) => head), "  answers to attackers");
const wanted = (process.env.SLACKWATER_ATTACKS || Object.keys(ATTACKS).join(" ")).split(/\s+/);
const rows = [];
for (const kind of wanted) {
  const row = await row_of(kind, asked);
  print(row);
  rows.push(row);
  await sleep(500);
}

// What is at rest, the answers that clients take in, and two that are being written: a text that
// grows is there twice over and once more while it is moved.
const ANSWERS_MB = 256;
const BEING_WRITTEN = 2 * 3;
const most_mb = given(
  "SLACKWATER_MOST_MB",
  Math.ceil(rest_mb + ANSWERS_MB + BEING_WRITTEN * largest_mb),
);
console.log(`attack: at most ${most_mb} MB`);
const faults = rows.flatMap((row) => faults_of(row, most_mb));
for (const fault of faults) console.log(`attack: ${fault}`);
process.exitCode = faults.length > 0 ? 1 : 0;
