/** A layer of a drawing: paths of one colour. */
export interface SVGLayer {
  name: string;
  /** As in `#1c1a17`. */
  ink: string;
  /** Path data, in the order of drawing. */
  paths: readonly string[];
}

/** The sheet and how it is drawn on. */
export interface SVGSheet {
  /** Millimetres. */
  width: number;
  height: number;
  /** The colour of the paper; null for none. */
  paper: string | null;
  /** A picture below all layers, and where it lies: millimetres; null for none. */
  picture: { url: string; x: number; y: number; width: number; height: number } | null;
  /** The width of the pen, millimetres; null where paths are filled. */
  pen: number | null;
}

const INKSCAPE = 'http://www.inkscape.org/namespaces/inkscape';

/** A number of millimetres without a rest of rounding. */
const millimetres = (value: number): string => String(Number(value.toFixed(3)));

/** Writes a drawing as a document. Layers without paths are left out, and the others are numbered, as plotters' programs ask for. */
export function writeSVG({ width, height, paper, picture, pen }: SVGSheet, layers: readonly SVGLayer[]): string {
  const [w, h] = [millimetres(width), millimetres(height)];
  const lines = [
    `<svg xmlns="http://www.w3.org/2000/svg" xmlns:inkscape="${INKSCAPE}" width="${w}mm" height="${h}mm" viewBox="0 0 ${w} ${h}">`,
  ];
  if (paper !== null) lines.push(`<rect width="${w}" height="${h}" fill="${paper}"/>`);
  if (picture !== null) {
    const [x, y] = [millimetres(picture.x), millimetres(picture.y)];
    const size = `width="${millimetres(picture.width)}" height="${millimetres(picture.height)}"`;
    lines.push('<g id="picture" inkscape:groupmode="layer" inkscape:label="0 picture">');
    lines.push(`<image x="${x}" y="${y}" ${size} preserveAspectRatio="none" href="${picture.url}"/>`, '</g>');
  }
  for (const [i, { name, ink, paths }] of layers.filter((layer) => layer.paths.length > 0).entries()) {
    const look =
      pen === null
        ? `fill="${ink}"`
        : `fill="none" stroke="${ink}" stroke-width="${millimetres(pen)}" stroke-linecap="round" stroke-linejoin="round"`;
    lines.push(`<g id="layer${i + 1}" inkscape:groupmode="layer" inkscape:label="${i + 1} ${name}" ${look}>`);
    for (const data of paths) lines.push(`<path d="${data}"/>`);
    lines.push('</g>');
  }
  return `${[...lines, '</svg>'].join('\n')}\n`;
}
