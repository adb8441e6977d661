// Education mode, by the page's address: `?class` shows lessons, `?kiosk` goes back to the
// beginning when nobody has touched anything for a while.
export interface ClassMode {
  has_lessons: boolean;
  resets: boolean;
}

export function class_of_address(search: string): ClassMode {
  const asked = new URLSearchParams(search);
  const resets = asked.has('kiosk');
  return { has_lessons: resets || asked.has('class'), resets };
}
