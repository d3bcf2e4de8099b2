import { AnimationClock, animationRules } from './animation.js';
import type { WrittenPath } from './finishPaths.js';

/** A layer of a drawing: paths of one colour. */
export interface SVGLayer {
  name: string;
  /** Such as `#1c1a17`. */
  ink: string;
  /** From 0 to 1. */
  opacity: number;
  /** In the order of drawing. */
  paths: readonly WrittenPath[];
}

/** The sheet and the style of drawing. */
export interface SVGSheet {
  /** Millimetres. */
  width: number;
  height: number;
  /** The colour of the paper; null for none. */
  paper: string | null;
  /** A picture below all layers, with its position and size in millimetres; null for none. */
  picture: { url: string; x: number; y: number; width: number; height: number } | null;
  /** The width of the pen, millimetres; null where paths are filled. */
  pen: number | null;
  /** Duration of the animation in seconds; null for a still drawing. */
  animate: number | null;
}

const INKSCAPE = 'http://www.inkscape.org/namespaces/inkscape';

/** A number of millimetres, rounded to three digits. */
const millimetres = (value: number): string => String(Number(value.toFixed(3)));

/** Writes a drawing as an SVG document. Empty layers are omitted, and the others numbered, as programs for plotters require. */
export function writeSVG(
  { width, height, paper, picture, pen, animate }: SVGSheet,
  layers: readonly SVGLayer[],
): string {
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
  const drawn = layers.flatMap(({ paths }) => paths).reduce((sum, { length }) => sum + length, 0);
  const clock = animate === null ? null : new AnimationClock(animate, drawn, pen !== null);
  if (clock) lines.push(animationRules(pen !== null));
  for (const [i, { name, ink, opacity, paths }] of layers.filter((layer) => layer.paths.length > 0).entries()) {
    const look =
      pen === null
        ? `fill="${ink}"${opacity < 1 ? ` opacity="${opacity}"` : ''}`
        : `fill="none" stroke="${ink}" stroke-width="${millimetres(pen)}" stroke-linecap="round" stroke-linejoin="round"`;
    lines.push(`<g id="layer${i + 1}" inkscape:groupmode="layer" inkscape:label="${i + 1} ${name}" ${look}>`);
    for (const path of paths) lines.push(`<path d="${path.data}"${clock?.attributesOf(path) ?? ''}/>`);
    lines.push('</g>');
  }
  return `${[...lines, '</svg>'].join('\n')}\n`;
}
