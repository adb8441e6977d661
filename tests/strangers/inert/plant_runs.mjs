// plant_runs.mjs DATA WORK: sheets of a vehicle and a vessel (in DATA), a scenario, a mission and people (in WORK) whose every free
// text is planted.
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { text_of } from "./fields.mjs";
import { yaml } from "./payloads.mjs";

const [data, work] = process.argv.slice(2);
const t = (key) => yaml(text_of(key));
const write = (name, text) => writeFileSync(join(work, name), text, { mode: 0o600 }); // tokens are in some
const renamed = (kind, id, to, key) => {
  const sheet = readFileSync(join(data, kind, `${id}.yaml`), "utf8").replace(/^id: .*$/mu, `id: ${to}`);
  writeFileSync(
    join(data, kind, `${to}.yaml`),
    sheet.replace(/^name: .*$/mu, () => `name: ${t(key)}`),
  );
};

renamed("vehicles", "bluerov2_heavy", "planted_rov", "vehicle sheet name");
renamed("vessels", "crew_transfer_vessel", "planted_vessel", "access vessel");

const MADE_UP =
  "{made_up: {depth_m: 35, current: [{depth_m: 0, east_m_s: 0.2, north_m_s: 0}], wind: {speed_m_s: 4, from_deg: 270}}}";
write(
  "scenario.yaml",
  `name: ${t("scenario name")}
seed: 7
start: 2025-03-10T06:00:00Z
duration: 60min
step_s: 0.05
log_every_s: 0.5
origin: {latitude_deg: 48.85, longitude_deg: -2.55}
water: ${MADE_UP}
traffic:
  vessels: [{mmsi: 200000010, name: ${t("made-up vessel")}, speed_m_s: 5, waypoints: [{north_m: 300, east_m: -200}, {north_m: -300, east_m: -180}]}]
  alarm: {cpa_m: 400, tcpa_min: 6}
structures:
  - {name: ${t("structure")}, kind: cylinder, north_m: 0, east_m: 20, diameter_m: 6, top_height_m: 10, bottom_depth_m: 35}
vehicles:
  - name: ${t("scenario vehicle")}
    model: planted_rov
    start: {north_m: 0, east_m: 0, depth_m: 10}
    tasks: [{do: hold}]
`,
);
write("brief.yaml", readFileSync(join(work, "scenario.yaml"), "utf8").replace("duration: 60min", "duration: 1min"));
write(
  "mission.yaml",
  `name: ${t("mission name")}
seed: 3
site: planted
tasks: [planted_task]
turbines: [${t("turbine")}]
start: 2025-03-10T06:00:00Z
duration: 10min
step_s: 0.05
water: ${MADE_UP}
waves: {components: 8, partitions: [{significant_height_m: 0.4, peak_period_s: 5, from_deg: 270}]}
`,
);
const UNTIL = "until: 2100-01-01T00:00:00Z";
const people = `people:
  - {name: ${t("person")}, role: supervisor, token: sue-0123456789abcdef, ${UNTIL}}
  - {role: supervisor, token: max-0123456789abcdef, ${UNTIL}, seats: 4}
  - {role: operator, token: ann-0123456789abcdef, ${UNTIL}, seats: 4}
`;
const sessions = ["{id: run, scenario: scenario.yaml, begins: at_start}", "{id: farm, mission: mission.yaml, begins: at_start}"];
write("sessions.yaml", `sessions:\n  - ${sessions.join("\n  - ")}\nlogs: logs\n${people}`);
mkdirSync(join(work, "logs"), { recursive: true });
