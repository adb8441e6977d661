// Elements made and changed by code: no text is ever read as HTML.

type Attributes = Record<string, string | number | boolean>;
type Child = Node | string;

export function element<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  attributes: Attributes = {},
  ...children: Child[]
): HTMLElementTagNameMap[K] {
  const made = document.createElement(tag);
  set_attributes(made, attributes);
  made.append(...children);
  return made;
}

/** The same for a drawing. */
export function drawn<K extends keyof SVGElementTagNameMap>(
  tag: K,
  attributes: Attributes = {},
  ...children: Child[]
): SVGElementTagNameMap[K] {
  const made = document.createElementNS('http://www.w3.org/2000/svg', tag);
  set_attributes(made, attributes);
  made.append(...children);
  return made;
}

function set_attributes(made: Element, attributes: Attributes): void {
  for (const [name, value] of Object.entries(attributes)) {
    if (value === false) continue;
    made.setAttribute(name, value === true ? '' : String(value));
  }
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

/** Choices of which one holds, as buttons that are pressed or not. */
export function choice<V extends string>(
  name: string,
  choices: readonly (readonly [V, string])[],
  on_choose: (value: V) => void,
): { node: HTMLElement; show: (value: V) => void } {
  const buttons = choices.map(([value, text]) => button(text, () => on_choose(value)));
  const node = element('div', { class: 'choice', role: 'group', 'aria-label': name }, ...buttons);
  const show = (value: V): void =>
    choices.forEach(([of], i) => buttons[i]?.setAttribute('aria-pressed', String(of === value)));
  return { node, show };
}

/** Only touches the page where something differs: the reader's place and focus stay. */
export function set_text(node: Node, text: string): void {
  if (node.textContent !== text) node.textContent = text;
}

export function set_hidden(node: HTMLElement, hidden: boolean): void {
  if (node.hidden !== hidden) node.hidden = hidden;
}

export function set_disabled(node: HTMLButtonElement | HTMLInputElement, disabled: boolean): void {
  if (node.disabled !== disabled) node.disabled = disabled;
}

export function by_id(id: string): HTMLElement {
  const found = document.getElementById(id);
  if (found === null) throw new Error(`The page has no element "${id}".`);
  return found;
}

/** A table or picture that scrolls by itself, by keys too. */
export function scroll_region(name: string, ...inside: Child[]): HTMLElement {
  const attributes = { class: 'scroll', tabindex: 0, role: 'region', 'aria-label': name };
  return element('div', attributes, ...inside);
}
