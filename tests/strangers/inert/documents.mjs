// The documents of the server for people: all that its list of links leads to, one of each kind.
const DEEPEST = 4; // links from the first page
const MOST = 60;
/** Those that are made by the same code as those of `currents`. */
const ALIKE = /\/collections\/(?:currents-members|wind|wind-members|waves|sea-level)(?:\/|\?|$)|synthetic/u;

export async function look_at_documents(looker, address) {
  const first = [
    `${address}/?f=html`,
    `${address}/api?f=html`,
    `${address}/sites/planted/report.html`,
    `${address}/session/hands`,
  ];
  const known = new Set([...first, `${address}/`]); // the desk is looked at by itself
  const left = first.map((url) => [url, 0]);
  const page = await looker.open("documents", "about:blank", address);
  while (left.length > 0 && known.size <= MOST) {
    const [url, deep] = left.shift();
    await page.goto(url);
    await looker.look(url.slice(address.length), page);
    if (deep === DEEPEST) continue;
    for (const link of await page.$$eval("a[href]", (all) => all.map((it) => it.href.replace(/#.*/u, "")))) {
      if (!link.startsWith(address) || known.has(link) || ALIKE.test(link)) continue;
      known.add(link);
      if (await is_page(link)) left.push([link, deep + 1]);
    }
  }
  await page.browserContext().close();
  return known.size;
}

async function is_page(url) {
  const { headers, body } = await fetch(url, { headers: { Accept: "text/html" } });
  await body?.cancel();
  return headers.get("Content-Type")?.startsWith("text/html");
}
