/**
 * The technique `engraved` at one fragment, in double precision, as documented: level sets of functions of the place, octaves of
 * a ruler, ink by shares of pixels, families printed over one another, the hand. Shares no code with the shader.
 */
import { mat3, mat4, vec3 } from 'gl-matrix';
import type { HatchingReference, ReferenceLight } from './hatchingReference.js';
import type { ReferenceCamera } from './rasterizeReference.js';
import type { Vec3 } from './referenceAdjacency.js';

export interface EngravedSettings {
  /** Radians. */
  strokeRotation: number;
  lineField: 'light' | 'towards' | 'x' | 'y' | 'z';
  lineSpacing: number;
  crossFrom: number;
  crossAngle: number;
  handmade: number;
  screenConstancy: number;
  strokeScale: number;
  /** Default: false. */
  carved?: boolean;
  /** Default: 'tone'. */
  shadowStrokes?: 'tone' | 'cross' | 'reorient';
}

export interface EngravedScene {
  reference: HatchingReference;
  settings: EngravedSettings;
  lights: readonly ReferenceLight[];
  matrixWorld: number[];
  camera: ReferenceCamera;
  /** Of the picture in pixels; it is square. */
  size: number;
  /** Of the bounding sphere, object space. */
  centre: Vec3;
}

/** A function on the object whose level sets are lines. Places count from its centre, all in tiles. */
interface LineFunction {
  value(place: Vec3): number;
  gradient(place: Vec3): Vec3;
}

/** The functions whose level sets are the families of an object: the first, and two across it, of which the better one is used. */
interface Families {
  first: LineFunction;
  /** Axes across that of the first and across each other; what crosses leans towards one of them. */
  sides: readonly [Vec3, Vec3];
  across: readonly [LineFunction, LineFunction];
  /** What shadows cross it by leans the other way. */
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

/** How much nearer a lamp is than to the centre; or farther, with a sign of −1. */
const towardsLamp = (lamp: Vec3, sign: number): LineFunction => ({
  value: (place) => sign * (vec3.length(lamp) - vec3.distance(place, lamp)),
  gradient: (place) => mixed(unit(mixed(lamp, 1, place, -1)), sign, lamp, 0),
});

const combined = (a: LineFunction, s: number, b: LineFunction, t: number): LineFunction => ({
  value: (place) => s * a.value(place) + t * b.value(place),
  gradient: (place) => mixed(a.gradient(place), s, b.gradient(place), t),
});

/** The convention for an axis across another: by the world's up unless the axis itself comes near it. */
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
 * The direction of the lights from the centre, and one over the distance of the lamp that stands for them, in tiles: the second
 * derivatives of the mean of the lights' own functions are those of its function, as far as one number can say. Without
 * lights, up.
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
    const toLamp = mixed(inObject, settings.strokeScale, centre, -settings.strokeScale);
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

/** isDark: no light arrives, and lines run across their axis. */
function familiesOf(scene: EngravedScene, isDark: boolean): Families {
  const { lineField, crossAngle, strokeRotation } = scene.settings;
  const axes = { x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1] } as const;
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
 * How many pixels the tangent plane at a place takes along two of its directions, from the derivatives of the whole
 * projection; from it the length of the screen gradient of any function.
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
    // Any two will do.
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
    // A surface that leans away further than 0.12 of face on counts as if it did not.
    this.area = Math.max(Math.abs(a * d - b * c), 0.12 * faceOn ** 2);
  }

  /** Units of the function per pixel. gradient: in object space. */
  gradientLength(gradient: Vec3): number {
    const inView = turned(gradient, mat3.transpose(mat3.create(), this.viewToObject));
    const [along, aside] = this.tangents.map((t) => dot(t, inView)) as [number, number];
    // Solves s · pixels(t) = gradient · t for both tangents, by Cramer's rule.
    const [[a, b], [c, d]] = this.pixels;
    return Math.hypot(along * d - b * aside, a * aside - along * c) / this.area;
  }
}

/** The share of a pixel, so far from the middle of a line across it, that ink of this width takes; thin lines pale instead. */
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

/** Where along its lines a place is: by two coordinates, in tiles, and how much the first of them counts. */
interface Along {
  places: readonly [number, number];
  share: number;
}

/** A wedge of length 1 after another: up from −1 to 1 over 0.7 of it, and down. */
function gouge(x: number): number {
  const t = x - Math.floor(x);
  return t < 0.7 ? (2 * t) / 0.7 - 1 : (2 * (1 - t)) / 0.3 - 1;
}

/** How much of its room the cut of a line takes, where old lines lie so far apart and new ones have grown by so much. */
function cutShare(line: number, white: number, { places, share }: Along, period: number, into: number): number {
  const swell = 0.42;
  const lot = lotOf(line);
  const longer = smoothly(0.2, 0.8, into);
  const mixed = (a: number, b: number, t: number) => (1 - t) * a + t * b;
  const flattened = (t: number) => Math.hypot(t, 1 - t);
  const waves = places.map((place) => {
    const wedges = place / (11 * period);
    return mixed(gouge(wedges + lot), gouge(2 * wedges + lot), longer);
  });
  const wave = mixed(waves[1], waves[0], share) / (flattened(longer) * flattened(share));
  // So that the mean over all waves is what is asked for.
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

/** The darkness of one family: every line of a ruler with octaves that may lie on the pixel. slope: on the surface. */
function ruledDarkness(
  value: number,
  perPixel: number,
  slope: number,
  tone: number,
  settings: EngravedSettings,
  along: Along,
): number {
  const { lineSpacing, screenConstancy, handmade } = settings;
  const onObject = octaveOf((lineSpacing / 256) * Math.min(slope / 0.4, 1));
  const onScreen = octaveOf(lineSpacing * perPixel);
  const asked = powerOf((1 - screenConstancy) * onObject + screenConstancy * onScreen);
  const wanted = Math.max(asked, 3 * perPixel);
  // The smallest power of two that is not below the wanted spacing, in tiles: the distance of old lines.
  const period = 2 ** Math.ceil(Math.log2(wanted));
  const shares = { old: wanted / period, young: 1 - wanted / period };
  const pixels = period / perPixel;
  const nearest = Math.round(value / period);
  const shareOf = (line: number): number =>
    settings.carved ? cutShare(line, 1 - tone, along, period, 2 * shares.young) : tone * lineFactor(line, handmade);
  let covered = 0;
  for (let line = nearest - 2; line <= nearest + 2; line += 0.5) {
    const width = (Number.isInteger(line) ? shares.old : shares.young) * pixels * shareOf(line * period);
    covered += lineShare(Math.abs(value - line * period) / perPixel, width);
  }
  return settings.carved ? 1 - Math.min(covered, 1) : Math.min(covered, 1);
}

/** Two parabolas in the place of a sine of period 2: up from −1 to 0, down from 0 to 1. */
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

/** Where the hand puts a place, in tiles, and how much it presses there. */
function hand(place: Vec3, { handmade }: EngravedSettings): { strayed: Vec3; pressure: number } {
  const waves = slowWaves(place.map((c) => 3.5 * c) as Vec3);
  return { strayed: mixed(place, 1, waves, 0.012 * handmade), pressure: 0.3 * handmade * waves[0] * waves[1] };
}

export class EngravedReference {
  private readonly families = new Map<string, Families>();

  constructor(private readonly scene: EngravedScene) {}

  /**
   * Darkness at one fragment.
   *
   * @param place - in object space.
   * @param normal - that lines go by, in object space. Of any length, as the next.
   * @param toneNormal - that tone goes by, in world space.
   */
  darkness(place: Vec3, normal: Vec3, toneNormal: Vec3): number {
    const { reference, settings, centre } = this.scene;
    const world = reference.toWorld(place);
    const lit = unit(toneNormal);
    const tone = reference.tone(world, lit);
    const own = settings.shadowStrokes === 'cross' ? reference.tone(world, lit, false) : tone;
    const { strokeScale, crossFrom } = settings;
    const fromCentre = mixed(place, strokeScale, centre, -strokeScale);
    const { strayed, pressure } = hand(fromCentre, settings);
    const n = unit(normal);
    const plane = new ScreenPlane(this.scene, place, n);
    const { first, sides, across, shadows } = this.familiesAt(world, lit);

    // Where the surface lies in a level set of the first family, that has no lines.
    const slope = vec3.length(cross(n, first.gradient(strayed)));
    const has = smoothly(0.06, 0.18, slope);
    // Squares of the sines at which the lines of the two cross those of the first.
    const axis = cross(...sides);
    const [b, c] = sides.map((side) => dot(n, cross(axis, side)) ** 2);
    const share = 1 + has * (smoothly(-0.35, 0.35, (b - c) / Math.max(slope ** 2, 1e-4)) - 1);
    /** What two families leave blank that together leave as much as they are asked to. */
    const leftByBoth = (two: readonly [LineFunction, LineFunction], blank: number) => {
      const blankB = 1 + share * (blank - 1);
      return leftBy(two[0], 1 - blankB, 1) * leftBy(two[1], 1 - blank / blankB, 1);
    };
    const leftBy = (family: LineFunction, familyTone: number, familySlope: number) => {
      if (familyTone <= 1e-4 && family !== first) return 1;
      const pressed = familyTone + pressure * familyTone * (1 - familyTone);
      const perPixel = strokeScale * plane.gradientLength(family.gradient(strayed));
      const along: Along =
        family === first
          ? {
              places: sides.map((side) => dot(strayed, side)) as [number, number],
              share: smoothly(-0.35, 0.35, (b - c) / Math.max(slope ** 2, 1e-4)),
            }
          : { places: [first.value(strayed), first.value(strayed)], share: 1 };
      return 1 - ruledDarkness(family.value(strayed), perPixel, familySlope, pressed, settings, along);
    };
    if (tone >= 1) return 1;
    // Above crossFrom it takes 0.4 of the tone; what it leaves blank too much the others cover, by the law of products.
    const firstTone = has * (own <= crossFrom ? own : crossFrom + 0.4 * (own - crossFrom));
    const leftByOwn = leftBy(first, firstTone, slope) * leftByBoth(across, (1 - own) / (1 - firstTone));
    return 1 - leftByOwn * leftByBoth(shadows, (1 - tone) / (1 - own));
  }

  /** Those of the lights that arrive there. */
  private familiesAt(world: Vec3, toneNormal: Vec3): Families {
    const { lights, reference } = this.scene;
    const arriving = lights.filter((light) => !reference.turnsAway(light, toneNormal, world));
    const isDark = arriving.length < lights.length && !arriving.some(({ type }) => DIRECTED.includes(type));
    const key = `${isDark} ${lights.map((light) => arriving.includes(light))}`;
    const known = this.families.get(key);
    if (known) return known;
    const families = familiesOf({ ...this.scene, lights: isDark ? lights : arriving }, isDark);
    this.families.set(key, families);
    return families;
  }
}

const DIRECTED: readonly ReferenceLight['type'][] = ['directional', 'point', 'spot'];
