import { type LineSurface, placeFrom, placeOfVertex, readTriangle, type SurfacePlace } from '../LineSurface.js';
import type { Projection } from '../Projection.js';
import { ColourReader, type Paint } from './ColourReader.js';
import { DetailReader } from './DetailReader.js';
import type { PaintLook } from './PaintLook.js';

/** Textures are taken together over so much of the picture, or lines would become crumbs. Pixels. */
const FOOTPRINT = 2;

/** Reads places on a surface: what all have, their maps where it deforms, and what textures and colours make of them. */
export class PlaceReader {
  /** Null where the surface has no details. */
  private readonly details: DetailReader | null;
  /** Null where neither textures nor colours of vertices count. */
  private readonly painter: ColourReader | null;

  /** @param sides per triangle 1 where its front is seen, −1 where its back is */
  constructor(
    private readonly surface: LineSurface,
    paint: PaintLook | null,
    private readonly sides: Int8Array,
    private readonly projection: Projection,
  ) {
    const { details } = surface;
    this.details = details && new DetailReader(surface, details);
    this.painter = paint && details && new ColourReader(paint, details);
  }

  /** Whether places differ in more than where they are. */
  get hasDetails(): boolean {
    return this.details !== null;
  }

  /** Whether textures or colours count. */
  get hasPaint(): boolean {
    return this.painter !== null;
  }

  /** Whether a map bends normals, so that any tone may be anywhere. */
  get hasRelief(): boolean {
    return this.painter?.hasRelief ?? false;
  }

  /** The place on a triangle that has these numbers. */
  read(numbers: ArrayLike<number>, triangle: number): SurfacePlace {
    return this.withDetails(placeFrom(numbers, readTriangle(this.surface, triangle), this.sides[triangle]), triangle);
  }

  /** The place of a vertex, as a triangle has it. */
  readVertex(vertex: number, triangle: number): SurfacePlace {
    return this.withDetails(placeOfVertex(this.surface, vertex, triangle, this.sides[triangle]), triangle);
  }

  private withDetails(place: SurfacePlace, triangle: number): SurfacePlace {
    const { surface, details, painter, sides, projection } = this;
    if (!details) return place;
    const parent = surface.parents[triangle];
    const read = details.read(parent, place.world);
    place.posed = details.posedMaps();
    if (!painter) return place;
    painter.goTo(parent, details.edgesOf(parent), details.cornersOf(parent));
    const footprint = FOOTPRINT * projection.unitsPerPixel(-place.view[2]);
    place.paint = painter.paintAt(read, footprint);
    if (painter.hasRelief) {
      const { world, toneNormal: normal } = place;
      place.isPlane = false;
      place.toneNormal = painter.bent({ world, normal, side: sides[triangle], projection }, read, footprint);
    }
    return place;
  }

  /** The paints between which that of a place of a triangle may lie; null where there is none. */
  paintsAt(triangle: number, { world }: SurfacePlace): readonly (Paint | null)[] {
    const { details, painter, surface } = this;
    return details && painter ? painter.boundsAt(details.read(surface.parents[triangle], world)) : NO_PAINT;
  }
}

const NO_PAINT = [null];
