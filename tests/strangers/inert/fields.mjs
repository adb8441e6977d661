// The fields that a stranger can fill, and what each is filled with: its number is in the text. With marks for terminals where
// the program takes them; names and words of people may hold none.
import { brief, control, line, named, short, shortest } from "./payloads.mjs";

const by_kind = new Map([
  [named, ["file name", "AIS file"]],
  [
    control,
    [
      ...["file title", "file institution", "file source", "file history", "file comment", "file credit", "file references"],
      ...["file dataset_id", "variable long_name", "variable units", "variable comment"],
      ...["product id", "product title", "product attribution"],
      ...["platform name", "platform institution", "platform title"],
      ...["site name", "turbine", "cable", "mooring", "area", "area reason", "datum source"],
      ...["task name", "task category", "task sensor", "task role", "surface name"],
      ...["limit source", "limit status", "risk source"],
      ...["vehicle sheet name", "access vessel"],
      ...["scenario name", "scenario vehicle", "structure", "mission name"],
      ...["plan name", "plan vessel", "plan crew", "plan skill", "plan vehicle", "plan port"],
    ],
  ],
  [short, ["datum name", "person", "operator"]],
  [shortest, ["made-up vessel", "AIS vessel", "AIS call sign", "AIS destination"]],
  [line, ["decision note", "hand-over"]],
  [brief, ["decided by", "session words", "session note", "take-back reason", "newcomer"]],
]);

const texts = new Map();
for (const [payload, names] of by_kind) for (const name of names) texts.set(name, payload(texts.size + 1));

export const fields = [...texts.keys()];
export function text_of(field) {
  const text = texts.get(field);
  if (text === undefined) throw new Error(`no field ${field}`);
  return text;
}
