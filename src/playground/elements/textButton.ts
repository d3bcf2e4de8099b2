/** Creates a button of a dialog that looks like text. @param name what screen readers call it, if not by its label */
export function textButton(label: string, run: () => void, name?: string): HTMLButtonElement {
  const button = Object.assign(document.createElement('button'), { type: 'button', textContent: label });
  button.className = 'text-button';
  if (name) button.setAttribute('aria-label', name);
  button.addEventListener('click', run);
  return button;
}
