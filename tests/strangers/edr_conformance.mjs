// edr_conformance.mjs MODULES STANDARDS BASE: the service at BASE, document by document, against the schemas of EDR 1.1 and of
// CoverageJSON; every CoverageJSON answer through covjson-reader; landing page, conformance and collections through ogc-client.
import { strict as assert } from "node:assert";
import { createRequire } from "node:module";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";

import { coverageJsonSchema, edrSchema } from "./edr_schemas.mjs";

const [modules, standards, base] = process.argv.slice(2);
const require = createRequire(join(resolve(modules), "/"));
const CovJSON = require("covjson-reader");
const schema = (path) => edrSchema(require, standards, `schemas/${path}`);
const covjson = coverageJsonSchema(require, standards);
const edrCovjson = schema("covjson/coverageJSON.yaml");

async function get(path, type) {
  const answer = await fetch(path.startsWith("http") ? path : base + path);
  const text = await answer.text();
  assert.equal(answer.status, 200, `${path}: ${text.slice(0, 400)}`);
  if (type) assert.equal(answer.headers.get("content-type"), type, path);
  return JSON.parse(text);
}

function expectValid(validate, path, document) {
  assert(validate(document), `${path}: ${JSON.stringify(validate.errors?.slice(0, 5), null, 1)}`);
}

async function expectDocument(validate, path, type = "application/json") {
  const document = await get(path, type);
  expectValid(validate, path, document);
  return document;
}

const landingPage = schema("core/landingPage.yaml");
const confClasses = schema("core/confClasses.yaml");
const collectionsSchema = schema("collections/collections.yaml");
const collectionSchema = schema("collections/collection.yaml");
const instancesSchema = schema("queries/instances.yaml");
const features = schema("edr-geojson/edrFeatureCollectionGeoJSON.yaml");
const feature = schema("geojson/featureGeoJSON.yaml");
const parameterNames = schema("collections/parameterNames.yaml");

// A gate that nothing can fail is none.
assert(!landingPage({ title: "no links" }));
assert(!collectionSchema({ id: "x", links: [] }));
assert(!covjson({ type: "Coverage", domain: { type: "Domain", axes: {} }, ranges: {} }));

let documents = 0;
async function checkMetadata() {
  await expectDocument(landingPage, "/");
  await expectDocument(confClasses, "/conformance");
  const { collections } = await expectDocument(collectionsSchema, "/collections");
  documents += 3;
  for (const listed of collections) {
    const at = `/collections/${listed.id}`;
    const collection = await expectDocument(collectionSchema, at);
    // The schema of collections puts these below "items" of an object, where nothing looks at them.
    for (const [name, each] of Object.entries(collection.parameter_names)) expectValid(parameterNames, name, each);
    await expectDocument(features, `${at}/locations`, "application/geo+json");
    // A stored product has been issued by nobody here.
    if (/^(product|instrument)-/.test(listed.id)) {
      documents += 2;
      continue;
    }
    const { instances } = await expectDocument(instancesSchema, `${at}/instances`);
    for (const { id } of instances) await expectDocument(collectionSchema, `${at}/instances/${id}`);
    const items = await expectDocument(features, `${at}/items`, "application/geo+json");
    for (const { id } of items.features) await expectDocument(feature, `${at}/items/${id}`, "application/geo+json");
    await expectDocument(features, `${at}/instances/${instances[0].id}/locations`, "application/geo+json");
    documents += 5 + instances.length + items.features.length;
  }
}

const instant = "datetime=2025-03-10T02:30:00Z";
const hours = "datetime=2025-03-10T02:00:00Z/2025-03-10T06:00:00Z";
const line = "LINESTRING(2.41 57.21,2.43 57.22,2.45 57.23)";
const area = "POLYGON((2.39 57.19,2.47 57.19,2.47 57.25,2.39 57.19))";
/** Queries of each type, and the domain that they are to have. @param z  of a collection with a vertical: "&z=..." else "" */
const queries = (one, many) => [
  ["Point", `/position?coords=POINT(2.41 57.21)&${instant}${one}`],
  ["PointSeries", `/position?coords=POINT(2.41 57.21)&${hours}${one}`],
  [many ? "VerticalProfile" : "Point", `/position?coords=POINT(2.41 57.21)&${instant}${many}`],
  [many ? "Grid" : "PointSeries", `/position?coords=POINT(2.41 57.21)&${hours}${many}`],
  ["Point", `/position?coords=MULTIPOINT((2.41 57.21),(2.43 57.22))&${instant}${one}`],
  ["Grid", `/radius?coords=POINT(2.43 57.22)&within=3&within-units=km&${hours}${many}`],
  ["Grid", `/area?coords=${area}&${instant}${one}`],
  ["Grid", `/area?coords=${area}&resolution-x=7&resolution-y=5&${instant}${many}`],
  ["Grid", `/cube?bbox=2.39,57.19,2.47,57.25&${hours}${many || "&z=0"}`],
  ["Grid", `/cube?bbox=179.9,-17.1,-179.9,-16.9&${instant}${one || "&z=0"}`],
  ["Trajectory", `/trajectory?coords=${line}&${instant}${one}`],
  ["Trajectory", `/trajectory?coords=LINESTRINGM(2.41 57.21 1741572000,2.45 57.23 1741577400)${one}`],
  ["Trajectory", `/corridor?coords=${line}&corridor-width=1&width-units=km&corridor-height=4&height-units=m&${instant}${one}`],
  ["PointSeries", `/locations/farm.5?${hours}${one}`],
];

let answers = 0;
let numbers = 0;
async function expectReadable(path, document, domainType) {
  const read = await CovJSON.read(document);
  for (const coverage of read.type === "CoverageCollection" ? read.coverages : [read]) {
    const domain = await coverage.loadDomain();
    assert(domain.domainType.endsWith(`#${domainType}`), `${path}: ${domain.domainType}`);
    for (const [name, range] of await coverage.loadRanges()) {
      assert(coverage.parameters.get(name).observedProperty.id.includes("vocab.nerc.ac.uk"), name);
      const first = Object.fromEntries([...range.shape.keys()].map((axis) => [axis, 0]));
      const value = range.get(first);
      assert(value === null || Number.isFinite(value), `${path} ${name}: ${value}`);
      numbers += [...range.shape.values()].reduce((all, length) => all * length, 1);
    }
  }
}

async function checkData() {
  const kinds = { currents: ["&z=5", "&z=0/20"], "currents-members": ["&z=5", "&z=0/20"], wind: ["&z=80", "&z=10/100"],
                  "wind-members": ["&z=80", "&z=10/100"], waves: ["", ""], "sea-level": ["", ""] };
  for (const [collection, [one, many]] of Object.entries(kinds)) {
    for (const at of [`/collections/${collection}`, `/collections/${collection}/instances/farm_20250310T050000Z`]) {
      for (const [domainType, query] of queries(one, many)) {
        // The grid across the antimeridian is another site's.
        if (query.includes("179.9") && at.includes("instances")) continue;
        const path = at + query;
        const document = await get(path, "application/prs.coverage+json");
        expectValid(covjson, path, document);
        expectValid(edrCovjson, path, document);
        await expectReadable(path, document, domainType);
        expectValid(features, path, await get(`${path}&f=GeoJSON`, "application/geo+json"));
        ++answers;
      }
    }
  }
}

async function expectAnswer(path, domainType) {
  const document = await get(path, "application/prs.coverage+json");
  expectValid(covjson, path, document);
  expectValid(edrCovjson, path, document);
  await expectReadable(path, document, domainType);
  expectValid(features, path, await get(`${path}&f=GeoJSON`, "application/geo+json"));
  ++answers;
}

const mooring = "instrument-currents-M1";

/** Stored products and a mooring: each with the queries that it takes, at times of their own. */
async function checkProducts() {
  const own = "datetime=2025-03-10T02:00:00Z";
  const kinds = { "product-currents-NWSHELF_ANALYSISFORECAST_PHY_004_013": ["&z=5", "&z=0/20"],
                  "product-wind-WIND_GLO_PHY_L4_NRT_012_004": ["&z=10", ""] };
  const { collections } = await get("/collections");
  const listed = collections.map(({ id }) => id).filter((id) => id.startsWith("product-"));
  assert.equal(listed.length, 3, listed);
  for (const id of Object.keys(kinds)) assert(listed.includes(id), id);
  for (const id of listed) {
    const [one, many] = kinds[id] ?? ["", ""];
    for (const [domainType, query] of [
      ["Point", `/position?coords=POINT(2.41 57.21)&${own}${one}`],
      ["PointSeries", `/position?coords=POINT(2.41 57.21)&${hours}${one}`],
      [many ? "VerticalProfile" : "Point", `/position?coords=POINT(2.41 57.21)&${own}${many}`],
      ["Point", `/position?coords=MULTIPOINT((2.41 57.21),(2.43 57.22))&${own}${one}`],
      ["Grid", `/radius?coords=POINT(2.43 57.22)&within=8&within-units=km&${hours}${many}`],
      ["Grid", `/area?coords=${area}&${own}${one}`],
      ["Grid", `/cube?bbox=2.39,57.19,2.47,57.27&${hours}${many || one || "&z=0"}`],
      ["PointSeries", `/locations/farm.5?${hours}${one}`],
    ]) await expectAnswer(`/collections/${id}${query}`, domainType);
  }
  // What was measured stands at one place, whatever holds it.
  for (const [domainType, query] of [
    ["Point", `/position?coords=POINT(2.41 57.21)&${own}&z=5`],
    ["PointSeries", `/locations/M1?${hours}&z=5`],
    ["VerticalProfile", `/area?coords=${area}&${own}`],
    ["Grid", `/cube?bbox=2.39,57.19,2.47,57.27&${hours}&z=0/20`],
  ]) await expectAnswer(`/collections/${mooring}${query}`, domainType);
  return [...listed, mooring];
}

async function checkClient(products) {
  const file = require.resolve("@camptocamp/ogc-client");
  const { OgcApiEndpoint } = await import(pathToFileURL(file));
  const endpoint = new OgcApiEndpoint(base);
  assert.equal((await endpoint.info).title, "Slackwater");
  const classes = await endpoint.conformanceClasses;
  assert(classes.includes("http://www.opengis.net/spec/ogcapi-edr-1/1.1/conf/core"), classes);
  const names = (await endpoint.allCollections).map(({ name }) => name).sort();
  const forecasts = ["currents", "currents-members", "sea-level", "waves", "wind", "wind-members"];
  assert.deepEqual(names, [...forecasts, ...products].sort());
  const waves = await endpoint.getCollectionInfo("waves");
  assert.equal(waves.id ?? waves.name, "waves");
  return names.length;
}

await checkMetadata();
await checkData();
const found = await checkClient(await checkProducts());
console.log(`ajv accepts ${documents} documents and ${2 * answers} answers; covjson-reader read ${numbers} values of ${answers}; ` +
            `ogc-client discovers ${found} collections`);
