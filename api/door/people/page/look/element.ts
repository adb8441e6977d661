// Elements made and changed by code: no text is ever read as HTML.

type Attributes = Record<string, string | number | boolean>;
type Child = Node | string;

export function element<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  attributes: Attributes = {},
  ...children: Child[]
): HTMLElementTagNameMap[K] {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (value === false) continue;
    made.setAttribute(name, value === true ? '' : String(value));
  }
  made.append(...children);
  return made;
}

export function button(
  text: string,
  on_press: () => void,
  attributes: Attributes = {},
): HTMLButtonElement {
  const made = element('button', { type: 'button', ...attributes }, text);
  made.addEventListener('click', on_press);
  return made;
}

/** A list or table that scrolls by itself, by keys too; the keys of the stick go on driving. */
export function scroll_region(name: string, inside: Node): HTMLElement {
  return element(
    'div',
    { class: 'scroll', tabindex: 0, 'data-drives': true, role: 'region', 'aria-label': name },
    inside,
  );
}

let labels = 0;
/** A field with its label above it. */
export function labelled<T extends HTMLElement>(text: string, field: T, hint = ''): HTMLElement {
  labels += 1;
  field.id ||= `field-${labels}`;
  const made = element('div', { class: 'field' }, element('label', { for: field.id }, text), field);
  if (hint !== '') {
    const note = element('p', { class: 'note', id: `${field.id}-note` }, hint);
    field.setAttribute('aria-describedby', note.id);
    made.append(note);
  }
  return made;
}

/** Only touches the page where something differs: the reader's place and focus stay. */
export function set_text(node: Node, text: string): void {
  if (node.textContent !== text) node.textContent = text;
}

export function set_hidden(node: HTMLElement, hidden: boolean): void {
  if (node.hidden !== hidden) node.hidden = hidden;
}

export function set_disabled(node: HTMLButtonElement, disabled: boolean): void {
  if (node.disabled !== disabled) node.disabled = disabled;
}

export function by_id(id: string): HTMLElement {
  const found = document.getElementById(id);
  if (found === null) throw new Error(`The page has no element "${id}".`);
  return found;
}

/** Sizes a canvas to its box and hands back a context whose unit is the CSS pixel. */
export function ready_canvas(
  canvas: HTMLCanvasElement,
): { context: CanvasRenderingContext2D; width: number; height: number } | null {
  const width = canvas.clientWidth;
  const height = canvas.clientHeight;
  const context = canvas.getContext('2d');
  if (context === null || width < 2 || height < 2) return null;
  const ratio = devicePixelRatio || 1;
  const wide = Math.round(width * ratio);
  const high = Math.round(height * ratio);
  if (canvas.width !== wide || canvas.height !== high) {
    canvas.width = wide;
    canvas.height = high;
  }
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  context.clearRect(0, 0, width, height);
  return { context, width, height };
}
