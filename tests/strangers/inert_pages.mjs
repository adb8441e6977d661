// inert_pages.mjs MODULES PROGRAM STORE WORK: looks at all that `inert-pages` has left in WORK, and at what PROGRAM serves of STORE,
// as a stranger who planted script there (inert/): nothing of it runs, is asked for or made, and it is shown as the text it is.
import { strict as assert } from "node:assert";
import { readdirSync } from "node:fs";
import { join } from "node:path";
import { Answers, ask_all } from "./inert/answers.mjs";
import { look_at_desk } from "./inert/desk.mjs";
import { look_at_documents } from "./inert/documents.mjs";
import { fields, text_of } from "./inert/fields.mjs";
import { launch, Looker } from "./inert/look.mjs";
import { look_offline } from "./inert/offline.mjs";
import { begin } from "./inert/serve.mjs";
import { look_at_recording, look_at_sessions } from "./inert/session.mjs";
import { Printed } from "./inert/terminal.mjs";

const [modules, program, store, work] = process.argv.slice(2);

/** What no page shows, but answers hold or commands print. */
const NOT_ON_PAGES = [
  ...["file name", "AIS file", "file credit", "platform institution", "platform title"],
  ...["mooring", "limit source", "limit status"],
];
/** What nothing shows: of what a file says of itself one credit is kept, and a descriptor or a task has more than is told. */
const NOWHERE = [
  ...["file title", "file institution", "file source", "file history", "file comment", "file references", "file dataset_id"],
  ...["variable long_name", "variable units", "variable comment", "product title"],
  ...["task category", "task sensor", "risk source", "plan skill", "AIS call sign", "AIS destination"],
];

const began_ms = Date.now();
const timed = async (what, doing) => {
  const from_ms = Date.now();
  const told = await doing;
  console.log(`${what}: ${((Date.now() - from_ms) / 1000).toFixed(1)} s${told ? `, ${told}` : ""}`);
};

const browser = await launch(modules);
const looker = new Looker(browser);
let answers;
let server;
try {
  await timed("pages of commands", look_offline(looker, work));
  const files = ["--ais", join(work, "ais", `${text_of("AIS file")}.csv`), "--sessions", join(work, "sessions.yaml")];
  server = await begin(program, "--store", store, "serve", "--port", "0", "--at", "2025-03-09T06:00:00Z", ...files);
  const { address } = server;
  if ((await (await fetch(`${address}/session/page.js`)).text()) === "") {
    console.log("skipped: the program was built without the pages' scripts");
    process.exitCode = 77;
  } else {
    await timed("sessions", look_at_sessions(looker, address));
    await timed("desk", look_at_desk(looker, address));
    await timed("documents", look_at_documents(looker, address));
    answers = new Answers(address, work);
    await timed("answers", ask_all(answers));
    await server.end();
    const log = readdirSync(join(work, "logs")).find((name) => name.startsWith("run-"));
    server = await begin(program, "--store", store, "watch", join(work, "logs", log), "--port", "0");
    await timed("recording", look_at_recording(looker, server.address));
  }
} finally {
  await server?.end();
  await browser.close();
}

if (process.exitCode !== 77) {
  const printed = new Printed(join(work, "said"));
  const missing = [];
  for (const field of fields) {
    const [pages, documents, prints] = [looker, answers, printed].map((it) => it.where(text_of(field)));
    console.log(`${field}: ${pages.join(", ") || "on no page"}; in ${documents.length} answers; printed by ${prints.length}`);
    const is_there = pages.length > 0 || (NOT_ON_PAGES.includes(field) && documents.length + prints.length > 0);
    if (!is_there && !NOWHERE.includes(field)) missing.push(field);
  }
  assert.deepEqual([...looker.faults, ...answers.faults, ...printed.faults], []);
  assert.deepEqual(missing, [], "these are planted and shown nowhere: the pages were not looked at");
  console.log(`all in ${((Date.now() - began_ms) / 1000).toFixed(0)} s`);
}
