// What the server answers to programs: each is what its type says, never a page; its JSON can be read and holds the texts
// unchanged.
import { execFileSync } from "node:child_process";
import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { fields, text_of } from "./fields.mjs";
import { sleep } from "./look.mjs";
import { cdl } from "./payloads.mjs";

const MOST_ASKS = 60;

const SERVER = ["/", "/conformance", "/sites", "/sessions", "/health", "/missions"];
const OF_SITE = ["/texts", "/windows", "/report", "/plan", "/verification", "/decisions", "/traffic", "/slack"];
const DOCUMENTS = [...SERVER, ...["", ...OF_SITE, "/sources?day=2025-03-08"].map((it) => `/sites/planted${it}`)];
const TYPES = {
  CoverageJSON: "application/prs.coverage+json",
  GeoJSON: "application/geo+json",
  CSV: "text/csv",
  NetCDF: "application/netcdf",
  JSON: "application/json",
};

/** Every text in a document. */
const texts_in = (value) =>
  typeof value === "string"
    ? [value]
    : value && typeof value === "object"
      ? Object.entries(value).flatMap(([key, it]) => [key, ...texts_in(it)])
      : [];

export class Answers {
  faults = [];
  #seen = new Map();

  constructor(address, work) {
    this.address = address;
    this.work = work;
  }

  async get(path, type, init = {}) {
    let answer = await fetch(this.address + path, init);
    for (let i = 0; i < MOST_ASKS && answer.status === 503; ++i) {
      await sleep(1000); // it is busy
      answer = await fetch(this.address + path, init);
    }
    const told = answer.headers.get("Content-Type") ?? "none";
    const name = decodeURIComponent(path);
    if (!told.startsWith(type)) this.faults.push(`${name}: ${told}, expected ${type}`);
    if (answer.headers.get("X-Content-Type-Options") !== "nosniff") this.faults.push(`${name}: may be sniffed`);
    return answer;
  }

  note(name, texts) {
    this.#seen.set(name, [...(this.#seen.get(name) ?? []), ...texts]);
  }

  async json(path, type = "application/json", init = {}) {
    const document = JSON.parse(await (await this.get(path, type, init)).text()); // throws where it is none
    this.note(path.replace(/\?.*/u, ""), texts_in(document));
    return document;
  }

  /** Values of one place in every format. */
  async values(name, query) {
    for (const [format, type] of Object.entries(TYPES)) {
      const path = `${query}&f=${format}`;
      if (/JSON/u.test(format)) {
        this.note(`${name}.${format}`, texts_in(await this.json(path, type)));
      } else if (format === "CSV") {
        const { headers } = await this.get(path, type);
        const told = [...headers].filter(([key]) => key.startsWith("slackwater-"));
        for (const [key, value] of told) if (!/^[ -~]*$/u.test(value)) this.faults.push(`${name}: ${key} is not plain`);
        this.note(
          `${name}.csv`,
          told.map(([, value]) => decodeURIComponent(value)),
        );
      } else {
        const file = join(this.work, "answer.nc");
        writeFileSync(file, Buffer.from(await (await this.get(path, type)).arrayBuffer()));
        const head = execFileSync("ncdump", ["-h", file], { encoding: "utf8" });
        this.note(
          `${name}.nc`,
          fields.map(text_of).filter((text) => head.includes(cdl(text).slice(1, -1))),
        );
      }
    }
  }

  where(text) {
    return [...this.#seen].filter(([, texts]) => texts.some((it) => it.includes(text))).map(([name]) => name);
  }
}

export async function ask_all(answers) {
  for (const path of DOCUMENTS) await answers.json(path);
  await answers.json("/api", "application/vnd.oai.openapi+json");
  const { collections } = await answers.json("/collections");
  const at = "coords=POINT(-2.55%2048.85)";
  for (const { id, data_queries } of collections) {
    const path = `/collections/${encodeURIComponent(id)}`;
    const is_alike = ["currents-members", "wind", "wind-members", "waves", "sea-level"].includes(id);
    if (is_alike) continue;
    await answers.json(path);
    for (const query of ["items", "locations"])
      if (query in data_queries) await answers.json(`${path}/${query}`, "application/geo+json");
    await answers.values(
      id.slice(0, 40),
      `${path}/position?${at}&datetime=2025-03-08T12:00:00Z/2025-03-09T12:00:00Z${id.startsWith("currents") ? "&z=5" : ""}`,
    );
  }
  // What a stranger writes into an address comes back in words, as a problem document.
  const tricks = encodeURIComponent(text_of("decision note"));
  for (const path of [
    `/${tricks}`,
    `/?f=${tricks}`,
    `/collections/${tricks}?f=html`,
    `/collections/currents/position?coords=${tricks}`,
    `/sites/${tricks}`,
    `/sessions/${tricks}`,
  ])
    await answers.json(path, "application/problem+json", { headers: { Accept: "text/html" } });
}
