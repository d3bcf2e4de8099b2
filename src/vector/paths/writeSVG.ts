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
  /** The width of the pen, millimetres; null where paths are filled. */
  pen: number | null;
  /** Codes of the AxiDraw's software: before the number of the layer, and after it. */
  codes?: readonly [before: string, after: string];
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
  /** Duration of the animation in seconds; null for a still drawing. */
  animate: number | null;
  /** The blank margin, millimetres. */
  margin: number;
  /** Lines of text in the lower margin, in a layer that plotters leave out. */
  note: readonly string[];
}

const INKSCAPE = 'http://www.inkscape.org/namespaces/inkscape';

/** A number of millimetres, rounded to three digits. */
const millimetres = (value: number): string => String(Number(value.toFixed(3)));

/** Writes a drawing as an SVG document. Empty layers are omitted, and the others numbered, as programs for plotters require. */
export function writeSVG(sheet: SVGSheet, layers: readonly SVGLayer[]): string {
  const { width, height, paper, picture, animate } = sheet;
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
  const isPen = layers.some(({ pen }) => pen !== null);
  const clock = animate === null ? null : new AnimationClock(animate, drawn, isPen);
  if (clock) lines.push(animationRules(isPen));
  for (const [i, layer] of layers.filter(({ paths }) => paths.length > 0).entries()) {
    const { name, ink, opacity, paths, pen, codes = ['', ''] } = layer;
    const look =
      pen === null
        ? `fill="${ink}"${opacity < 1 ? ` opacity="${opacity}"` : ''}`
        : `fill="none" stroke="${ink}" stroke-width="${millimetres(pen)}" stroke-linecap="round" stroke-linejoin="round"`;
    const label = escaped(`${codes[0]}${i + 1}${codes[1]} ${name}`);
    lines.push(`<g id="layer${i + 1}" inkscape:groupmode="layer" inkscape:label="${label}" ${look}>`);
    for (const path of paths) lines.push(`<path d="${path.data}"${clock?.attributesOf(path) ?? ''}/>`);
    lines.push('</g>');
  }
  return `${[...lines, ...noteOf(sheet), '</svg>'].join('\n')}\n`;
}

/** The size of the text of a note, and the least one, millimetres. */
const NOTE_SIZE = 2.5;
const LEAST_NOTE_SIZE = 1;

/** The layer of a note: the software of the AxiDraw leaves out layers whose names begin with `%`, and vpype leaves out text. */
function noteOf({ height, margin, note }: SVGSheet): string[] {
  if (note.length === 0) return [];
  const size = Math.min(Math.max(margin / (note.length + 1), LEAST_NOTE_SIZE), NOTE_SIZE);
  const [x, top] = [Math.max(margin, size), height - (note.length - 0.5) * size];
  const look = `fill="#777777" font-family="sans-serif" font-size="${millimetres(0.8 * size)}"`;
  return [
    `<g id="note" inkscape:groupmode="layer" inkscape:label="% note" ${look}>`,
    ...note.map((line, i) => `<text x="${millimetres(x)}" y="${millimetres(top + i * size)}">${escaped(line)}</text>`),
    '</g>',
  ];
}

/** A text as the content of an element or the value of an attribute. Characters that XML does not know are left out. */
const escaped = (text: string): string =>
  text.replace(/[\p{Cc}\p{Cs}\uFFFE\uFFFF]/gu, '').replace(/[&<>"]/g, (found) => `&#${found.charCodeAt(0)};`);

/** Shortest time in which a filled path appears, and in which a stroke does, seconds. */
const SHORTEST = 0.15;

/** The CSS of an animated drawing. With reduced motion it is shown as a whole. */
function animationRules(isPen: boolean): string {
  const rule = 'animation:draw calc(var(--for)*1s) linear calc(var(--at)*1s) both';
  const frames = isPen
    ? '@keyframes draw{from{stroke-dashoffset:1;visibility:hidden}to{stroke-dashoffset:0}}'
    : '@keyframes draw{from{clip-path:inset(var(--from))}to{clip-path:inset(-9px)}}';
  const dashes = isPen ? 'stroke-dasharray:1 2;' : '';
  return `<style>${frames}@media (prefers-reduced-motion:no-preference){path{${dashes}${rule}}}</style>`;
}

/** Assigns each path its time. */
class AnimationClock {
  private readonly perMillimetre: number;
  private at = 0;

  /**
   * @param seconds duration of the whole
   * @param drawn length of all paths, millimetres
   */
  constructor(
    seconds: number,
    drawn: number,
    private readonly isPen: boolean,
  ) {
    this.perMillimetre = drawn > 0 ? seconds / drawn : 0;
  }

  /** The attributes of the next path. */
  attributesOf({ length, way }: WrittenPath): string {
    const own = length * this.perMillimetre;
    const style = [`--at:${written(this.at)}`, `--for:${written(Math.max(own, SHORTEST))}`];
    if (!this.isPen) style.push(`--from:${coveredFrom(way)}`);
    this.at += own;
    return `${this.isPen ? ' pathLength="1"' : ''} style="${style.join(';')}"`;
  }
}

const written = (seconds: number): string => String(Number(seconds.toFixed(2)));

/** The insets (top, right, bottom, left) that cover a filled path before it appears, so that it grows along its direction. */
function coveredFrom([dx, dy]: readonly [number, number]): string {
  if (Math.abs(dx) >= Math.abs(dy)) return dx >= 0 ? '0 100% 0 0' : '0 0 0 100%';
  return dy >= 0 ? '0 0 100% 0' : '100% 0 0 0';
}
