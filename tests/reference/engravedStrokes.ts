/** The strokes of engraved lines: those of a pen, and the wedges of a woodcut. Shares no code with the shader. */
import type { Vec3 } from './referenceAdjacency.js';
import type { ScreenPlane } from './ScreenPlane.js';
import { clamp01, cross, smoothly, unit } from './vectors.js';

/** The Thue–Morse sequence: each digit is the parity of the binary ones of its index. */
const THUE_MORSE = Array.from({ length: 32 }, (_, place) => [...place.toString(2)].filter((d) => d === '1').length % 2);

/** The alternating digits 0 and 1, whose value is a third. */
const THIRD = Array.from({ length: 32 }, (_, place) => place % 2);

/** Digits from an index on, repeated. */
const digitsFrom = (place: number, digits: readonly number[] = THUE_MORSE): bigint =>
  BigInt(`0b${Array.from({ length: 32 }, (_, i) => digits[(place + i) % 32]).join('')}`);

/**
 * A hash in [0, 1) of the line at a value: 24 bits of the fraction of its absolute value times the number with these digits; half a turn
 * farther for values below 0.
 */
export function hash01(value: number, digits: readonly number[] = THUE_MORSE): number {
  const size = Math.abs(Math.fround(value));
  const exponent = size === 0 ? -127 : Math.floor(Math.log2(size));
  const significand = size === 0 ? 1n << 23n : BigInt(size * 2 ** (23 - exponent));
  const fraction = BigInt.asUintN(32, significand * digitsFrom((exponent + 127) % 32, digits));
  return (Number(fraction >> 8n) / 2 ** 24 + (value < 0 ? 0.5 : 0)) % 1;
}

/** A hash that is 0, a third or two thirds for three neighbours, the same below 0. */
export const turnOf = (value: number): number => (value === 0 ? 0 : hash01(Math.abs(value), THIRD));

/** A factor on the width of the line at a value. */
export const lineFactor = (value: number, handmade: number): number => 1 + handmade * (0.5 * hash01(value) - 0.25);

/**
 * The coordinates along the lines: on two axes, in tiles, with the weight of the first; the length of strokes, and the share of strokes
 * twice as long.
 */
export interface Along {
  places: readonly [number, number];
  share: number;
  period: number;
  longer: number;
}

const AXES: readonly Vec3[] = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
];

interface StrokeSizes {
  strokeLength: number;
  sizedOnScreen: number;
  tilesPerUnit: number;
}

/** Strokes are measured along the two axes along which the lines run most. Their lengths are powers of two. */
export function alongLines(
  place: Vec3,
  normal: Vec3,
  gradient: Vec3,
  plane: ScreenPlane,
  { strokeLength, sizedOnScreen, tilesPerUnit }: StrokeSizes,
): Along {
  const direction = unit(cross(normal, gradient));
  const least = [0, 1, 2].reduce((best, i) => (direction[i] ** 2 < direction[best] ** 2 ? i : best), 0);
  // In the order of the shader, where z replaces the axis that is left out.
  const [first, second] = least === 0 ? [2, 1] : least === 1 ? [0, 2] : [0, 1];
  const share = smoothly(-0.16, 0.16, direction[first] ** 2 - direction[second] ** 2);
  const [ofFirst, ofSecond] = [first, second].map((i) => tilesPerUnit * plane.rateAlong(AXES[i], gradient));
  const rate = share * ofFirst + (1 - share) * ofSecond;
  const octave =
    (1 - sizedOnScreen) * octaveOf(strokeLength / 256) + sizedOnScreen * octaveOf(strokeLength * Math.max(rate, 1e-12));
  const whole = Math.ceil(octave - 0.5);
  return {
    places: [place[first], place[second]],
    share,
    period: 2 ** whole,
    longer: smoothly(0.88, 1, octave - whole + 0.5),
  };
}

/** The number of a line up to its sign: the same on both sides of a seam. */
export const numberOf = (line: number, repeat: number): number =>
  repeat < Infinity ? line - repeat * Math.round(line / repeat) : line;

/** Lines vary less if few lie between repeats of their numbers: fully only from 32 on. */
const differing = (repeat: number, octave: number): number =>
  Math.min(1, Math.max(0.01, (Math.log2(repeat) - octave) / 5));

/** The strokes of a pen at a fragment, the same for all lines. */
export interface PenState {
  tone: number;
  handmade: number;
  along: Along;
  repeat: number;
  /** Octave of the spacing of lines. */
  octave: number;
}

/** The mean over hashes from 0 to `all` of a ramp that begins at the hash and ends `growth` later. */
const grown = (tone: number, all: number, growth: number): number => {
  // The integral of g (1 − 0.58 (1 − g)), where g rises from 0 to 1.
  const rising = (g: number) => 0.42 * (g ** 2 / 2) + 0.58 * (g ** 3 / 3);
  const untilNow = (x: number) =>
    x <= 0 ? 0 : x < growth ? growth * rising(x / growth) : x - growth + growth * rising(1);
  return (untilNow(tone) - untilNow(tone - all)) / all;
};

/** A hash in [0, 1) of a stroke: random for a line, and evenly spread from stroke to stroke. */
function strokeHash01(line: number, stroke: number): number {
  const [bits] = new Uint32Array(Float32Array.of(Math.abs(line)).buffer);
  const spread = Math.imul(bits ^ (bits >>> 12), 0x9e3779b9) >>> 0;
  const ofLine = BigInt(Math.imul(spread ^ (spread >>> 13), 0x2c1b3c6d));
  const word = BigInt.asUintN(32, ofLine + BigInt(stroke) * digitsFrom(0));
  return Number(word >> 8n) / 2 ** 24;
}

/** The evenly spread hash of a stroke, which starts at that of its line. */
const evenHash = (ofLine: number, stroke: number): number =>
  Number(BigInt.asUintN(32, (BigInt(ofLine * 2 ** 24) << 8n) + BigInt(stroke) * digitsFrom(0)) >> 8n) / 2 ** 24;

/** The width of the strokes on a line, as a share of the room of an old one, and their offset, in distances between lines. */
export function penStroke(
  line: number,
  share: number,
  { tone, handmade, along, repeat, octave }: PenState,
): [number, number] {
  const all = 0.15 * differing(repeat, octave);
  const open = tone < 0.8 ? (1 - 1.25 * tone) ** 2 : 0;
  const filling = tone / Math.max(grown(tone, all, 0.05) * (1 - (0.15 + 0.3) * open), 1e-4);
  const full = tone < all && filling > 0.6 ? 0.6 : filling;
  const number = numberOf(line, repeat);
  // In dark tones no stroke of a line is left out, and new ones are thin.
  const few = Math.sqrt(open);
  const there = few * Math.sqrt(Math.max(share, 0)) + 1 - few;
  const last = 1 - there;
  const born =
    there < 0.04 ? Math.sqrt(0.16 * there) : last > 0.04 ? there + 0.04 : 1.08 - Math.sqrt(Math.max(0.16 * last, 0));
  const fract = (x: number) => x - Math.floor(x);
  const hash = hash01(Math.abs(number));
  const turn = turnOf(number);
  const beginOf = (stroke: number) => stroke + 0.4 * fract(16 * strokeHash01(number, stroke));
  const one = (place: number, period: number): [number, number] => {
    const at = place / period + hash;
    let stroke = Math.floor(at);
    while (beginOf(stroke) > at) stroke--;
    while (beginOf(stroke + 1) <= at) stroke++;
    const chance = strokeHash01(number, stroke);
    const even = evenHash(hash, stroke);
    const [begin, end] = [beginOf(stroke), beginOf(stroke + 1)];
    const way = (at - begin - (end - at)) / (end - begin);
    const sized = clamp01((tone - all * fract(turn + even / 3)) / 0.05);
    const length = 1 - open * 0.3 * fract(64 * even) - 0.35 * (1 - sized);
    // The part of the taper that is behind.
    const rest = clamp01((open * 0.9 - (length - Math.abs(way))) / Math.max(open * 0.9, 1e-3));
    const grownTo = sized * clamp01((born - fract(512 * even)) / 0.08);
    const spread = 1 + handmade * 0.5 * open * (fract(4096 * even) - 0.5);
    const astray = 0.22 * (fract(64 * even) - 0.5) * way + 0.16 * (chance - 0.5) * (0.5 - way * way);
    return [
      full * (share / Math.max(there, 1e-4)) * grownTo * spread * (1 - rest * rest),
      handmade * open * Math.sign(number) * astray,
    ];
  };
  const mix = (a: [number, number], b: [number, number], t: number): [number, number] => [
    (1 - t) * a[0] + t * b[0],
    (1 - t) * a[1] + t * b[1],
  ];
  const [first, second] = along.places.map((place) =>
    mix(one(place, along.period), one(place, 2 * along.period), along.longer),
  );
  // A line changes from one axis to the other over a fifth of the way, which begins by its hash.
  return mix(second, first, clamp01((1.2 * along.share - fract(8 * hash)) / 0.2));
}

/** A row of wedges of length 1: each rises from −1 to 1 over 0.7 of its length, and falls over the rest. */
function gouge(x: number): number {
  const t = x - Math.floor(x);
  return t < 0.7 ? (2 * t) / 0.7 - 1 : (2 * (1 - t)) / 0.3 - 1;
}

/** The share of its room that the cut of a line takes. */
export function cutShare(
  line: number,
  white: number,
  { places, share, period, longer }: Along,
  repeat: number,
  octave: number,
): number {
  const rarer = Math.min(white, 1 - white);
  const swell = Math.min(0.42, 1.3 * rarer) * differing(repeat, octave);
  const hash = turnOf(numberOf(line, repeat));
  const mixed = (a: number, b: number, t: number) => (1 - t) * a + t * b;
  const flattened = (t: number) => Math.hypot(t, 1 - t);
  const waves = places.map((place) => {
    const wedges = place / period;
    return mixed(gouge(wedges + hash), gouge(wedges / 2 + hash), longer);
  });
  const wave = mixed(waves[1], waves[0], share) / (flattened(longer) * flattened(share));
  // Makes the mean over all waves the wanted one.
  const middleFor = (rare: number) => (rare < swell ? Math.sqrt(4 * swell * rare) - swell : rare);
  const middle = white < 0.5 ? middleFor(white) : 1 - middleFor(1 - white);
  return clamp01(middle + swell * wave);
}

/** The logarithm to base 2 at powers of two, linear between them, and its inverse. */
export const octaveOf = (x: number): number => {
  const whole = Math.floor(Math.log2(x));
  return whole + x / 2 ** whole - 1;
};
export const powerOf = (octave: number): number => 2 ** Math.floor(octave) * (1 + octave - Math.floor(octave));
