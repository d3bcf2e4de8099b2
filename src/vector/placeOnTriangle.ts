import { flatNormalOf, placeFrom, placeOfVertex, type SurfacePlace } from './LineSurface.js';
import type { Tracing } from './Tracing.js';

/** Textures are taken together over so much of the picture, or lines would become crumbs. Pixels. */
const FOOTPRINT = 2;

/** The place on a triangle that has these numbers. */
export const placeOnTriangle = (tracing: Tracing, numbers: ArrayLike<number>, triangle: number): SurfacePlace =>
  withDetails(tracing, placeFrom(numbers, flatNormalOf(tracing.surface, triangle), tracing.sides[triangle]), triangle);

/** The place of a vertex, as a triangle has it. */
export const placeAtVertex = (tracing: Tracing, vertex: number, triangle: number): SurfacePlace =>
  withDetails(tracing, placeOfVertex(tracing.surface, vertex, triangle, tracing.sides[triangle]), triangle);

function withDetails(tracing: Tracing, place: SurfacePlace, triangle: number): SurfacePlace {
  const { surface, details, painter, projection } = tracing;
  if (!details) return place;
  const parent = surface.parents[triangle];
  const read = details.read(parent, place.world);
  place.posed = details.posedMaps();
  if (painter) {
    painter.goTo(parent, details.edgesOf(parent));
    place.paint = painter.paintAt(read, FOOTPRINT * projection.unitsPerPixel(-place.view[2]));
    const { relief } = place.paint;
    if (relief) place.toneNormal = painter.bent(place.toneNormal, relief, details.cornersOf(parent));
  }
  return place;
}
