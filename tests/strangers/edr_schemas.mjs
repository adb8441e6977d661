// The JSON schemas of CoverageJSON and of EDR 1.1 as functions that validate. `require` finds ajv, ajv-formats and yaml.
import { readFileSync, readdirSync } from "node:fs";
import { dirname, join, relative } from "node:path";

/** The schema of CoverageJSON objects. */
export function coverageJsonSchema(require, standards) {
  const Ajv = require("ajv/dist/2020").default;
  const ajv = new Ajv({ strict: false, allErrors: true });
  const folder = join(standards, "coveragejson");
  for (const file of readdirSync(folder)) ajv.addSchema(JSON.parse(readFileSync(join(folder, file), "utf8")));
  return ajv.getSchema("/schemas/coveragejson");
}

/** A schema of the OpenAPI blocks, with those that it refers to; each is known by its path below the blocks. */
export function edrSchema(require, standards, path) {
  const Ajv = require("ajv/dist/2020").default;
  const addFormats = require("ajv-formats").default;
  const YAML = require("yaml");
  const ajv = new Ajv({ strict: false, allErrors: true });
  addFormats(ajv);
  const folder = join(standards, "ogcapi-edr-1.1");
  const seen = new Set();
  const add = (file) => {
    const id = "/" + relative(folder, file);
    if (seen.has(id)) return id;
    seen.add(id);
    const schema = YAML.parse(readFileSync(file, "utf8"));
    delete schema.example;
    const visit = (node) => {
      if (node === null || typeof node !== "object") return;
      if (typeof node.$ref === "string" && !node.$ref.startsWith("#")) node.$ref = add(join(dirname(file), node.$ref));
      // OpenAPI 3.0 says so what JSON Schema says by a second type.
      if (node.nullable === true && typeof node.type === "string") node.type = [node.type, "null"];
      delete node.nullable;
      // The alternatives of schemas/covjson, as published with EDR 1.1, exclude each other or CoverageJSON's own forms (a
      // geographic reference system, numbers with a shape): opengeospatial/ogcapi-environmental-data-retrieval#494.
      if (id.startsWith("/schemas/covjson/")) delete node.oneOf;
      Object.values(node).forEach(visit);
    };
    visit(schema);
    ajv.addSchema({ $id: id, ...schema });
    return id;
  };
  return ajv.getSchema(add(join(folder, path)));
}
