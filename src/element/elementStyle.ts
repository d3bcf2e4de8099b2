/** The default style of the element. Styles of the page for `hatched-model` or its parts take precedence. */
const STYLE = `
:host {
  display: block;
  position: relative;
  aspect-ratio: 4 / 3;
  overflow: hidden;
}
:host([hidden]) {
  display: none;
}
canvas, img {
  position: absolute;
  width: 100%;
  height: 100%;
  object-fit: cover;
}
canvas {
  opacity: 0;
}
canvas[data-drawn] {
  opacity: 1;
}
canvas:focus-visible {
  outline: 2px solid currentColor;
  outline-offset: -4px;
}
p {
  position: absolute;
  inset: auto 0 0;
  margin: 0;
  padding: 0.75em 1em;
  background: #f7f3e8;
  color: #1c1a17;
  overflow-wrap: anywhere;
}
[hidden] {
  display: none;
}
@media (prefers-reduced-motion: no-preference) {
  canvas {
    transition: opacity 0.35s;
  }
}
`;

let sheet: CSSStyleSheet | undefined;

/** The style sheet that all elements share. It is created by a script, which a strict Content-Security-Policy allows. */
export function elementStyle(): CSSStyleSheet {
  if (!sheet) {
    sheet = new CSSStyleSheet();
    sheet.replaceSync(STYLE);
  }
  return sheet;
}
