/**
 * The technique `engraved` at one fragment, in double precision, as documented: level sets of functions of the position, octaves of
 * lines, ink as shares of pixels, families that are printed over each other, and the hand. It shares no code with the shader.
 */
import { mat3, mat4, vec3 } from 'gl-matrix';
import type { HatchingReference, ReferenceLight } from './hatchingReference.js';
import type { ReferenceCamera } from './rasterizeReference.js';
import type { Vec3 } from './referenceAdjacency.js';

export interface EngravedSettings {
  /** Radians. */
  strokeRotation: number;
  lineField: 'light' | 'towards' | 'x' | 'y' | 'z' | 'slant' | 'form' | 'acrossForm';
  /** For the last two: the functions that the lines are level sets of, and those that cross them. */
  form?: readonly [first: Quadratic, crossing: Quadratic];
  lineSpacing: number;
  strokeLength: number;
  crossFrom: number;
  crossAngle: number;
  handmade: number;
  sizedOnScreen: number;
  tilesPerUnit: number;
  /** Default: false. */
  medium?: 'ink' | 'pen' | 'woodcut';
  /** Default: 'tone'. */
  shadowStrokes?: 'tone' | 'cross' | 'reorient';
}

/** Σ aᵢ xᵢ + Σ bᵢ xᵢ², of a place in tiles from the centre. */
export interface Quadratic {
  linear: Vec3;
  squares: Vec3;
}

export const quadraticAt = ({ linear, squares }: Quadratic, place: Vec3): number =>
  place.reduce((sum, x, i) => sum + (linear[i] + squares[i] * x) * x, 0);

export const quadraticGradient = ({ linear, squares }: Quadratic, place: Vec3): Vec3 =>
  place.map((x, i) => linear[i] + 2 * squares[i] * x) as Vec3;

export interface EngravedScene {
  reference: HatchingReference;
  settings: EngravedSettings;
  lights: readonly ReferenceLight[];
  matrixWorld: number[];
  camera: ReferenceCamera;
  /** The width and height of the picture, in pixels. */
  size: number;
  /** The centre of the bounding sphere, in object space. */
  centre: Vec3;
}

/** A function on the object whose level sets are lines. Positions are relative to the centre, in tiles. */
interface LineFunction {
  value(place: Vec3): number;
  gradient(place: Vec3): Vec3;
}

/** The functions whose level sets are the families of an object: the first, and two across it, of which the better one is used. */
interface Families {
  first: LineFunction;
  /** Axes perpendicular to that of the first family and to each other. The crossing lines lean towards one of them. */
  sides: readonly [Vec3, Vec3];
  across: readonly [LineFunction, LineFunction];
  /** The lines that cross it in shadows lean the other way. */
  shadows: readonly [LineFunction, LineFunction];
}

const LUMINANCE: Vec3 = [0.2126, 0.7152, 0.0722];
const dot = (a: Vec3, b: Vec3) => vec3.dot(a, b);
const cross = (a: Vec3, b: Vec3) => vec3.cross([0, 0, 0], a, b) as Vec3;
const unit = (a: Vec3) => vec3.normalize([0, 0, 0], a) as Vec3;
const turned = (a: Vec3, m: mat3) => vec3.transformMat3([0, 0, 0], a, m) as Vec3;
const mixed = (a: Vec3, s: number, b: Vec3, t: number) => a.map((x, i) => s * x + t * b[i]) as Vec3;
const clamp01 = (x: number) => Math.min(1, Math.max(0, x));
const smoothly = (from: number, to: number, x: number) => {
  const t = clamp01((x - from) / (to - from));
  return t * t * (3 - 2 * t);
};

const alongAxis = (axis: Vec3): LineFunction => ({ value: (place) => dot(place, axis), gradient: () => axis });

/** How much nearer a point light is to the position than to the centre; with a sign of −1 how much farther. */
const towardsLamp = (lamp: Vec3, sign: number): LineFunction => ({
  value: (place) => sign * (vec3.length(lamp) - vec3.distance(place, lamp)),
  gradient: (place) => mixed(unit(mixed(lamp, 1, place, -1)), sign, lamp, 0),
});

const combined = (a: LineFunction, s: number, b: LineFunction, t: number): LineFunction => ({
  value: (place) => s * a.value(place) + t * b.value(place),
  gradient: (place) => mixed(a.gradient(place), s, b.gradient(place), t),
});

/** The convention for an axis perpendicular to another: it uses the world's up direction, unless the axis is nearly parallel to it. */
const axisAcross = (axis: Vec3): Vec3 => unit(cross(axis, Math.abs(axis[1]) < 0.8 ? [0, 1, 0] : [0, 0, 1]));

/** The principal axis of Σ w L Lᵀ, in object space, pointing where the lights together point. */
export function principalAxis(lights: readonly { toLight: Vec3; weight: number }[]): Vec3 {
  let axis: Vec3 = [0.51, 0.64, 0.57];
  for (let step = 0; step < 200; step++) {
    const next: Vec3 = [0, 0, 0];
    for (const { toLight, weight } of lights) vec3.scaleAndAdd(next, next, toLight, weight * dot(toLight, axis));
    axis = unit(next);
  }
  const sum: Vec3 = [0, 0, 0];
  for (const { toLight, weight } of lights) vec3.scaleAndAdd(sum, sum, toLight, weight);
  return dot(axis, sum) < 0 ? (axis.map((x) => -x) as Vec3) : axis;
}

/**
 * The direction of the lights from the centre, and the reciprocal of the distance of the point light that represents them, in tiles. Its
 * function approximates the second derivatives of the mean of the lights' functions. Without lights the direction is up.
 */
function lightOf({ lights, matrixWorld, centre, settings }: EngravedScene): { axis: Vec3; bend: number } {
  const toObject = mat4.invert(mat4.create(), matrixWorld as unknown as mat4)!;
  const linear = mat3.fromMat4(mat3.create(), toObject);
  const seen = lights.flatMap(({ type, position, target = [0, 0, 0], color }) => {
    const weight = dot(color, LUMINANCE);
    if (type === 'directional') {
      return [{ toLight: unit(turned(mixed(position!, 1, target, -1), linear)), weight, nearness: 0 }];
    }
    if (type !== 'point' && type !== 'spot') return [];
    const inObject = vec3.transformMat4([0, 0, 0], position!, toObject) as Vec3;
    const toLamp = mixed(inObject, settings.tilesPerUnit, centre, -settings.tilesPerUnit);
    return [{ toLight: unit(toLamp), weight, nearness: 1 / vec3.length(toLamp) }];
  });
  if (seen.length === 0) return { axis: [0, 1, 0], bend: 0 };
  const axis = principalAxis(seen);
  const mean: Vec3 = [0, 0, 0];
  let bend = 0;
  for (const { toLight, weight, nearness } of seen) {
    const counts = weight * dot(toLight, axis);
    vec3.scaleAndAdd(mean, mean, toLight, counts);
    bend += counts * nearness;
  }
  return { axis, bend: bend / vec3.length(mean) };
}

/** With `isDark` no light arrives, and lines run across their axis. */
function familiesOf(scene: EngravedScene, isDark: boolean): Families {
  const { lineField, crossAngle, strokeRotation } = scene.settings;
  if (lineField === 'form' || lineField === 'acrossForm') throw new Error('familiesOf: the form has no axis.');
  const axes = { x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1], slant: [0.48, 0.64, 0.6] } as const;
  const light = lightOf(scene);
  const { axis: toLight, bend } = isDark ? { axis: axisAcross(light.axis), bend: 0 } : light;
  // Towards the light is a quarter turn from the tangent to it.
  const angle = strokeRotation + (lineField === 'towards' ? Math.PI / 2 : 0);
  const isOfLight = lineField === 'light' || lineField === 'towards';
  const axis: Vec3 = isOfLight
    ? mixed(toLight, Math.cos(angle), axisAcross(toLight), Math.sin(angle))
    : [...axes[lineField]];
  const turnedBend = isOfLight ? bend * Math.cos(angle) : 0;
  const isLamp = Math.abs(turnedBend) > 1e-9;
  const first = isLamp ? towardsLamp(axis.map((x) => x / turnedBend) as Vec3, Math.sign(turnedBend)) : alongAxis(axis);
  const sides = [axisAcross(axis), cross(axis, axisAcross(axis))] as const;
  const leaning = (angle: number) =>
    sides.map((side) => combined(first, Math.cos(angle), alongAxis(side), Math.sin(angle))) as [
      LineFunction,
      LineFunction,
    ];
  return { first, sides, across: leaning(crossAngle), shadows: leaning(-crossAngle) };
}

/**
 * The number of pixels that two directions of the tangent plane take on the screen, from the derivatives of the whole projection. From
 * this follows the length of the screen gradient of any function.
 */
class ScreenPlane {
  private readonly tangents: [Vec3, Vec3];
  private readonly pixels: [[number, number], [number, number]];
  private readonly area: number;
  private readonly viewToObject: mat3;

  constructor({ matrixWorld, camera, size }: EngravedScene, place: Vec3, normal: Vec3) {
    const objectToView = mat4.multiply(mat4.create(), camera.view as unknown as mat4, matrixWorld as unknown as mat4);
    this.viewToObject = mat3.invert(mat3.create(), mat3.fromMat4(mat3.create(), objectToView))!;
    const q = vec3.transformMat4([0, 0, 0], place, objectToView) as Vec3;
    const n = unit(turned(normal, mat3.transpose(mat3.create(), this.viewToObject)));
    // Any two tangents work.
    const start: Vec3 = Math.abs(n[2]) < 0.7 ? [0, 0, 1] : [1, 0, 0];
    const e = unit(mixed(start, 1, n, -dot(start, n)));
    this.tangents = [e, cross(n, e)];
    const p = camera.projection;
    const clip = (row: number, v: Vec3, w: number) =>
      p[row] * v[0] + p[4 + row] * v[1] + p[8 + row] * v[2] + p[12 + row] * w;
    const depth = clip(3, q, 1);
    // The quotient rule: x/w changes by (dx − x/w · dw)/w.
    const moved = (row: number, v: Vec3) =>
      ((clip(row, v, 0) - (clip(row, q, 1) / depth) * clip(3, v, 0)) / depth) * (size / 2);
    this.pixels = this.tangents.map((t) => [moved(0, t), moved(1, t)]) as [[number, number], [number, number]];
    const [[a, b], [c, d]] = this.pixels;
    const faceOn = (p[5] * size) / 2 / depth;
    // The slant is limited: the area on the screen counts as at least 0.12 of the area face on.
    this.area = Math.max(Math.abs(a * d - b * c), 0.12 * faceOn ** 2);
  }

  /** Units of the function per pixel. gradient: in object space. */
  gradientLength(gradient: Vec3): number {
    return Math.hypot(...this.gradient(gradient));
  }

  /** Units of one function per pixel along the lines of another. */
  rateAlong(place: Vec3, lines: Vec3): number {
    const [[a, b], [c, d]] = [this.gradient(place), this.gradient(lines)];
    return Math.abs(a * d - b * c) / Math.hypot(c, d);
  }

  private gradient(gradient: Vec3): [number, number] {
    const inView = turned(gradient, mat3.transpose(mat3.create(), this.viewToObject));
    const [along, aside] = this.tangents.map((t) => dot(t, inView)) as [number, number];
    // Solves s · pixels(t) = gradient · t for both tangents, by Cramer's rule.
    const [[a, b], [c, d]] = this.pixels;
    return [(along * d - b * aside) / this.area, (a * aside - along * c) / this.area];
  }
}

/** The share of a pixel that a line of this width covers, at a distance from its middle. Thin lines become paler instead of thinner. */
function lineShare(away: number, width: number): number {
  const half = Math.max(width, 1) / 2;
  const overlap = Math.min(half, away + 0.5) - Math.max(-half, away - 0.5);
  return Math.max(overlap, 0) * Math.min(width, 1);
}

/** A number in [0, 1) of the line at a value: the upper 24 bits of the value in single precision, times the golden ratio. */
export function lotOf(value: number): number {
  const [bits] = new Uint32Array(Float32Array.of(value).buffer);
  const spread = BigInt.asUintN(32, BigInt(bits) * 0x9e3779b9n);
  return Number(spread >> 8n) / 2 ** 24;
}

/** A factor on the width of the line at a value. */
export const lineFactor = (value: number, handmade: number): number => 1 + handmade * (0.5 * lotOf(value) - 0.25);

/**
 * The position along the lines: two coordinates, in tiles, and the weight of the first; the length of strokes, and the share of those
 * twice as long.
 */
interface Along {
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

/** Strokes are measured along those two axes along which the lines run most. Their lengths are powers of two. */
function alongLines(
  place: Vec3,
  normal: Vec3,
  gradient: Vec3,
  plane: ScreenPlane,
  { strokeLength, sizedOnScreen, tilesPerUnit }: EngravedSettings,
): Along {
  const direction = unit(cross(normal, gradient));
  const least = [0, 1, 2].reduce((best, i) => (direction[i] ** 2 < direction[best] ** 2 ? i : best), 0);
  // In the order of a shader, which has no list: z takes the place of the axis that is left out.
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

/** The number of a line, but for its sign: the same on both sides of a seam. */
const numberOf = (line: number, repeat: number): number =>
  repeat < Infinity ? line - repeat * Math.round(line / repeat) : line;

/** What a pen does at a fragment, on all lines. */
interface PenState {
  tone: number;
  handmade: number;
  along: Along;
  repeat: number;
}

/** The mean over lots from 0 to `all` of a ramp that begins at the lot and ends a `growth` later. */
const grown = (tone: number, all: number, growth: number): number => {
  const untilNow = (x: number) => (x <= 0 ? 0 : x < growth ? (x * x) / 2 / growth : x - growth / 2);
  return (untilNow(tone) - untilNow(tone - all)) / all;
};

/** A number in [0, 1) of a stroke. */
function lotOfStroke(line: number, middle: number): number {
  const [a, b] = new Uint32Array(Float32Array.of(Math.abs(line), middle).buffer);
  let spread = (Math.imul(a, 0x9e3779b9) ^ Math.imul(b, 0x85ebca6b)) >>> 0;
  spread = Math.imul(spread ^ (spread >>> 15), 0x2c1b3c6d) >>> 0;
  return (spread >>> 8) / 2 ** 24;
}

/** The width of the strokes on a line, as a share of the room of an old one, and how far they stray, in distances between lines. */
function penStroke(line: number, share: number, { tone, handmade, along, repeat }: PenState): [number, number] {
  const open = (1 - tone) ** 2;
  const full = tone / Math.max(grown(tone, 0.2, 0.05) * (1 - (0.15 + 0.3) * open), 1e-4);
  const number = numberOf(line, repeat);
  const last = 1 - share;
  const born =
    share < 0.04 ? Math.sqrt(0.16 * share) : last > 0.04 ? share + 0.04 : 1.08 - Math.sqrt(Math.max(0.16 * last, 0));
  const fract = (x: number) => x - Math.floor(x);
  const one = (place: number, period: number): [number, number] => {
    const at = place / period + lotOf(Math.abs(number));
    const stroke = Math.floor(at) + 0.5;
    const lot = lotOfStroke(number, stroke);
    const way = 2 * (at - stroke);
    const rest = clamp01(1 - (1 - Math.abs(way) - open * 0.3 * fract(64 * lot)) / Math.max(open * 0.9, 1e-3));
    const there = clamp01((tone - 0.2 * lot) / 0.05) * clamp01((born - fract(512 * lot)) / 0.08);
    const spread = 1 + handmade * 0.5 * open * (fract(4096 * lot) - 0.5);
    const astray = 0.22 * (fract(64 * lot) - 0.5) * way + 0.16 * (lot - 0.5) * (0.5 - way * way);
    return [full * there * spread * (1 - rest * rest), handmade * open * Math.sign(number) * astray];
  };
  const mix = (a: [number, number], b: [number, number], t: number): [number, number] => [
    (1 - t) * a[0] + t * b[0],
    (1 - t) * a[1] + t * b[1],
  ];
  const [first, second] = along.places.map((place) =>
    mix(one(place, along.period), one(place, 2 * along.period), along.longer),
  );
  return mix(second, first, along.share);
}

/** A row of wedges of length 1: each rises from −1 to 1 over 0.7 of its length, and falls over the rest. */
function gouge(x: number): number {
  const t = x - Math.floor(x);
  return t < 0.7 ? (2 * t) / 0.7 - 1 : (2 * (1 - t)) / 0.3 - 1;
}

/** The share of its room that the cut of a line takes. */
function cutShare(line: number, white: number, { places, share, period, longer }: Along, repeat: number): number {
  const rarer = Math.min(white, 1 - white);
  const swell = Math.min(0.42, 1.3 * rarer);
  const lot = lotOf(Math.abs(numberOf(line, repeat)));
  const mixed = (a: number, b: number, t: number) => (1 - t) * a + t * b;
  const flattened = (t: number) => Math.hypot(t, 1 - t);
  const waves = places.map((place) => {
    const wedges = place / period;
    return mixed(gouge(wedges + lot), gouge(wedges / 2 + lot), longer);
  });
  const wave = mixed(waves[1], waves[0], share) / (flattened(longer) * flattened(share));
  // This makes the mean over all waves the wanted one.
  const middleFor = (rare: number) => (rare < swell ? Math.sqrt(4 * swell * rare) - swell : rare);
  const middle = white < 0.5 ? middleFor(white) : 1 - middleFor(1 - white);
  return clamp01(middle + swell * wave);
}

/** The logarithm to base 2, linear between powers of two, and its inverse. */
const octaveOf = (x: number): number => {
  const whole = Math.floor(Math.log2(x));
  return whole + x / 2 ** whole - 1;
};
const powerOf = (octave: number): number => 2 ** Math.floor(octave) * (1 + octave - Math.floor(octave));

/** The function of a family at a fragment. */
interface Ruled {
  value: number;
  perPixel: number;
  rise: number;
  /** How far apart its lines may lie. */
  widest: number;
}

/** Values of the form change by multiples of 4 across seams, those of the crossing lines by multiples of 2. Lines lie no further apart. */
const FORM_WIDEST: readonly number[] = [4, 2];

/** The darkness of a family: of all lines, in all octaves, that may lie on the pixel. */
function ruledDarkness(
  { value, perPixel, rise, widest }: Ruled,
  tone: number,
  settings: EngravedSettings,
  along: Along,
): number {
  const { lineSpacing, sizedOnScreen, handmade, form } = settings;
  const onObject = octaveOf((lineSpacing / 256) * rise);
  const onScreen = octaveOf(lineSpacing * perPixel);
  const asked = powerOf((1 - sizedOnScreen) * onObject + sizedOnScreen * onScreen);
  // Where white or black is rare, rows of wedges lie up to four times as far apart.
  const rare = Math.max(Math.min(tone, 1 - tone), 1e-4);
  const rarer = settings.medium === 'woodcut' ? Math.min(2, Math.max(0, octaveOf(0.24 / rare))) : 0;
  const wanted = Math.min(powerOf(octaveOf(Math.max(asked, 3 * perPixel)) + rarer), widest);
  // The smallest power of two that is not below the wanted spacing, in tiles: the distance of old lines.
  const period = 2 ** Math.ceil(Math.log2(wanted));
  const shares = { old: wanted / period, young: 1 - wanted / period };
  const pixels = period / perPixel;
  const nearest = Math.round(value / period);
  const shareOf = (line: number): number =>
    settings.medium === 'woodcut'
      ? cutShare(line, 1 - tone, along, widest)
      : tone * (form ? 1 : lineFactor(line, handmade));
  let covered = 0;
  const pen = { tone, handmade, along, repeat: widest };
  for (let line = nearest - 2; line <= nearest + 2; line += 0.5) {
    const isOld = Number.isInteger(line);
    if (settings.medium === 'pen') {
      const [share, astray] = penStroke(line * period, isOld ? 1 : shares.young / shares.old, pen);
      const away = (value - line * period) / perPixel - shares.old * pixels * astray;
      covered += lineShare(Math.abs(away), shares.old * pixels * share);
      continue;
    }
    const width = (isOld ? shares.old : shares.young) * pixels * shareOf(line * period);
    covered += lineShare(Math.abs(value - line * period) / perPixel, width);
  }
  return settings.medium === 'woodcut' ? 1 - Math.min(covered, 1) : Math.min(covered, 1);
}

/** Two parabolas instead of a sine of period 2: up from −1 to 0, down from 0 to 1. */
const wave = (x: number): number => {
  const t = 2 * (x / 2 - Math.floor(x / 2)) - 1;
  return t < 0 ? 4 * t * (-t - 1) : 4 * t * (t - 1);
};

/** Three slow waves about a place. */
function slowWaves([x, y, z]: Vec3): Vec3 {
  const a = x + 0.7 * wave(0.54 * y + 0.1);
  const b = y + 0.7 * wave(0.54 * z + 0.67);
  const c = z + 0.7 * wave(0.54 * x + 1.4);
  return [wave(0.73 * c + 0.35), wave(0.73 * a + 1.18), wave(0.73 * b + 1.66)];
}

/** The position that the hand moves a position to, in tiles, and its pressure there. */
function hand(
  place: Vec3,
  { handmade }: EngravedSettings,
): {
  strayed: Vec3;
  pressure: number;
  /** How much wider lines that follow the form are here. */
  widening: number;
} {
  const waves = slowWaves(place.map((c) => 3.5 * c) as Vec3);
  const strayed = mixed(place, 1, waves, 0.012 * handmade);
  return { strayed, pressure: 0.3 * handmade * waves[0] * waves[1], widening: 0.25 * handmade * waves[2] };
}

/**
 * The tones of the first family, of those that cross it and of those that cross these. Above crossFrom the first takes 0.4 of the tone, a
 * pen's 0.6. The others cover the excess that it leaves blank; shares of blank multiply. A pen's third has what the second leaves.
 */
function sharedOut(
  tone: number,
  crossFrom: number,
  has: number,
  medium: EngravedSettings['medium'],
): [number, number, number] {
  const kept = medium === 'pen' ? 0.6 : 0.4;
  const taken = (all: number, from: number) => (all <= from ? all : from + kept * (all - from));
  const first = has * taken(tone, crossFrom);
  const others = 1 - (1 - tone) / (1 - first);
  if (medium !== 'pen') return [first, others, 0];
  const second = taken(others, 0.375);
  return [first, second, 1 - (1 - others) / (1 - second)];
}

export class EngravedReference {
  private readonly families = new Map<string, Families>();

  constructor(private readonly scene: EngravedScene) {}

  /**
   * Darkness at one fragment.
   *
   * @param place - in object space.
   * @param normal - the normal for the lines, of any length, in object space.
   * @param toneNormal - the normal for the tone, of any length, in world space.
   */
  darkness(place: Vec3, normal: Vec3, toneNormal: Vec3): number {
    const { reference, settings, centre } = this.scene;
    const world = reference.toWorld(place);
    const lit = unit(toneNormal);
    const tone = reference.tone(world, lit);
    const own = settings.shadowStrokes === 'cross' ? reference.tone(world, lit, false) : tone;
    const { tilesPerUnit, crossFrom } = settings;
    const fromCentre = mixed(place, tilesPerUnit, centre, -tilesPerUnit);
    const n = unit(normal);
    const plane = new ScreenPlane(this.scene, place, n);
    if (tone >= 1) return 1;
    if (settings.form) return this.formDarkness(fromCentre, n, plane, own, tone, this.arrivingAt(world, lit).isDark);
    const { strayed, pressure } = hand(fromCentre, settings);
    const { first, sides, across, shadows } = this.familiesAt(world, lit);

    // Where the surface lies in a level set of the first family, this family has no lines.
    const slope = vec3.length(cross(n, first.gradient(strayed)));
    const has = smoothly(0.06, 0.18, slope);
    // Squares of the sines at which the lines of the two cross those of the first.
    const axis = cross(...sides);
    const [b, c] = sides.map((side) => dot(n, cross(axis, side)) ** 2);
    const share = 1 + has * (smoothly(-0.35, 0.35, (b - c) / Math.max(slope ** 2, 1e-4)) - 1);
    /** The shares that two families leave blank, so that both together leave the wanted share. */
    const leftByBoth = (two: readonly [LineFunction, LineFunction], blank: number) => {
      const blankB = 1 + share * (blank - 1);
      return leftBy(two[0], 1 - blankB, 0.4) * leftBy(two[1], 1 - blank / blankB, 0.4);
    };
    const leftBy = (family: LineFunction, familyTone: number, familySlope: number) => {
      if (familyTone <= 1e-4 && family !== first) return 1;
      const pressed = familyTone + pressure * familyTone * (1 - familyTone);
      const perPixel = tilesPerUnit * plane.gradientLength(family.gradient(strayed));
      const along = alongLines(fromCentre, n, family.gradient(strayed), plane, settings);
      const ruled = {
        value: family.value(strayed),
        perPixel,
        rise: Math.min(familySlope / 0.4, 1),
        widest: Infinity,
      };
      return 1 - ruledDarkness(ruled, pressed, settings, along);
    };
    const [firstTone, second, third] = sharedOut(own, crossFrom, has, settings.medium);
    const leftByOwn = leftBy(first, firstTone, slope) * leftByBoth(across, 1 - second) * leftByBoth(shadows, 1 - third);
    return 1 - leftByOwn * leftByBoth(shadows, (1 - tone) / (1 - own));
  }

  /**
   * Lines that follow the form: the second function crosses the first, their difference both in shadows, and where no light arrives
   * they change places.
   */
  private formDarkness(
    fromCentre: Vec3,
    normal: Vec3,
    plane: ScreenPlane,
    own: number,
    tone: number,
    isDark: boolean,
  ): number {
    const { settings } = this.scene;
    const { form, lineField, tilesPerUnit, crossFrom } = settings;
    const { strayed, pressure, widening } = hand(fromCentre, settings);
    const stray = mixed(strayed, 1, fromCentre, -1);
    const both = form!.map((quadratic, i) => {
      const gradient = quadraticGradient(quadratic, fromCentre);
      return { gradient, value: quadraticAt(quadratic, fromCentre) + dot(gradient, stray), widest: FORM_WIDEST[i] };
    });
    const [first, crossing] = isDark !== (lineField === 'acrossForm') ? both.toReversed() : both;
    const other = {
      gradient: mixed(first.gradient, 1, crossing.gradient, -1),
      value: first.value - crossing.value,
      widest: Math.min(...FORM_WIDEST),
    };
    const leftBy = (family: typeof first, familyTone: number) => {
      if (familyTone <= 1e-4 && family !== first) return 1;
      const pressed = familyTone + (pressure + widening) * familyTone * (1 - familyTone);
      const perPixel = tilesPerUnit * plane.gradientLength(family.gradient);
      const rise = vec3.length((family === first ? first : crossing).gradient);
      const along = alongLines(fromCentre, normal, family.gradient, plane, settings);
      return 1 - ruledDarkness({ ...family, perPixel, rise }, pressed, settings, along);
    };
    const [firstTone, second, third] = sharedOut(own, crossFrom, 1, settings.medium);
    const leftByOwn = leftBy(first, firstTone) * leftBy(crossing, second) * leftBy(other, third);
    return 1 - leftByOwn * leftBy(other, 1 - (1 - tone) / (1 - own));
  }

  /** The lights that arrive at the position, and whether none of those that have a direction does. */
  private arrivingAt(world: Vec3, toneNormal: Vec3): { arriving: ReferenceLight[]; isDark: boolean } {
    const { lights, reference } = this.scene;
    const arriving = lights.filter((light) => !reference.turnsAway(light, toneNormal, world));
    const isDark = arriving.length < lights.length && !arriving.some(({ type }) => DIRECTED.includes(type));
    return { arriving, isDark };
  }

  private familiesAt(world: Vec3, toneNormal: Vec3): Families {
    const { lights } = this.scene;
    const { arriving, isDark } = this.arrivingAt(world, toneNormal);
    const key = `${isDark} ${lights.map((light) => arriving.includes(light))}`;
    const known = this.families.get(key);
    if (known) return known;
    const families = familiesOf({ ...this.scene, lights: isDark ? lights : arriving }, isDark);
    this.families.set(key, families);
    return families;
  }
}

const DIRECTED: readonly ReferenceLight['type'][] = ['directional', 'point', 'spot'];
