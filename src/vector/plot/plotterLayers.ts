import type { WrittenPath } from '../paths/finishPaths.js';
import { type SVGLayer, type SVGSheet, writeSVG } from '../paths/writeSVG.js';
import type { FileLayer } from './penLayers.js';
import type { PenPlan } from './pens.js';
import { refills } from './refills.js';

/**
 * The layers of a file, divided where a pen is filled again, with the codes that AxiDraw's software reads in their names: `!` pauses, `+S` sets the
 * speed.
 *
 * @param pens null for a print
 */
export function plotterLayers(
  finished: readonly { layer: FileLayer; written: readonly WrittenPath[] }[],
  pens: PenPlan | null,
): SVGLayer[] {
  const end = hasPens(pens) ? ' -' : '';
  return finished.flatMap(({ layer: { name, ink, opacity, pen, speed }, written }) =>
    refills(written, pens?.refill ?? null).map(
      (paths, part): SVGLayer => ({
        ...{ name, ink, opacity, pen, paths },
        codes: [part > 0 ? '!' : '', `${speed === null ? '' : `+S${speed}`}${end}`],
      }),
    ),
  );
}

/** The file of a whole drawing, which pauses where another pen is needed than for the layer before. */
export function plotterFile(layers: readonly SVGLayer[], pens: PenPlan | null, sheet: SVGSheet): string {
  if (!hasPens(pens)) return writeSVG(sheet, layers);
  const pausing = layers.map((layer, i): SVGLayer => {
    const before = layers[i - 1] ?? layer;
    const isOther = before.ink !== layer.ink || before.pen !== layer.pen;
    return isOther ? { ...layer, codes: ['!', layer.codes?.[1] ?? ''] } : layer;
  });
  return writeSVG(sheet, pausing);
}

/** A file for each pen. */
export function filesOfPens(layers: readonly SVGLayer[], sheet: SVGSheet): { name: string; svg: string }[] {
  const byPen = new Map<string, SVGLayer[]>();
  for (const layer of layers) {
    const name = `${layer.ink} ${layer.pen}`;
    byPen.set(name, [...(byPen.get(name) ?? []), layer]);
  }
  return [...byPen.values()].map((all) => ({
    name: all.length === 1 ? all[0].name : `${all[0].ink} ${all[0].pen}`,
    svg: writeSVG(sheet, all),
  }));
}

/** Whether layers are those of pens, not of kinds of lines. */
const hasPens = (pens: PenPlan | null): boolean => pens !== null && pens.layers !== 'layer';
