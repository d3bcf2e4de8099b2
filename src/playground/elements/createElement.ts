/** Creates a dialog button that looks like text. @param name accessible name, by default the label */
export function textButton(label: string, run: () => void, name?: string): HTMLButtonElement {
  const button = Object.assign(document.createElement('button'), { type: 'button', textContent: label });
  button.className = 'text-button';
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
