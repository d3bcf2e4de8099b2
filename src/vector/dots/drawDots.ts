import { asPhase } from '../../mesh/phases.js';
import type { Bvh } from '../Bvh.js';
import type { DrawnScene, StippledSurface } from '../DrawnScene.js';
import type { Projection } from '../Projection.js';
import type { Fading } from '../paint/Fading.js';
import { PlaceReader } from '../paint/PlaceReader.js';
import { subdivide } from '../subdivide.js';
import { Toner } from '../Toner.js';
import { seenSides } from '../traceFamily.js';
import { type Dot, placeDots } from './placeDots.js';

/** The dots of one ink. */
export interface DotLayer {
  ink: string;
  dots: Dot[];
}

/** Draws the dots of stippled surfaces. above: height above surfaces at which rays start, world units. Yields its progress. */
export function* drawDots(
  scene: DrawnScene,
  projection: Projection,
  bvh: Bvh,
  fading: Fading,
  above: number,
): Generator<number, DotLayer[], void> {
  const layers: DotLayer[] = [];
  const { stippled } = scene;
  for (const [i, one] of stippled.entries()) {
    const drawing = dotsOf(one, scene, projection, bvh, fading, above);
    const dots = yield* asPhase(drawing, i / stippled.length, (i + 1) / stippled.length);
    const layer = layers.find(({ ink }) => ink === one.ink);
    if (layer) for (const dot of dots) layer.dots.push(dot);
    else layers.push({ ink: one.ink, dots });
  }
  return layers;
}

function* dotsOf(
  { surface, size, set, layers, look, paint, clip }: StippledSurface,
  { illumination }: DrawnScene,
  projection: Projection,
  bvh: Bvh,
  fading: Fading,
  above: number,
): Generator<number, Dot[], void> {
  yield* asPhase(subdivide(surface, projection), 0, 0.1);
  const sides = yield* asPhase(seenSides(surface, projection), 0.1, 0.15);
  const toner = new Toner(look, illumination, bvh, projection);
  const places = new PlaceReader(surface, paint, sides, projection);
  const scene = { surface, places, clip, size, set, layers, toner, projection, bvh, fading, sides, above };
  return yield* asPhase(placeDots(scene), 0.15, 1);
}
