/**
 * The technique `engraved` at one fragment, in double precision, as documented: level sets of functions of the place, octaves of
 * a ruler, ink by shares of pixels, families printed over one another, the hand. Shares no code with the shader.
 */
import { mat3, mat4, vec3 } from 'gl-matrix';
import type { HatchingReference, ReferenceLight } from './hatchingReference.js';
import type { ReferenceCamera } from './rasterizeReference.js';
import type { Vec3 } from './referenceAdjacency.js';

export interface EngravedSettings {
  lineField: 'light' | 'towards' | 'x' | 'y' | 'z';
  lineSpacing: number;
  crossFrom: number;
  crossAngle: number;
  handmade: number;
  screenConstancy: number;
  strokeScale: number;
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

/** A function on object space whose level sets are lines. Places count from the centre of the object. */
interface LineFunction {
  value(place: Vec3): number;
  gradient(place: Vec3): Vec3;
}

/** What the families of one object are cut by: the first, and two across it, of which a place takes what crosses better. */
interface Families {
  first: LineFunction;
  across: readonly [LineFunction, LineFunction];
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

/** Directional lights; without any, up. */
function lightAxis({ lights, matrixWorld }: EngravedScene): Vec3 {
  const toObject = mat3.invert(mat3.create(), mat3.fromMat4(mat3.create(), matrixWorld as unknown as mat4))!;
  const directed = lights.filter(({ type }) => type === 'directional');
  if (directed.length === 0) return [0, 1, 0];
  return principalAxis(
    directed.map(({ position, target = [0, 0, 0], color }) => ({
      toLight: unit(turned(mixed(position!, 1, target, -1), toObject)),
      weight: dot(color, LUMINANCE),
    })),
  );
}

function familiesOf(scene: EngravedScene): Families {
  const { lineField, crossAngle } = scene.settings;
  const axes = { x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1] } as const;
  const axis: Vec3 =
    lineField === 'light'
      ? lightAxis(scene)
      : lineField === 'towards'
        ? axisAcross(lightAxis(scene))
        : [...axes[lineField]];
  const side = axisAcross(axis);
  const leaning = (towards: Vec3) => alongAxis(mixed(axis, Math.cos(crossAngle), towards, Math.sin(crossAngle)));
  return { first: alongAxis(axis), across: [leaning(side), leaning(cross(axis, side))] };
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

/** A factor on the width of the line at a value: an integer hash of its bits in single precision. */
export function lineFactor(value: number, handmade: number): number {
  const bits = new Uint32Array(Float32Array.of(value).buffer)[0];
  let h = Math.imul(bits, 0x9e3779b9);
  h ^= h >>> 16;
  h = Math.imul(h, 0x7feb352d);
  h ^= h >>> 15;
  // The upper 24 bits as a number in [−1, 1).
  return 1 + 0.25 * handmade * ((h >>> 8) / 2 ** 23 - 1);
}

/** The darkness of one family: every line of a ruler with octaves that may lie on the pixel. */
function ruledDarkness(value: number, perPixel: number, tone: number, settings: EngravedSettings): number {
  const { lineSpacing, strokeScale, screenConstancy, handmade } = settings;
  const spacingOnObject = lineSpacing / (256 * strokeScale);
  const wanted = spacingOnObject ** (1 - screenConstancy) * (lineSpacing * perPixel) ** screenConstancy;
  // The smallest power of two that is not below the wanted spacing, in the function's units: the distance of old lines.
  const period = 2 ** Math.ceil(Math.log2(wanted));
  const shares = { old: wanted / period, young: 1 - wanted / period };
  const pixels = period / perPixel;
  const nearest = Math.round(value / period);
  let ink = 0;
  for (let line = nearest - 2; line <= nearest + 2; line += 0.5) {
    const width =
      tone * (Number.isInteger(line) ? shares.old : shares.young) * pixels * lineFactor(line * period, handmade);
    ink += lineShare(Math.abs(value - line * period) / perPixel, width);
  }
  const isResolved = smoothly(2, 3.2, wanted / perPixel);
  return (1 - isResolved) * tone + isResolved * Math.min(ink, 1);
}

/** Three slow waves about a place. */
function slowWaves([x, y, z]: Vec3): Vec3 {
  const a = x + 0.7 * Math.sin(1.7 * y + 0.3);
  const b = y + 0.7 * Math.sin(1.7 * z + 2.1);
  const c = z + 0.7 * Math.sin(1.7 * x + 4.4);
  return [Math.sin(2.3 * c + 1.1), Math.sin(2.3 * a + 3.7), Math.sin(2.3 * b + 5.2)];
}

/** Where the hand puts a place, and how much it presses there. */
function hand(place: Vec3, { handmade, strokeScale }: EngravedSettings): { strayed: Vec3; pressure: number } {
  const strayed = mixed(
    place,
    1,
    slowWaves(place.map((c) => 3 * strokeScale * c) as Vec3),
    (0.012 * handmade) / strokeScale,
  );
  const [a, b] = slowWaves(place.map((c) => 5 * strokeScale * c + 7) as Vec3);
  return { strayed, pressure: 0.45 * handmade * a * b };
}

/** The sine of the angle at which the lines of two functions cross on a surface. */
function sineBetween(a: Vec3, b: Vec3, normal: Vec3): number {
  const lineOf = (gradient: Vec3) => unit(cross(normal, gradient));
  return vec3.length(cross(lineOf(a), lineOf(b)));
}

export class EngravedReference {
  private readonly families: Families;

  constructor(private readonly scene: EngravedScene) {
    this.families = familiesOf(scene);
  }

  /**
   * Darkness at one fragment.
   *
   * @param place - in object space.
   * @param normal - that lines go by, in object space. Of any length, as the next.
   * @param toneNormal - that tone goes by, in world space.
   */
  darkness(place: Vec3, normal: Vec3, toneNormal: Vec3): number {
    const { reference, settings, centre } = this.scene;
    const tone = reference.tone(reference.toWorld(place), unit(toneNormal));
    if (tone >= 1) return 1;
    const fromCentre = mixed(place, 1, centre, -1);
    const { strayed, pressure } = hand(fromCentre, settings);
    const plane = new ScreenPlane(this.scene, place, unit(normal));
    const { first, across } = this.families;

    // Above crossFrom the first takes 0.4 of the tone; what it leaves blank too much the others cover, by the law of products.
    const firstTone = tone <= settings.crossFrom ? tone : settings.crossFrom + 0.4 * (tone - settings.crossFrom);
    const stillBlank = (1 - tone) / (1 - firstTone);
    const gradient = (family: LineFunction) => family.gradient(fromCentre);
    const [b, c] = across.map((family) => sineBetween(gradient(first), gradient(family), normal) ** 2);
    const share = smoothly(-0.35, 0.35, b - c);
    const blank = [
      [first, 1 - firstTone],
      [across[0], stillBlank ** share],
      [across[1], stillBlank ** (1 - share)],
    ] as const;
    return (
      1 -
      blank.reduce((product, [family, left]) => {
        const familyTone = 1 - left;
        if (familyTone <= 0) return product;
        const pressed = familyTone + pressure * familyTone * (1 - familyTone);
        const perPixel = plane.gradientLength(gradient(family));
        return product * (1 - ruledDarkness(family.value(strayed), perPixel, pressed, settings));
      }, 1)
    );
  }
}
