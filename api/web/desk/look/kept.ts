// The looks that a person chose, remembered in this browser; a link says them too, and wins.
import { KEPT, first_view, hash_of, read_hash, type Kept, type ViewValues } from '../view';

const KEY = 'slackwater.desk';

export function kept_looks(): Partial<Kept> {
  const otherwise = first_view(
    matchMedia('(prefers-color-scheme: dark)').matches ? { palette: 'dusk' } : {},
  );
  try {
    const read = read_hash(localStorage.getItem(KEY) ?? '', otherwise);
    return Object.fromEntries(KEPT.map((key) => [key, read[key]]));
  } catch {
    return otherwise; // a browser may forbid storage; the page works without
  }
}

export function keep_looks(values: ViewValues): void {
  try {
    const looks = Object.fromEntries(KEPT.map((key) => [key, values[key]]));
    localStorage.setItem(KEY, hash_of(first_view(looks as Partial<Kept>)));
  } catch {
    // not remembered, then
  }
}
