// A live session with people who write what they like: a supervisor at the page /session, others by plain sockets; a mission's
// session, which has a farm; and the record of the first, watched again.
import { text_of } from "./fields.mjs";
import { LIMIT_MS, sleep } from "./look.mjs";

const SUE = "sue-0123456789abcdef";
const MAX = "max-0123456789abcdef";
const ANN = "ann-0123456789abcdef";

/** Runs in the page, of whose origin the socket is: takes a seat, asks all, and keeps the seat; tells what was refused. */
async function take_part(session, token, name, asks) {
  const socket = new WebSocket(`ws://${location.host}/sessions/${session}/socket`, ["slackwater.session.v1", `bearer.${token}`]);
  const refused = [];
  let answered = () => {};
  socket.onmessage = ({ data }) => {
    if (typeof data !== "string") return;
    const told = JSON.parse(data);
    if (told.is === "answer" && !told.taken && told.id > 0) refused.push(`${told.id}: ${told.reason}, ${told.text}`);
    if (told.is === "welcome" || (told.is === "answer" && told.id > 0)) answered(told);
  };
  await new Promise((done) => (socket.onopen = done));
  const say = (message) => {
    const answer = new Promise((done) => (answered = done));
    socket.send(JSON.stringify(message));
    return answer;
  };
  await say({ do: "hello", id: 0, name });
  for (const [i, ask] of asks.entries()) await say({ id: i + 1, ...ask });
  window.kept = [...(window.kept ?? []), socket];
  return refused;
}

const seated = (page) =>
  page.waitForFunction(() => document.documentElement.dataset.link === "seated", { timeout: LIMIT_MS, polling: 100 });
const shows = (page, text) =>
  page.waitForFunction((text) => document.body.textContent.includes(text), { timeout: LIMIT_MS, polling: 100 }, text);

async function join(page, token) {
  await page.waitForSelector("form.join option", { timeout: LIMIT_MS });
  await page.type("form.join input[type=text]", "Sue");
  await page.type("form.join input[type=password]", token);
  await page.click("form.join button[type=submit]");
  await seated(page);
}

/** Opens what is folded away, and the scene in place of the plan. */
async function open_all(page) {
  await page.$$eval("details", (all) => all.forEach((it) => (it.open = true)));
  await page.$$eval("button", (all) => all.find((it) => it.textContent === "Scene")?.click());
  await sleep(1000); // of drawing
}

export async function look_at_sessions(looker, address) {
  let page = await looker.open("session", `${address}/session?session=run`);
  await join(page, SUE);
  const at = { east_m: 5, north_m: 5, up_m: -5 };
  const vehicle = 0;
  const start = { east_m: 0, north_m: -20, up_m: -8, heading_deg: 0 };
  const operator = [
    { do: "say", text: text_of("session words") },
    { do: "note", text: text_of("session note"), at },
    { do: "ask", vehicle },
  ];
  const supervisor = [
    { do: "take_back", vehicle, reason: text_of("take-back reason") },
    { do: "spawn", model: "planted_rov", name: text_of("newcomer"), ...start },
  ];
  for (const [token, asks] of [[ANN, operator], [MAX, supervisor]]) {
    const refused = await page.evaluate(take_part, "run", token, text_of("operator"), asks);
    for (const one of refused) looker.faults.push(`session: refused: ${one}`);
  }
  for (const field of ["session words", "take-back reason", "newcomer"]) await shows(page, text_of(field));
  await open_all(page);
  await looker.look("session", page);
  await page.browserContext().close();

  page = await looker.open("session of a farm", `${address}/session?session=farm`);
  await join(page, SUE);
  await open_all(page);
  await looker.look("session of a farm", page);
  await page.browserContext().close();
}

export async function look_at_recording(looker, address) {
  const page = await looker.open("recording", `${address}/session`);
  await page.waitForSelector(".log li button", { timeout: LIMIT_MS });
  await page.click(".log li:last-child button");
  await shows(page, text_of("take-back reason"));
  await open_all(page);
  await looker.look("recording", page);
  await page.browserContext().close();
}
