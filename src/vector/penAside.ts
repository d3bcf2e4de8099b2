import { asideOf } from '../engraving/penLines.js';
import { smoothstep } from '../engraving/vectors.js';
import type { FamilyName } from './Engraver.js';
import { between, flatNormalOf, placeFrom, STRIDE, VIEW } from './LineSurface.js';
import { type LinesAside, NO_RANK } from './levelSegments.js';
import { penSpacing } from './marks/lineMarks.js';
import type { Tones } from './Toner.js';
import type { Tracing } from './Tracing.js';

/** No line moves farther aside than so many times the distance between old lines. */
const MOST_ASIDE = 1.5;
/** Lines that moved aside where their distance changes would waver: octaves per pixel from which on they do so less, and no more. */
const STEADY = [0.0015, 0.005] as const;
/** The least length by which a change is measured, pixels. */
const LEAST_LENGTH = 4;
/** They come back to their places over so many triangles. */
const ROUNDS = 3;

/** How far the lines of a family move aside so that those of a pen are evenly apart; nothing where widths are the tone. */
export function* penAside(
  tracing: Tracing,
  family: FamilyName,
  ranks: Int16Array,
): Generator<number, LinesAside | undefined, void> {
  const { pen, toner, engraver, places } = tracing;
  // The tone of shadows alone and of textures is nowhere steady.
  if (pen === null || toner.isGround || engraver.hasSeams || places.hasDetails || engraver.medium !== 'ink')
    return undefined;
  const { placeOf, triangles } = tracing.surface;
  const octaves = yield* askedOctaves(tracing, family, ranks, pen);
  let steady = steadiness(tracing, ranks, octaves);
  for (let round = 0; round < ROUNDS; round++) {
    yield 0.9;
    steady = easedOff(triangles, placeOf, ranks, steady);
  }
  return {
    at(value, vertex) {
      const share = steady[placeOf[vertex]];
      return share > 0 ? share * asideOf(value, 2 ** octaves[placeOf[vertex]]) : 0;
    },
    mostAt(vertex) {
      const place = placeOf[vertex];
      return steady[place] > 0 ? MOST_ASIDE * 2 ** Math.ceil(octaves[place]) : 0;
    },
  };
}

/** Per place the octave of the distance that lines are asked to have: the mean of its triangles, as lines are the same on all sides of it. */
function* askedOctaves(
  { surface, engraver, toner, sides }: Tracing,
  family: FamilyName,
  ranks: Int16Array,
  pen: number,
): Generator<number, Float64Array, void> {
  const { vertices, triangles, placeOf } = surface;
  const tones: Tones[] = [];
  const octaves = new Float64Array(placeOf.length);
  const counts = new Uint16Array(placeOf.length);
  for (let t = 0; t < sides.length; t++) {
    if (t % 1024 === 1023) yield (0.8 * t) / sides.length;
    if (ranks[t] === NO_RANK) continue;
    for (let k = 0; k < 3; k++) {
      const v = triangles[3 * t + k];
      const place = placeFrom(between(vertices, v, v, 0), flatNormalOf(surface, t), sides[t]);
      tones[v] ??= toner.read(place, toner.hasShadows ? 'traced' : 'none');
      const measure = engraver.measure(family, place, tones[v]);
      octaves[placeOf[v]] += Math.log2(penSpacing(measure, pen));
      counts[placeOf[v]]++;
    }
  }
  for (let place = 0; place < octaves.length; place++) octaves[place] /= counts[place] || 1;
  return octaves;
}

/** Per place 1 where the distance of lines hardly changes around it, and 0 where it changes much. */
function steadiness({ surface, projection }: Tracing, ranks: Int16Array, octaves: Float64Array): Float64Array {
  const { vertices, triangles, placeOf } = surface;
  const steady = new Float64Array(octaves.length).fill(1);
  for (let t = 0; t < ranks.length; t++) {
    const corners = [triangles[3 * t], triangles[3 * t + 1], triangles[3 * t + 2]];
    const places = corners.map((v) => placeOf[v]);
    let change = ranks[t] === NO_RANK ? Infinity : 0;
    const pixels = corners.map((v) => {
      const o = STRIDE * v + VIEW;
      return projection.project(vertices[o], vertices[o + 1], vertices[o + 2]);
    });
    for (const [i, j] of [
      [0, 1],
      [1, 2],
      [2, 0],
    ]) {
      const length = Math.hypot(pixels[i][0] - pixels[j][0], pixels[i][1] - pixels[j][1]);
      change = Math.max(change, Math.abs(octaves[places[i]] - octaves[places[j]]) / Math.max(length, LEAST_LENGTH));
    }
    const share = 1 - smoothstep(STEADY[0], STEADY[1], change);
    for (const place of places) steady[place] = Math.min(steady[place], share);
  }
  return steady;
}

/** The shares of places, held down to the mean of what lies around them. */
function easedOff(triangles: Int32Array, placeOf: Int32Array, ranks: Int16Array, shares: Float64Array): Float64Array {
  const sums = new Float64Array(shares.length);
  const counts = new Float64Array(shares.length);
  for (let t = 0; t < ranks.length; t++) {
    const places = [0, 1, 2].map((k) => placeOf[triangles[3 * t + k]]);
    const mean = (shares[places[0]] + shares[places[1]] + shares[places[2]]) / 3;
    for (const place of places) {
      sums[place] += mean;
      counts[place]++;
    }
  }
  return shares.map((share, place) => Math.min(share, sums[place] / (counts[place] || 1)));
}
