import { LINE_CONSTANTS } from '../look/constants/lineConstants.js';
import type { Engraver, FamilyName } from './Engraver.js';
import { cornersOf, type LineSurface } from './LineSurface.js';
import { NO_RANK } from './levelSegments.js';
import { finestRank, LEAST_PEN_TONE, plottedOctave, printedOctave } from './lineMarks.js';
import type { Projection } from './Projection.js';
import type { PlaceReader } from './paint/PlaceReader.js';
import type { Shadowing, ToneReader, Tones } from './ToneReader.js';

/** The inputs for tracing the lines of a surface. */
export interface Tracing {
  surface: LineSurface;
  places: PlaceReader;
  engraver: Engraver;
  toneReader: ToneReader;
  projection: Projection;
  /** Per triangle 1 if its front is visible, −1 if its back is, 0 if nothing of it is drawn. */
  sides: Int8Array;
  /** The width of a pen, pixels; null where widths are the tone. */
  pen: number | null;
  /** Whether lines are drawn where these lights (bits) do not arrive; null where they do not depend on shadows. */
  isDrawnIn: ((shadows: number) => boolean) | null;
}

const { LEAST_TONE } = LINE_CONSTANTS;
/** Triangles per step. */
const CHUNK = 256;

/** A family at the vertices of a surface. */
export interface FamilyVertices {
  /** The function whose level sets are lines. */
  values: Float64Array;
  /** The rank of the finest lines around each vertex, or NO_RANK. */
  ranks: Int16Array;
  /** 1 where there may be lines. */
  isDark: Uint8Array;
}

/** Reads families at all vertices of visible triangles, each vertex once for all families. Yields its progress. */
export function* readVertices(
  tracing: Tracing,
  families: readonly FamilyName[],
): Generator<number, FamilyVertices[], void> {
  const { surface, sides } = tracing;
  const { triangles } = surface;
  const count = surface.placeOf.length;
  const read = families.map(
    (): FamilyVertices => ({
      values: new Float64Array(count),
      ranks: new Int16Array(count).fill(NO_RANK),
      isDark: new Uint8Array(count),
    }),
  );
  const reader = new VertexReader(tracing, families, read);
  const isRead = new Uint8Array(count);
  for (let t = 0; t < sides.length; t++) {
    if (t % CHUNK === CHUNK - 1) yield t / sides.length;
    if (sides[t] === 0) continue;
    for (let c = 3 * t; c < 3 * t + 3; c++) {
      const vertex = triangles[c];
      if (isRead[vertex] === 1) continue;
      isRead[vertex] = 1;
      reader.read(vertex, t);
    }
  }
  return read;
}

/** The bound of the tones on a surface whose normals are modified by a map. */
const DARKEST: Tones = { tone: 1, unshadowed: 0.5, shadows: 0, left: 1, full: 0, turned: 0, dark: 0 };

class VertexReader {
  private readonly shadowings: readonly Shadowing[];
  private readonly leastTone: number;

  constructor(
    private readonly tracing: Tracing,
    private readonly families: readonly FamilyName[],
    private readonly into: readonly FamilyVertices[],
  ) {
    this.shadowings = tracing.toneReader.hasShadows ? ['none', 'all'] : ['none'];
    this.leastTone = tracing.pen === null || tracing.engraver.hasRows ? LEAST_TONE : LEAST_PEN_TONE;
  }

  read(vertex: number, triangle: number): void {
    const { tracing, families, into, shadowings } = this;
    const { engraver, toneReader, places } = tracing;
    const place = places.readVertex(vertex, triangle);
    const at = engraver.at(place);
    for (let i = 0; i < families.length; i++) into[i].values[vertex] = engraver.valueAt(families[i], at);
    for (const paint of places.paintsAt(triangle, place)) {
      place.paint = paint;
      for (const shadowing of shadowings) {
        const tones = places.hasRelief ? DARKEST : toneReader.read(place, shadowing);
        for (let i = 0; i < families.length; i++) {
          const measure = engraver.measure(families[i], at, tones);
          const octave = tracing.pen === null ? printedOctave(measure) : plottedOctave(measure, tracing.pen);
          const rank = finestRank(octave, engraver.technique);
          if (rank < into[i].ranks[vertex]) into[i].ranks[vertex] = rank;
          if (measure.tone > this.leastTone) into[i].isDark[vertex] = 1;
        }
      }
    }
  }
}

/** The rank of the finest lines of every triangle: that of its finest corner, or NO_RANK for none. */
export function* ranksOfTriangles(
  { surface, sides }: Tracing,
  { ranks, isDark }: FamilyVertices,
): Generator<number, Int16Array, void> {
  const finest = new Int16Array(sides.length).fill(NO_RANK);
  for (let t = 0; t < sides.length; t++) {
    if (t % (64 * CHUNK) === 64 * CHUNK - 1) yield t / sides.length;
    if (sides[t] === 0) continue;
    const [a, b, c] = cornersOf(surface, t);
    if (isDark[a] + isDark[b] + isDark[c] > 0) finest[t] = Math.min(ranks[a], ranks[b], ranks[c]);
  }
  return finest;
}
