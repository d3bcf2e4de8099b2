import {
  type FlatTriangle,
  type LineSurface,
  placeFrom,
  placeOfVertex,
  readTriangle,
  type SurfacePlace,
} from '../LineSurface.js';
import type { Projection } from '../Projection.js';
import { ColourReader } from './ColourReader.js';
import { DetailReader } from './DetailReader.js';
import type { Paint, PaintLook } from './PaintLook.js';

/** Footprint over which textures are averaged, so that lines do not crumble. Pixels of the picture. */
const FOOTPRINT = 2;

/** Reads places on a surface, with their maps where it deforms, and their paint. */
export class PlaceReader {
  /** Null for a surface without details. */
  private readonly details: DetailReader | null;
  /** Null without textures and vertex colours that affect tone. */
  private readonly painter: ColourReader | null;

  /** The triangle that was read last, since neighbouring places lie on the same. */
  private last = -1;
  private flat!: FlatTriangle;

  /** @param sides per triangle 1 if its front is visible, −1 if its back is */
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

  /** Whether the surface has details. */
  get hasDetails(): boolean {
    return this.details !== null;
  }

  /** Whether textures or vertex colours affect tone. */
  get hasPaint(): boolean {
    return this.painter !== null;
  }

  /** Whether a normal or bump map is in use, so that any tone may occur anywhere. */
  get hasRelief(): boolean {
    return this.painter?.hasRelief ?? false;
  }

  /** The place on a triangle with the given numbers. */
  read(numbers: ArrayLike<number>, triangle: number): SurfacePlace {
    if (triangle !== this.last) this.flat = readTriangle(this.surface, triangle);
    this.last = triangle;
    return this.withDetails(placeFrom(numbers, this.flat, this.sides[triangle]), triangle);
  }

  /** The place of a vertex of a triangle. */
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

  /** Bounds of the paint at a place of a triangle; null for none. */
  paintsAt(triangle: number, { world }: SurfacePlace): readonly (Paint | null)[] {
    const { details, painter, surface } = this;
    return details && painter ? painter.boundsAt(details.read(surface.parents[triangle], world)) : NO_PAINT;
  }
}

const NO_PAINT = [null];
