import type { WrittenPath } from '../paths/finishPaths.js';

/** A layer of a drawing. */
interface DxfLayer {
  layer: { name: string; ink: string };
  written: readonly WrittenPath[];
}

/** The layers that drawings are expected to have, by those of a file for one pen. */
const NAMES: Readonly<Record<string, string>> = {
  outlines: 'VISIBLE',
  hidden: 'HIDDEN',
  lines: 'HATCH',
  crossing: 'HATCH_CROSSING',
  shadows: 'HATCH_SHADOWS',
  background: 'BACKGROUND',
  stipple: 'DOTS',
};

/** The colours 1 to 7 of AutoCAD's palette; 7 is drawn black on white. */
const PALETTE = ['#ff0000', '#ffff00', '#00ff00', '#00ffff', '#0000ff', '#ff00ff', '#000000'];

/**
 * Writes the lines of a pen as a DXF file of release 12: a POLYLINE for each path, in millimetres from the lower left corner of the sheet. Lines of
 * a print are not written.
 *
 * @param height of the sheet, millimetres
 */
export function writeDxf(height: number, layers: readonly DxfLayer[]): string {
  const named = namedLayers(layers);
  const pairs: (readonly [code: number, value: string | number])[] = [
    [0, 'SECTION'],
    [2, 'HEADER'],
    [9, '$ACADVER'],
    [1, 'AC1009'],
    [9, '$MEASUREMENT'],
    [70, 1],
    [0, 'ENDSEC'],
    [0, 'SECTION'],
    [2, 'TABLES'],
    [0, 'TABLE'],
    [2, 'LAYER'],
    [70, named.length],
  ];
  for (const { name, ink } of named)
    pairs.push([0, 'LAYER'], [2, name], [70, 0], [62, colorNumber(ink)], [6, 'CONTINUOUS']);
  pairs.push([0, 'ENDTAB'], [0, 'ENDSEC'], [0, 'SECTION'], [2, 'ENTITIES']);
  for (const { name, written } of named) {
    for (const { line } of written) {
      if (!line) continue;
      pairs.push([0, 'POLYLINE'], [8, name], [66, 1], [10, 0], [20, 0], [30, 0], [70, Number(line.isClosed)]);
      for (let i = 0; i < line.points.length; i += 2)
        pairs.push(
          ...([
            [0, 'VERTEX'],
            [8, name],
            [10, millimetres(line.points[i])],
            [20, millimetres(height - line.points[i + 1])],
            [30, 0],
          ] as const),
        );
      pairs.push([0, 'SEQEND'], [8, name]);
    }
  }
  pairs.push([0, 'ENDSEC'], [0, 'EOF']);
  return pairs.map(([code, value]) => `${code}\n${value}\n`).join('');
}

const millimetres = (value: number): string => String(Number(value.toFixed(3)));

/** Layers with names as release 12 allows them: up to 31 letters, digits and a few signs, none twice. */
function namedLayers(layers: readonly DxfLayer[]): { name: string; ink: string; written: readonly WrittenPath[] }[] {
  const used = new Set<string>();
  return layers.map(({ layer: { name, ink }, written }) => {
    const plain = name.replace(/[^a-z0-9$_-]+/gi, '_').replace(/^_+|_+$/g, '');
    const long = (NAMES[name] ?? plain.toUpperCase()).slice(0, 28) || 'LAYER';
    let free = long;
    for (let i = 2; used.has(free); i++) free = `${long}_${i}`;
    used.add(free);
    return { name: free, ink, written };
  });
}

/** The nearest colour of the palette. */
function colorNumber(ink: string): number {
  const channels = (color: string): number[] => [1, 3, 5].map((at) => Number.parseInt(color.slice(at, at + 2), 16));
  const own = channels(ink);
  const away = PALETTE.map((color) => channels(color).reduce((sum, value, k) => sum + (value - own[k]) ** 2, 0));
  return 1 + away.indexOf(Math.min(...away));
}
