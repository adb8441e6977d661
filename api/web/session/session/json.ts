// JSON of somebody else, read with suspicion: what is of another kind is nothing.

export type Json = Record<string, unknown>;

export function as_object(value: unknown): Json | null {
  return typeof value === 'object' && value !== null && !Array.isArray(value)
    ? (value as Json)
    : null;
}
export function as_list(value: unknown): unknown[] {
  return Array.isArray(value) ? value : [];
}
export function as_number(value: unknown): number | null {
  return typeof value === 'number' && Number.isFinite(value) ? value : null;
}
export function as_text(value: unknown): string {
  if (typeof value === 'string') return value;
  return typeof value === 'number' || typeof value === 'boolean' ? String(value) : '';
}
