// What commands printed: UTF-8, and nothing in it that a terminal obeys. Our own words hold none of these characters.
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { read } from "./payloads.mjs";

/** Control characters but ends of lines and tabs, and those that turn the direction of writing. */
const STEERS = /[\u0000-\u0008\u000b-\u001f\u007f-\u009f\u061c\u200e\u200f\u2028-\u202e\u2066-\u2069]/u;

export class Printed {
  faults = [];
  #said = new Map();

  constructor(folder) {
    for (const name of readdirSync(folder)) {
      try {
        this.#note(name, new TextDecoder("utf-8", { fatal: true }).decode(readFileSync(join(folder, name))));
      } catch {
        this.faults.push(`${name}: not UTF-8`);
      }
    }
  }

  #note(name, said) {
    const at = said.search(STEERS);
    if (at >= 0)
      this.faults.push(
        `${name}: U+${said.codePointAt(at).toString(16)} after ${JSON.stringify(said.slice(Math.max(0, at - 60), at))}`,
      );
    this.#said.set(
      name,
      read(said.replace(/\\u([0-9a-f]{4})/gu, (_, code) => String.fromCodePoint(parseInt(code, 16))).replaceAll('\\"', '"')),
    );
  }

  /** What printed a text, its characters of control as they are written. */
  where(text) {
    return [...this.#said].filter(([, said]) => said.includes(read(text))).map(([name]) => name);
  }
}
