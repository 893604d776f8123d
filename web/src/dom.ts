type Child = Node | string | null | false;
type Attributes = Record<string, string | number | boolean | ((event: Event) => void)>;

/** An element: attributes by name, listeners as `on…`, `false` leaves an attribute out. */
export function h<Tag extends keyof HTMLElementTagNameMap>(
  tag: Tag,
  attributes: Attributes = {},
  ...children: Child[]
): HTMLElementTagNameMap[Tag] {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === 'function') element.addEventListener(name.slice(2), value);
    else if (value !== false) element.setAttribute(name, value === true ? '' : String(value));
  }
  element.append(...children.filter((child): child is Node | string => !!child));
  return element;
}

/** The same of a drawing. */
export function svg(tag: string, attributes: Record<string, string | number> = {}, ...children: (Node | string)[]): SVGElement {
  const element = document.createElementNS('http://www.w3.org/2000/svg', tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, String(value));
  element.append(...children);
  return element;
}

export const byId = <T extends HTMLElement>(id: string): T => document.getElementById(id) as T;

export function button(text: string, press: () => void, attributes: Attributes = {}): HTMLButtonElement {
  return h('button', { type: 'button', onclick: press, ...attributes }, text);
}

/** One that shows a sign instead of its name. */
export const tool = (sign: string, name: string, press: () => void): HTMLButtonElement =>
  button(sign, press, { title: name, 'aria-label': name });

/** Where it differs: else a screen reader would say the same words again. */
export function changeText(element: HTMLElement, text: string): void {
  if (element.textContent !== text) element.textContent = text;
}

/** Fills it again; whoever has the focus in it keeps it, by its place. */
export function refilled(container: HTMLElement, fill: () => void): void {
  const focusable = () => [...container.querySelectorAll<HTMLElement>('button, input, select')];
  const place = focusable().indexOf(document.activeElement as HTMLElement);
  fill();
  if (place >= 0) focusable()[place]?.focus({ preventScroll: true });
}
export function refill(container: HTMLElement, ...children: Node[]): void {
  refilled(container, () => container.replaceChildren(...children));
}

/** A label and what it names. */
export function field(label: string, input: HTMLElement, unit = ''): HTMLElement {
  return h('label', { class: 'field' }, h('span', {}, label), input, unit && h('small', {}, unit));
}

export function numberInput(value: number, step: number, change: (value: number) => void): HTMLInputElement {
  const input = h('input', { type: 'number', value: String(value), step });
  input.addEventListener('change', () => {
    if (Number.isFinite(input.valueAsNumber)) change(input.valueAsNumber);
  });
  return input;
}

export function checkbox(label: string, on: boolean, change: (on: boolean) => void): HTMLLabelElement {
  const input = h('input', { type: 'checkbox', checked: on });
  input.addEventListener('change', () => change(input.checked));
  return h('label', { class: 'check' }, input, label);
}

/** Names as the server has them; "limber:" are those that come with it. */
export function choice(
  names: string[],
  chosen: string,
  change: (name: string) => void,
  none?: string,
  remark: (name: string) => string = () => '',
): HTMLSelectElement {
  const option = (name: string) =>
    h('option', { value: name, selected: name === chosen }, name.replace(/^(limber|given):/, '') + remark(name));
  const own = names.filter((name) => name.startsWith('limber:'));
  const theirs = names.filter((name) => !name.startsWith('limber:'));
  const select = h('select', {}, none !== undefined && h('option', { value: '' }, none));
  if (theirs.length) select.append(h('optgroup', { label: 'This project' }, ...theirs.map(option)));
  if (own.length) select.append(h('optgroup', { label: 'Comes with limber' }, ...own.map(option)));
  select.value = chosen;
  select.addEventListener('change', () => change(select.value));
  return select;
}

/** Rows of name and value. */
export function facts(rows: [string, string][]): HTMLElement {
  return h('dl', {}, ...rows.flatMap(([name, value]) => [h('dt', {}, name), h('dd', {}, value)]));
}
