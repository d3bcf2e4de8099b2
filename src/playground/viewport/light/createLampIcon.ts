/** The icon of the light handle: a disc with eight rays, styled by the style sheet. */
export function createLampIcon(): SVGSVGElement {
  const svg = document.createElementNS('http://www.w3.org/2000/svg', 'svg');
  svg.setAttribute('viewBox', '-24 -24 48 48');
  svg.setAttribute('aria-hidden', 'true');
  const rays = Array.from({ length: 8 }, (_, i) => {
    const [x, y] = [Math.cos((i * Math.PI) / 4), Math.sin((i * Math.PI) / 4)];
    return `M${(13.5 * x).toFixed(2)} ${(13.5 * y).toFixed(2)}L${(19 * x).toFixed(2)} ${(19 * y).toFixed(2)}`;
  });
  const path = document.createElementNS(svg.namespaceURI, 'path');
  path.setAttribute('d', rays.join(''));
  const disc = document.createElementNS(svg.namespaceURI, 'circle');
  disc.setAttribute('r', '8.5');
  svg.append(path, disc);
  return svg;
}
