// A YAML text with values exchanged in place: every comment and space of it stays.
import { isMap, isScalar, isSeq, parseDocument, type Node } from 'yaml';

export type Path = readonly (string | number)[];

export function value_in(text: string, path: Path): unknown {
  const doc = parseDocument(text);
  const node = path.length === 0 ? doc.contents : doc.getIn(path, true);
  return isScalar(node) ? node.value : isMap(node) || isSeq(node) ? node.toJS(doc) : undefined;
}

/** Where the characters of a node stand in the text. */
function place_of(text: string, path: Path): readonly [number, number] | null {
  const node = parseDocument(text).getIn(path, true) as Node | undefined;
  return node?.range ? [node.range[0], node.range[1]] : null;
}

/** Sets a plain value. A key that is not there yet is added, and the text written anew for it. */
export function with_value(text: string, path: Path, value: string | number): string {
  const place = place_of(text, path);
  if (place !== null) return text.slice(0, place[0]) + String(value) + text.slice(place[1]);
  const doc = parseDocument(text);
  doc.setIn(path, value);
  return doc.toString({ lineWidth: 0, flowCollectionPadding: false });
}

/** Adds an entry to a list, which is made where there is none; the text is written anew for it. */
export function with_added(text: string, list: Path, entry: unknown): string {
  const doc = parseDocument(text);
  const node = doc.createNode(entry, { flow: true });
  const found = doc.getIn(list, true);
  if (isSeq(found)) found.add(node);
  else doc.setIn(list, doc.createNode([node]));
  return doc.toString({ lineWidth: 0, flowCollectionPadding: false });
}

/** Exchanges two entries of a list. */
export function with_exchanged(text: string, list: Path, a: number, b: number): string {
  const first = place_of(text, [...list, Math.min(a, b)]);
  const second = place_of(text, [...list, Math.max(a, b)]);
  if (first === null || second === null || a === b) return text;
  return (
    text.slice(0, first[0]) +
    text.slice(second[0], second[1]) +
    text.slice(first[1], second[0]) +
    text.slice(first[0], first[1]) +
    text.slice(second[1])
  );
}
