import type { DotLayer } from '../drawDots.js';
import type { PathLayer } from '../LineDrawer.js';
import type { LinePath } from '../paths/LinePath.js';
import { type PenPart, type PenPlan, partOfLayer, penWidth } from './pens.js';

/** A layer of a file before its paths are finished. */
export interface FileLayer {
  name: string;
  ink: string;
  /** From 0 to 1. */
  opacity: number;
  /** The width of its pen, millimetres; null where paths are filled. */
  pen: number | null;
  /** Percent of the plotter's greatest speed; null for the plotter's own setting. */
  speed: number | null;
  paths: readonly LinePath[];
  /** Null for a layer of lines. */
  dots: DotLayer['dots'] | null;
}

/** Lines or dots of one kind and ink. */
interface DrawnLayer {
  kind: PathLayer['name'] | 'stipple';
  ink: string;
  opacity: number;
  group: string;
  paths: readonly LinePath[];
  dots: DotLayer['dots'] | null;
}

/** The layers of a file, in the order in which they are drawn. @param pens null where paths are filled */
export function fileLayers(lines: readonly PathLayer[], dots: readonly DotLayer[], pens: PenPlan | null): FileLayer[] {
  const drawn: DrawnLayer[] = [
    ...lines.map(({ name, ...layer }) => ({ ...layer, kind: name, dots: null })),
    ...dots.map((layer) => ({ ...layer, kind: 'stipple' as const, opacity: 1, paths: [] })),
  ];
  if (pens === null || pens.layers === 'layer') return drawn.map((layer) => layerOfKind(layer, drawn, pens));
  return layersOfPens(drawn, pens);
}

const partOf = ({ kind }: DrawnLayer): PenPart => (kind === 'stipple' ? 'dots' : partOfLayer(kind));

function layerOfKind(layer: DrawnLayer, all: readonly DrawnLayer[], pens: PenPlan | null): FileLayer {
  const { kind, ink, opacity, paths, dots } = layer;
  const isAlone = all.filter((other) => other.kind === kind).length === 1;
  const pen = pens && penWidth(pens, partOf(layer), ink);
  return { name: isAlone ? kind : `${kind} ${ink}`, ink, opacity, pen, speed: null, paths, dots };
}

/** One layer for each pen, and material or part; dots have a second one. */
function layersOfPens(drawn: readonly DrawnLayer[], pens: PenPlan): FileLayer[] {
  const layers = new Map<string, FileLayer & { paths: LinePath[] }>();
  for (const one of drawn) {
    const { ink, group, paths, dots } = one;
    const pen = penWidth(pens, partOf(one), ink);
    const listed = pens.pens.find((other) => other.ink === ink);
    const title = listed?.name ?? (pens.layers === 'ink' ? ink : `${group || 'no name'} ${ink}`);
    const name = `${title} ${pen}`;
    const key = `${name}${dots ? ' of dots' : ''}`;
    const known = layers.get(key);
    if (!known) layers.set(key, { name, ink, opacity: 1, pen, speed: listed?.speed ?? null, paths: [...paths], dots });
    else if (dots) known.dots = [...(known.dots ?? []), ...dots];
    else for (const path of paths) known.paths.push(path);
  }
  const rankOf = ({ ink }: FileLayer): number => pens.pens.findIndex((pen) => pen.ink === ink);
  const named = [...layers.values()];
  const firstOf = ({ name }: FileLayer): number => named.findIndex((other) => other.name === name);
  return named.toSorted((a, b) => rankOf(a) - rankOf(b) || firstOf(a) - firstOf(b));
}
