// plant_site.mjs DATA WORK STORE: a site of the store whose every free text is planted, with its task (in DATA), its plan, and the
// AIS about it (in WORK).
import { mkdirSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { text_of } from "./fields.mjs";
import { yaml } from "./payloads.mjs";

const [data, work, store] = process.argv.slice(2);
const t = (key) => yaml(text_of(key));
const write = (file, text) => writeFileSync(file, text);

// A look at a pile of some minutes, as in tests/strangers/morning-report.
write(
  join(data, "tasks", "planted_task.yaml"),
  `id: planted_task
name: ${t("task name")}
category: ${t("task category")}
autonomy: [auto]
sensors: [${t("task sensor")}]
demonstrated: true
duration_h: {value: 0.2, per: foundation}
min_window_h: 0.3
agents:
  - role: ${t("task role")}
    kinds: [rov]
    needs: [camera]
    model: planted_rov
    speed_m_s: 0.4
    start: {distance_m: 12, depth_m: 3}
    launch_s: 20
    recovery_s: 20
    conduct:
      limits:
        - {significant_wave_height_m: 2.5, source: ${t("limit source")}, status: ${t("limit status")}}
        - {wind_speed_10m_m_s: 12, source: ${t("limit source")}, status: ${t("limit status")}}
    inspection:
      surfaces: [{kind: monopile, name: ${t("surface name")}, from: {depth_m: 2}, to: {depth_m: 8}, patch_m: 1}]
      looks: [{instrument: rov_camera, kinds: [monopile], detail_mm: 300, incidence_deg: 80, seen_at: 0.01}]
      water: {visibility_m: 5}
      defects: [{kind: corrosion, count: 2}]
      detection: [rgb_corrosion]
    work: [{pattern: verticals, stand_off_m: 3, from: {depth_m: 4}, to: {depth_m: 6}, bearings: 2}]
risks: [{cause: work, people: 1, environment: 1, asset: 1, schedule: 2, cost: 2, source: ${t("risk source")}, status: estimate}]
`,
);

mkdirSync(join(store, "sites"), { recursive: true });
mkdirSync(join(store, "plans"), { recursive: true });
mkdirSync(join(work, "ais"), { recursive: true });
const LAT = 48.85;
const LON = -2.55;
const at = (north, east) => `latitude_deg: ${LAT + north}, longitude_deg: ${LON + east}`;
write(
  join(store, "sites", "planted.yaml"),
  `id: planted
name: ${t("site name")}
latitude_deg: ${LAT}
longitude_deg: ${LON}
water_depth_m: 35
hub_height_m: 90
rotor_diameter_m: 126
landing_deg: 180
currents: ${t("product id")}
chart_datum: {name: ${t("datum name")}, below_mean_sea_level_m: 5, source: ${t("datum source")}}
foundation: {kind: monopile, diameter_m: 6, top_height_m: 20}
turbines:
  - {id: ${t("turbine")}, ${at(0, 0)}}
  - id: F01
    ${at(0.008, 0.004).replace(", ", "\n    ")}
    foundation: {kind: floating, diameter_m: 12, draught_m: 20, top_height_m: 15}
    moorings: [{id: ${t("mooring")}, bearing_deg: 0, anchor_distance_m: 250, fairlead_depth_m: 14}]
cables:
  - {id: ${t("cable")}, from: ${t("turbine")}, to: F01, via: [{${at(0.004, 0.004)}}], burial_depth_m: 1}
areas:
  - {id: ${t("area")}, kind: exclusion, reason: ${t("area reason")}, polygon: [{${at(-0.008, -0.01)}}, {${at(-0.008, 0.005)}}, {${at(-0.004, 0)}}]}
tasks: [planted_task]
shift: 06:00-18:00
access: {vessel: planted_vessel, passage: 75min}
`,
);
write(
  join(store, "plans", "planted.yaml"),
  `name: ${t("plan name")}
site: planted
vessels:
  - {id: ${t("plan vessel")}, crews: 1, speed_kn: 20, hours: 00:00-24:00, port: {name: ${t("plan port")}, ${at(-0.21, 0.52)}}}
crews:
  - {id: ${t("plan crew")}, skills: [${t("plan skill")}], shift: 00:00-24:00, vessel: ${t("plan vessel")}}
vehicles:
  - {id: ${t("plan vehicle")}, kind: rov, vessel: ${t("plan vessel")}}
tasks:
  - {task: planted_task, turbines: [${t("turbine")}], skills: [${t("plan skill")}]}
`,
);

// Two vessels that pass near, an hour after the forecast's issue; as MarineCadastre writes it.
const cell = (text) => `"${text.replace(/"/gu, '""')}"`;
const HEAD =
  "MMSI,BaseDateTime,LAT,LON,SOG,COG,Heading,VesselName,IMO,CallSign,VesselType,Status,Length,Width,Draft,Cargo,TransceiverClass,Destination";
const row = (minute, lat) =>
  `200000002,2025-03-09T05:${minute}:00,${lat},${LON},10,180,180,${cell(text_of("AIS vessel"))},,` +
  `${cell(text_of("AIS call sign"))},37,,90,18,,,A,${cell(text_of("AIS destination"))}`;
write(join(work, "ais", `${text_of("AIS file")}.csv`), `${[HEAD, row("58", LAT + 0.02), row("59", LAT + 0.0172)].join("\n")}\n`);
