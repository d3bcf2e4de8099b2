/**
 * Returns the element with an id.
 *
 * @throws Error if the HTML has none
 */
export function findElement(id: string): HTMLElement {
  const element = document.getElementById(id);
  if (!element) throw new Error(`findElement: the page has no element with the id "${id}"; add it back to its HTML.`);
  return element;
}

/**
 * Sets the state of the page for style sheets and tests: `lost` means that the graphics context is lost, `failed` that there is nothing to
 * draw.
 */
export function setPageState(state: 'loading' | 'ready' | 'lost' | 'failed'): void {
  const { dataset } = document.documentElement;
  if (dataset.state !== state) dataset.state = state;
}

/** Creates a dialog button that looks like text. @param name accessible name, by default the label */
export function textButton(label: string, run: () => void, name?: string): HTMLButtonElement {
  const button = element('button', { type: 'button', className: 'text-button' }, label);
  if (name) button.setAttribute('aria-label', name);
  button.addEventListener('click', run);
  return button;
}

/** Creates an element with properties and children. */
export function element<Tag extends keyof HTMLElementTagNameMap>(
  tag: Tag,
  properties: Partial<HTMLElementTagNameMap[Tag]> = {},
  ...children: (Node | string)[]
): HTMLElementTagNameMap[Tag] {
  const created = Object.assign(document.createElement(tag), properties);
  created.append(...children);
  return created;
}
