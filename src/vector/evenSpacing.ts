import { smoothstep, vectorAt } from '../look/vectors.js';
import { asPhase } from '../mesh/phases.js';
import type { FamilyName } from './Engraver.js';
import { cornersOf, onPicture, placeFrom, readTriangle, STRIDE, VIEW } from './LineSurface.js';
import { type LineOffsets, NO_RANK } from './levelSegments.js';
import { penDistance } from './lineMarks.js';
import type { Tracing } from './readVertices.js';
import { evenOffset } from './shading/penLines.js';
import type { VertexTones } from './ToneReader.js';

/** Greatest offset of a line, in distances between old lines. */
const MOST_ASIDE = 1.5;
/** Octaves per pixel of change in spacing between which the offsets of lines fade out, since they would waver. */
const STEADY = [0.0015, 0.005] as const;
/** Least length by which a change is measured, pixels. */
const LEAST_LENGTH = 4;
/** Number of triangles over which the fading is smoothed. */
const ROUNDS = 3;

/** Offsets of the lines of a family that make a pen's lines evenly spaced; none where widths are the tone. */
export function* evenSpacing(
  tracing: Tracing,
  family: FamilyName,
  ranks: Int16Array,
  tones: VertexTones,
): Generator<number, LineOffsets | undefined, void> {
  const { pen, toneReader, engraver, places } = tracing;
  // The tones of grounds and of textures vary everywhere.
  if (
    pen === null ||
    toneReader.isGround ||
    engraver.hasSeams ||
    places.hasDetails ||
    engraver.technique !== 'engraving'
  )
    return undefined;
  const { placeOf, triangles } = tracing.surface;
  const octaves = yield* asPhase(askedOctaves(tracing, family, ranks, tones, pen), 0, 0.6);
  let steady = yield* asPhase(steadiness(tracing, ranks, octaves), 0.6, 0.8);
  for (let round = 0; round < ROUNDS; round++)
    steady = yield* asPhase(easedOff(triangles, placeOf, ranks, steady), 0.8, 1);
  return {
    at(value, vertex) {
      const share = steady[placeOf[vertex]];
      return share > 0 ? share * evenOffset(value, 2 ** octaves[placeOf[vertex]]) : 0;
    },
    mostAt(vertex) {
      const place = placeOf[vertex];
      return steady[place] > 0 ? MOST_ASIDE * 2 ** Math.ceil(octaves[place]) : 0;
    },
  };
}

/** Per place the octave of the spacing of lines: the mean over its triangles, since a line has one spacing on all sides of a place. */
function* askedOctaves(
  { surface, engraver, sides }: Tracing,
  family: FamilyName,
  ranks: Int16Array,
  tones: VertexTones,
  pen: number,
): Generator<number, Float64Array, void> {
  const { vertices, triangles, placeOf } = surface;
  const octaves = new Float64Array(placeOf.length);
  const counts = new Uint16Array(placeOf.length);
  // Per vertex the spacing on the picture, and the gradient of the function.
  const distances = new Float64Array(placeOf.length);
  const gradients = new Float64Array(3 * placeOf.length);
  for (let t = 0; t < sides.length; t++) {
    if (t % 256 === 255) yield t / sides.length;
    if (ranks[t] === NO_RANK) continue;
    const triangle = readTriangle(surface, t);
    for (let c = 3 * t; c < 3 * t + 3; c++) {
      const v = triangles[c];
      if (distances[v] === 0) {
        const place = placeFrom(vertices, triangle, sides[t], STRIDE * v);
        const at = engraver.at(place);
        distances[v] = penDistance(engraver.measure(family, at, tones.at(v, place)), pen);
        gradients.set(engraver.gradientAt(family, at), 3 * v);
      }
      const o = STRIDE * v + VIEW;
      const perPixel = engraver.changeOn(triangle.flatNormal, vectorAt(gradients, 3 * v), vectorAt(vertices, o));
      octaves[placeOf[v]] += Math.log2(distances[v] * perPixel);
      counts[placeOf[v]]++;
    }
  }
  for (let place = 0; place < octaves.length; place++) octaves[place] /= counts[place] || 1;
  return octaves;
}

/** Per place 1 where the spacing of lines hardly changes around it, and 0 where it changes much. */
function* steadiness(
  { surface, projection }: Tracing,
  ranks: Int16Array,
  octaves: Float64Array,
): Generator<number, Float64Array, void> {
  const { triangles, placeOf } = surface;
  const steady = new Float64Array(octaves.length).fill(1);
  const changeAlong = (u: number, v: number): number => {
    const [[ux, uy], [vx, vy]] = [u, v].map((vertex) => onPicture(surface, vertex, projection));
    return Math.abs(octaves[placeOf[u]] - octaves[placeOf[v]]) / Math.max(Math.hypot(ux - vx, uy - vy), LEAST_LENGTH);
  };
  for (let t = 0; t < ranks.length; t++) {
    if (t % 4096 === 4095) yield t / ranks.length;
    const [a, b, c] = cornersOf(surface, t);
    const isLined = ranks[t] !== NO_RANK;
    const change = isLined ? Math.max(changeAlong(a, b), changeAlong(b, c), changeAlong(c, a)) : Infinity;
    const share = 1 - smoothstep(STEADY[0], STEADY[1], change);
    for (let k = 3 * t; k < 3 * t + 3; k++) {
      const place = placeOf[triangles[k]];
      if (share < steady[place]) steady[place] = share;
    }
  }
  return steady;
}

/** The shares of places, limited to the mean of their neighbours. */
function* easedOff(
  triangles: Int32Array,
  placeOf: Int32Array,
  ranks: Int16Array,
  shares: Float64Array,
): Generator<number, Float64Array, void> {
  const sums = new Float64Array(shares.length);
  const counts = new Float64Array(shares.length);
  for (let t = 0; t < ranks.length; t++) {
    if (t % 16384 === 16383) yield t / ranks.length;
    const [a, b, c] = vectorAt(triangles, 3 * t).map((vertex) => placeOf[vertex]);
    const mean = (shares[a] + shares[b] + shares[c]) / 3;
    for (const place of [a, b, c]) {
      sums[place] += mean;
      counts[place]++;
    }
  }
  for (let place = 0; place < sums.length; place++)
    sums[place] = Math.min(shares[place], sums[place] / (counts[place] || 1));
  return sums;
}
