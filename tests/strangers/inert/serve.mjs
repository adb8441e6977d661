// A program of ours that serves: begun, until it tells its address, and ended.
import { spawn } from "node:child_process";
import { LIMIT_MS, sleep } from "./look.mjs";

export async function begin(program, ...args) {
  const server = spawn(program, args);
  let said = "";
  for (const stream of [server.stdout, server.stderr]) stream.on("data", (data) => (said += data));
  for (let waited_ms = 0; waited_ms < LIMIT_MS && server.exitCode === null; waited_ms += 50) {
    const address = /http:\/\/127\.0\.0\.1:\d+/u.exec(said)?.[0];
    if (address && (await fetch(`${address}/sessions`).catch(() => null))) {
      const end = async () => {
        server.kill("SIGTERM");
        while (server.exitCode === null && server.signalCode === null) await sleep(20);
        return said;
      };
      return { address, end, said: () => said };
    }
    await sleep(50);
  }
  server.kill("SIGKILL");
  throw new Error(`it does not serve: ${said}`);
}
