// edr_formats.mjs MODULES ANSWERS STANDARDS: every answer against the JSON schemas of its format, and CoverageJSON through
// covjson-reader, whose numbers must be those that were made up (tests/api/door/edr/made_up_answer.h).
import { strict as assert } from "node:assert";
import { readFileSync, readdirSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";

import { coverageJsonSchema, edrSchema } from "./edr_schemas.mjs";

const [modules, answers, standards] = process.argv.slice(2);
const require = createRequire(join(modules, "/"));
const CovJSON = require("covjson-reader");

function expectValid(validate, file, document) {
  assert(validate(document), `${file}: ${JSON.stringify(validate.errors?.slice(0, 5), null, 1)}`);
}

const madeUp = (coverage, parameter, i) => coverage + 0.125 * parameter - 0.001 * i;

/** Every index of a range in row-major order, as covjson-reader wants it. */
function* indices(axes) {
  if (axes.length === 0) {
    yield {};
    return;
  }
  const [[name, length], ...rest] = axes;
  for (let i = 0; i < length; ++i) for (const index of indices(rest)) yield { [name]: i, ...index };
}

async function expectReadable(file, document) {
  const read = await CovJSON.read(document);
  const coverages = read.type === "CoverageCollection" ? read.coverages : [read];
  assert.equal(coverages.length, file.includes("-3.") ? 3 : 1, file);
  let numbers = 0;
  for (const [c, coverage] of coverages.entries()) {
    const domain = await coverage.loadDomain();
    const systems = domain.referencing.map((each) => each.coordinates.join(""));
    assert(systems.includes("xy") && systems.includes("t"), `${file}: ${systems}`);
    assert.equal(systems.includes("z"), !file.includes("flat"), `${file}: ${systems}`);
    const ranges = await coverage.loadRanges();
    for (const [p, name] of [...coverage.parameters.keys()].entries()) {
      assert.equal(coverage.parameters.get(name).unit.symbol.value ?? coverage.parameters.get(name).unit.symbol, "m/s");
      const range = ranges.get(name);
      const axes = [...range.shape].sort(([a], [b]) => "tzyxcomposite".indexOf(a) - "tzyxcomposite".indexOf(b));
      let i = 0;
      for (const index of indices(axes)) {
        const value = range.get(index);
        if (p === 1 && i === 0) assert.equal(value, null, file);
        else assert(Math.abs(value - madeUp(c, p, i)) < 1e-6, `${file} ${name} ${i}: ${value}`);
        ++i;
        ++numbers;
      }
    }
  }
  return numbers;
}

const covjson = coverageJsonSchema(require, standards);
const edrCovjson = edrSchema(require, standards, "schemas/covjson/coverageJSON.yaml");
const edrGeojson = edrSchema(require, standards, "schemas/edr-geojson/edrFeatureCollectionGeoJSON.yaml");

// A gate that nothing can fail is none.
assert(!covjson({ type: "Coverage", domain: { type: "Domain", axes: {} }, ranges: {} }));
assert(!edrGeojson({ type: "FeatureCollection", features: [{ type: "Feature", geometry: null, properties: {} }] }));
assert(!edrCovjson({ type: "Coverage", parameters: { u: { type: "parameter" } } }));

let files = 0;
let numbers = 0;
for (const file of readdirSync(answers).sort()) {
  const parse = () => JSON.parse(readFileSync(join(answers, file), "utf8"));
  if (file.endsWith(".covjson")) {
    const document = parse();
    expectValid(covjson, file, document);
    expectValid(edrCovjson, file, document);
    numbers += await expectReadable(file, document);
  } else if (file.endsWith(".geojson")) {
    expectValid(edrGeojson, file, parse());
  } else {
    continue;
  }
  ++files;
}
assert.equal(files, 60);
console.log(`ajv accepts ${files} answers as CoverageJSON and EDR GeoJSON; covjson-reader read ${numbers} values`);
