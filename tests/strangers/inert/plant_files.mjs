// plant_files.mjs PRODUCTS WORK: product files whose every free text is planted, by ncdump and ncgen from those of PRODUCTS
// (`slackwater demo`): currents with a descriptor of their own, waves of an unnamed product, a platform's series.
import { execFileSync } from "node:child_process";
import { mkdirSync, readdirSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { text_of } from "./fields.mjs";
import { cdl, yaml } from "./payloads.mjs";

const [products, work] = process.argv.slice(2);
const GLOBALS = { title: "file title", institution: "file institution", source: "file source", references: "file references" };
const MORE = { history: "file history", comment: "file comment", acknowledgement: "file credit" };

const write_netcdf = (file, text) => {
  const cdl_file = join(work, "text.cdl");
  writeFileSync(cdl_file, text);
  execFileSync("ncgen", ["-4", "-o", file, cdl_file]);
};

/** A file's CDL with other texts in it. */
function planted(file, more) {
  let text = execFileSync("ncdump", ["-p", "5", file], { encoding: "utf8", maxBuffer: 1 << 28 });
  text = text.replace(/^\t\t:(?:title|institution|source|references|credit|dataset_id) = .*\n/gmu, "");
  text = text.replace(/:long_name = ".*" ;/gu, () => `:long_name = ${cdl(text_of("variable long_name"))} ;`);
  const globals = Object.entries({ ...GLOBALS, ...more }).map(([name, key]) => `\t\t:${name} = ${cdl(text_of(key))} ;\n`);
  return text.replace("// global attributes:\n", () => `// global attributes:\n${globals.join("")}`);
}

for (const folder of ["currents", "others"]) mkdirSync(join(work, folder), { recursive: true });
const of = (kind) => readdirSync(products).filter((name) => name.includes(kind) && !name.includes("_fc"));
for (const name of of("phy-cur"))
  write_netcdf(join(work, "currents", name), planted(join(products, name), { ...MORE, dataset_id: "file dataset_id" }));
writeFileSync(
  join(work, "product.yaml"),
  [
    `id: ${yaml(text_of("product id"))}`,
    `title: ${yaml(text_of("product title"))}`,
    `attribution: ${yaml(text_of("product attribution"))}`,
    "regional: true",
    "tide: true",
    "",
  ].join("\n"),
);
const waves = of("nws_wav").at(-1);
write_netcdf(
  join(work, "others", `${text_of("file name")}.nc`),
  planted(join(products, waves), { ...MORE, dataset_id: "file dataset_id" }),
);

const HOURS = 24;
const hours = [...Array(HOURS).keys()];
/** Significant wave heights that a platform measured; its name and whom to credit as a file may say it. */
const platform = (file, units, more) =>
  write_netcdf(
    join(work, file),
    `netcdf platform {
dimensions: time = ${HOURS} ;
variables:
  double time(time) ; time:standard_name = "time" ; time:units = "hours since 2025-03-08T00:00:00Z" ;
  double lat ; lat:standard_name = "latitude" ; lat:units = "degrees_north" ;
  double lon ; lon:standard_name = "longitude" ; lon:units = "degrees_east" ;
  float hs(time) ; hs:standard_name = "sea_surface_wave_significant_height" ; hs:units = ${units} ;
    hs:long_name = ${cdl(text_of("variable long_name"))} ; hs:comment = ${cdl(text_of("variable comment"))} ;
  :Conventions = "CF-1.8" ; :featureType = "timeSeries" ;
  ${more}
data:
  time = ${hours.join(", ")} ;
  lat = 48.86 ; lon = -2.55 ;
  hs = ${hours.map((i) => (1 + 0.3 * Math.sin(i)).toFixed(3)).join(", ")} ;
}
`,
  );
const says = (attribute, field) => `:${attribute} = ${cdl(text_of(field))} ;`;
platform("others/platform.nc", '"m"', says("platform_code", "platform name") + says("institution", "platform institution"));
platform("others/other.nc", '"m"', `:platform_code = "other" ; ${says("title", "platform title")}`);
platform("refused.nc", cdl(text_of("variable units")), says("platform_code", "platform name"));
