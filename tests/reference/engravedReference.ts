/**
 * The technique `engraved` at one fragment, in double precision, by its documentation: level sets of functions of the position, octaves of
 * lines, ink as shares of pixels, families printed over one another, and the hand. Shares no code with the shader.
 */
import { mat3, mat4, vec3 } from 'gl-matrix';
import { type Along, alongLines, cutShare, lineFactor, octaveOf, penStroke, powerOf } from './engravedStrokes.js';
import type { HatchingReference, ReferenceLight } from './hatchingReference.js';
import type { ReferenceCamera } from './rasterizeReference.js';
import type { Vec3 } from './referenceAdjacency.js';
import { ScreenPlane } from './ScreenPlane.js';
import { cross, dot, mixed, smoothly, turned, unit } from './vectors.js';

export interface EngravedSettings {
  /** Radians. */
  strokeRotation: number;
  lineField: 'light' | 'towards' | 'x' | 'y' | 'z' | 'slant' | 'form' | 'acrossForm';
  /** For the last two: the functions whose level sets are lines, and those of the crossing lines. */
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

/** The functions of the families of lines: the first, and two across it, of which the better one is used. */
interface Families {
  first: LineFunction;
  /** Axes perpendicular to that of the first family and to each other, which crossing lines lean towards. */
  sides: readonly [Vec3, Vec3];
  across: readonly [LineFunction, LineFunction];
  /** The lines in shadows halve the wider angle between the first family and those that cross it. */
  shadows: readonly [LineFunction, LineFunction];
}

const LUMINANCE: Vec3 = [0.2126, 0.7152, 0.0722];

const alongAxis = (axis: Vec3): LineFunction => ({ value: (place) => dot(place, axis), gradient: () => axis });

/** Distance of a lamp from the centre minus that from the position, times a sign. */
const towardsLamp = (lamp: Vec3, sign: number): LineFunction => ({
  value: (place) => sign * (vec3.length(lamp) - vec3.distance(place, lamp)),
  gradient: (place) => mixed(unit(mixed(lamp, 1, place, -1)), sign, lamp, 0),
});

const combined = (a: LineFunction, s: number, b: LineFunction, t: number): LineFunction => ({
  value: (place) => s * a.value(place) + t * b.value(place),
  gradient: (place) => mixed(a.gradient(place), s, b.gradient(place), t),
});

/** The axis across another: perpendicular to the world's up, unless the axis is nearly parallel to it. */
const axisAcross = (axis: Vec3): Vec3 => unit(cross(axis, Math.abs(axis[1]) < 0.8 ? [0, 1, 0] : [0, 0, 1]));

/** The principal axis of Σ w L Lᵀ, object space, with the sign of the lights' sum. */
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
 * Direction of the lights from the centre, and reciprocal of the distance of the lamp that stands for them, in tiles. Its function
 * approximates the second derivatives of the mean of the lights' functions. Without lights the direction is up.
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

/** The families of lines. If `isDark`, no light arrives and lines run across their axis. */
function familiesOf(scene: EngravedScene, isDark: boolean): Families {
  const { lineField, crossAngle, strokeRotation } = scene.settings;
  if (lineField === 'form' || lineField === 'acrossForm') throw new Error('familiesOf: the form has no axis.');
  const axes = { x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1], slant: [0.48, 0.64, 0.6] } as const;
  const light = lightOf(scene);
  const { axis: toLight, bend } = isDark ? { axis: axisAcross(light.axis), bend: 0 } : light;
  // Fields towards the light are a quarter turn from the tangent to it.
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
  return { first, sides, across: leaning(crossAngle), shadows: leaning(crossAngle / 2 - Math.PI / 2) };
}

/** The share of a pixel that a line covers, by the distance from its middle. Thin lines become paler instead of thinner. */
function lineShare(away: number, width: number): number {
  const half = Math.max(width, 1) / 2;
  const overlap = Math.min(half, away + 0.5) - Math.max(-half, away - 0.5);
  return Math.max(overlap, 0) * Math.min(width, 1);
}

/** The function of a family at a fragment. */
interface Ruled {
  value: number;
  perPixel: number;
  /** As `perPixel`, on the flat triangle. */
  seen: number;
  rise: number;
  /** The widest spacing of its lines. */
  widest: number;
}

/** Values of the form change by multiples of 4 across seams, those of crossing lines by multiples of 2. Lines lie no further apart. */
const FORM_WIDEST: readonly number[] = [4, 2];

/** The darkness of a family: the sum over all lines, of all octaves, that may touch the pixel. */
function ruledDarkness(
  { value, perPixel: bySmooth, seen: onTriangle, rise, widest }: Ruled,
  tone: number,
  settings: EngravedSettings,
  along: Along,
): number {
  const { lineSpacing, sizedOnScreen, handmade, form } = settings;
  const onObject = octaveOf((lineSpacing / 256) * rise);
  const seen = Math.max(onTriangle, bySmooth / 16);
  // At most 1.5 times, and at least 1/1.5 times, the change on the triangle.
  const perPixel = Math.min(Math.max(bySmooth, seen / 1.5), 1.5 * seen);
  const onScreen = octaveOf(lineSpacing * perPixel);
  const asked = powerOf((1 - sizedOnScreen) * onObject + sizedOnScreen * onScreen);
  // Where white or black is rare, rows of wedges lie up to four times as far apart.
  const rare = Math.max(Math.min(tone, 1 - tone), 1e-4);
  const rarer = settings.medium === 'woodcut' ? Math.min(2, Math.max(0, octaveOf(0.24 / rare))) : 0;
  const wanted = Math.min(powerOf(octaveOf(Math.max(asked, 3 * perPixel)) + rarer), widest);
  // The smallest power of two not below the wanted spacing, in tiles: the spacing of old lines.
  const period = 2 ** Math.ceil(Math.log2(wanted));
  const shares = { old: wanted / period, young: 1 - wanted / period };
  const pixels = period / seen;
  const nearest = Math.round(value / period);
  const shareOf = (line: number): number =>
    settings.medium === 'woodcut'
      ? cutShare(line, 1 - tone, along, widest, octaveOf(wanted))
      : tone * (form ? 1 : lineFactor(line, handmade));
  let covered = 0;
  const pen = { tone, handmade, along, repeat: widest, octave: octaveOf(wanted) };
  for (let line = nearest - 2; line <= nearest + 2; line += 0.5) {
    const isOld = Number.isInteger(line);
    if (settings.medium === 'pen') {
      const [share, astray] = penStroke(line * period, isOld ? 1 : shares.young / shares.old, pen);
      const away = (value - line * period) / seen - shares.old * pixels * astray;
      covered += lineShare(Math.abs(away), shares.old * pixels * share);
      continue;
    }
    const width = (isOld ? shares.old : shares.young) * pixels * shareOf(line * period);
    covered += lineShare(Math.abs(value - line * period) / seen, width);
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

/** The position displaced by the hand, in tiles, and the pressure there. */
function hand(
  place: Vec3,
  { handmade }: EngravedSettings,
): {
  strayed: Vec3;
  pressure: number;
  /** Factor on the width of lines that follow the form, minus 1. */
  widening: number;
} {
  const waves = slowWaves(place.map((c) => 3.5 * c) as Vec3);
  const strayed = mixed(place, 1, waves, 0.012 * handmade);
  return { strayed, pressure: 0.3 * handmade * waves[0] * waves[1], widening: 0.25 * handmade * waves[2] };
}

/**
 * The tones of the first family, of those that cross it and of those that cross these. Above crossFrom the first takes 0.4 of the excess,
 * 0.6 with a pen. The others share the rest; shares of blank multiply. A pen's third family has what the second leaves.
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
   * @param flatNormal - the normal of the triangle, of any length, in object space; the smooth one where there are no triangles.
   * @param isPlane - whether the corners of the triangle have one normal.
   */
  darkness(place: Vec3, normal: Vec3, toneNormal: Vec3, flatNormal: Vec3 = normal, isPlane = false): number {
    const { reference, settings, centre } = this.scene;
    const world = reference.toWorld(place);
    const lit = unit(toneNormal);
    const tone = reference.tone(world, lit, true, isPlane);
    const own = settings.shadowStrokes === 'cross' ? reference.tone(world, lit, false, isPlane) : tone;
    const { tilesPerUnit, crossFrom } = settings;
    const fromCentre = mixed(place, tilesPerUnit, centre, -tilesPerUnit);
    const n = unit(normal);
    const plane = new ScreenPlane(this.scene, place, n);
    const triangle = new ScreenPlane(this.scene, place, unit(flatNormal));
    if (tone >= 1) return 1;
    if (settings.form)
      return this.formDarkness(fromCentre, n, { plane, triangle }, own, tone, this.arrivingAt(world, lit).isDark);
    const { strayed, pressure } = hand(fromCentre, settings);
    const { first, sides, across, shadows } = this.familiesAt(world, lit);

    // Where the surface lies in a level set of the first family, that family has no lines.
    const slope = vec3.length(cross(n, first.gradient(strayed)));
    const has = smoothly(0.06, 0.18, slope);
    // Squared sines of the angles at which lines of the two cross those of the first.
    const axis = cross(...sides);
    const [b, c] = sides.map((side) => dot(n, cross(axis, side)) ** 2);
    const better = smoothly(-0.35, 0.35, (b - c) / Math.max(slope ** 2, 1e-4));
    /**
     * The blank that each of two families leaves, so that both together leave the wanted one. Without a first family, those in shadows take
     * the other side.
     */
    const leftByBoth = (two: readonly [LineFunction, LineFunction], blank: number) => {
      const share = has * better + (two === across ? 1 - has : 0);
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
        seen: tilesPerUnit * triangle.gradientLength(family.gradient(strayed)),
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
   * Lines that follow the form: the second function crosses the first, and their difference both in shadows. Where no light arrives they
   * change places.
   */
  private formDarkness(
    fromCentre: Vec3,
    normal: Vec3,
    { plane, triangle }: { plane: ScreenPlane; triangle: ScreenPlane },
    own: number,
    tone: number,
    isDark: boolean,
  ): number {
    const { settings } = this.scene;
    const { form, lineField, tilesPerUnit, crossFrom } = settings;
    const { strayed, pressure, widening } = hand(fromCentre, settings);
    const stray = mixed(strayed, 1, fromCentre, -1);
    // Strokes of a pen and cuts of a gouge have variations of their own.
    const press = settings.medium === 'pen' || settings.medium === 'woodcut' ? pressure : pressure + widening;
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
      const pressed = familyTone + press * familyTone * (1 - familyTone);
      const perPixel = tilesPerUnit * plane.gradientLength(family.gradient);
      const rise = vec3.length((family === first ? first : crossing).gradient);
      const along = alongLines(fromCentre, normal, family.gradient, plane, settings);
      const seen = tilesPerUnit * triangle.gradientLength(family.gradient);
      return 1 - ruledDarkness({ ...family, perPixel, seen, rise }, pressed, settings, along);
    };
    const [firstTone, second, third] = sharedOut(own, crossFrom, 1, settings.medium);
    const leftByOwn = leftBy(first, firstTone) * leftBy(crossing, second) * leftBy(other, third);
    return 1 - leftByOwn * leftBy(other, 1 - (1 - tone) / (1 - own));
  }

  /** The lights that arrive at a position, and whether none with a direction does. */
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
