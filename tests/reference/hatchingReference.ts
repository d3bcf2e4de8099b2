/**
 * Algorithms 1, 2 and 3 of Suarez, Belhadj and Boyer, "GPU real time hatching", 2013, one fragment at a time, in double precision and
 * without a GPU. Written from the article and the documentation, without code of the shader. Several lights are combined by the structure
 * tensor of their directions; radiance follows the documentation of three.js.
 */
import { glMatrix, mat3, type mat4, vec3, vec4 } from 'gl-matrix';
import { normalDistribution } from './normalDistribution.js';
import type { Triangle, Vec3 } from './referenceAdjacency.js';

glMatrix.setMatrixArrayType(Array as unknown as Float32ArrayConstructor);

export interface ReferenceLight {
  type: 'ambient' | 'directional' | 'point' | 'spot' | 'hemisphere';
  /** Linear RGB times intensity. */
  color: Vec3;
  /** hemisphere: linear RGB times intensity from below. */
  groundColor?: Vec3;
  /** World space: where a point or spot light is; for directional and spot light shines from here towards `target`. */
  position?: Vec3;
  target?: Vec3;
  /** Distance at which the light ends; 0 for no limit. */
  distance?: number;
  decay?: number;
  /** Spot: half angle of the cone in radians, and the share of it that fades. */
  angle?: number;
  penumbra?: number;
  /** Whether something blocks the light for the whole object. */
  isBlocked?: boolean;
}

export interface ReferenceMaterial {
  technique: 'triangle' | 'adjacency' | 'hatching' | 'engraving';
  toneModel: 'lambert' | 'halfLambert' | 'phong' | 'toon';
  toneSteps: number;
  shininess: number;
  toneNormal: 'face' | 'smooth';
  tilesPerObjectUnit: number;
  strokeAngle: number;
  strokeOffset: [number, number];
  blendAngle: number;
  toneCurve: 'linear' | 'perceptual' | [number, number][];
  reflectedLight: number;
  strokeLayers: 'single' | 'lights' | 'tone';
  crossFrom: number;
  crossAngle: number;
  /** Default: 'tone'. */
  shadowStrokes?: 'tone' | 'cross' | 'reorient';
  /** Whether thresholds are blended and compared once, instead of blending greys. */
  sharpInk: boolean;
  levelRule: 'derivatives' | 'depth';
  inkBlend: 'cover' | 'multiply';
  ink: Vec3;
  paper: Vec3;
  color: Vec3;
  colorHatching: number;
  colorFill: number;
  /** Factor on the light. Default: 1. */
  exposure?: number;
  /** How much tone fades with depth, view units. Default: none. */
  depthFade?: number;
  depthFadeStart?: number;
  depthFadeEnd?: number;
  /** A point in the world. Tone falls off from one radius around it to 2.5. */
  focus?: Vec3;
  focusRadius?: number;
  /** How much tone falls off towards the rim of the picture. */
  vignette?: number;
}

/** Darkness ∈ [0, 1] of hatch image `tone` at (u, v), in tiles, on a level. */
export type HatchImageFunction = (tone: number, u: number, v: number, level: number) => number;

export interface ReferenceScene {
  matrixWorld: number[];
  /** World position of the eye; for an orthographic camera, the world direction towards it. */
  eye: Vec3;
  orthographic?: boolean;
  /** For depth, and for positions on the picture. */
  camera?: { view: number[]; projection: number[] };
  /** Importance of the object. Default: 1. */
  importance?: number;
  lights: ReferenceLight[];
  material: ReferenceMaterial;
  tones: number;
  image: HatchImageFunction;
  /** For the level by depth: texels per side and levels of the map, and world units per pixel at a world position. */
  size?: number;
  levels?: number;
  unitsPerPixel?: (at: Vec3) => number;
}

/** Offset of a layer's pattern from that of the layer before, in tiles or anchors. */
export const LAYER_SHIFT: Vec3 = [17.37, 5.71, 11.13];

/** One of the layers of strokes that are printed over one another. */
export interface ReferenceLayer {
  tone: number;
  /** Angle of its strokes to those of the first layer, counter-clockwise. */
  angle: number;
}

/** The tone of the layer that others cross: 0.4 of the tone above `crossFrom` stays with it. */
const kept = (tone: number, from: number) => (tone > from ? from + 0.4 * (tone - from) : tone);
/** The tone that, printed over one tone, gives another. */
const missing = (tone: number, printed: number) => 1 - (1 - tone) / (1 - printed);

const LUMINANCE: Vec3 = [0.2126729, 0.7151522, 0.072175];
const luminance = (rgb: Vec3) => rgb[0] * LUMINANCE[0] + rgb[1] * LUMINANCE[1] + rgb[2] * LUMINANCE[2];
const subtract = (a: Vec3, b: Vec3) => vec3.subtract([0, 0, 0], a, b) as Vec3;
const scale = (a: Vec3, s: number) => vec3.scale([0, 0, 0], a, s) as Vec3;
const cross = (a: Vec3, b: Vec3) => vec3.cross([0, 0, 0], a, b) as Vec3;
const dot = (a: Vec3, b: Vec3) => vec3.dot(a, b);
const normalize = (a: Vec3) => vec3.normalize([0, 0, 0], a) as Vec3;
const clamp01 = (x: number) => Math.min(1, Math.max(0, x));

/** Algorithm 1, line 1. */
export function faceNormal([v0, v1, v2]: Triangle): Vec3 {
  return normalize(cross(subtract(v1, v0), subtract(v2, v0)));
}

interface Incident {
  /** Unit, towards the light, world space. */
  direction: Vec3;
  /** The light that arrives, linear RGB. */
  color: Vec3;
  /** The light that would arrive without a cone. */
  coneless: Vec3;
}

const smoothly = (from: number, to: number, x: number) => {
  const t = clamp01((x - from) / (to - from));
  return t * t * (3 - 2 * t);
};

/** The irregularity of a hand-drawn edge by the place, 12 % at most. */
function uneven(p: Vec3): number {
  const bent = (along: Vec3, by: number, other: Vec3, phase = 0) =>
    Math.sin(dot(p, along) + by * Math.sin(dot(p, other)) + phase);
  return 0.12 * (0.65 * bent([4.3, 3.1, -3.7], 1.6, [-2.9, 5.3, 4.1]) + 0.35 * bent([-11, 13, 9], 1.3, [7, -5, 6], 2));
}

/** CIE lightness of a luminance, both in [0, 1]. */
function lightness(y: number): number {
  return (y > (6 / 29) ** 3 ? 116 * Math.cbrt(y) - 16 : (29 / 3) ** 3 * y) / 100;
}

/** A monotone curve through points by Hermite cubics, with the slopes of Fritsch and Butland; constant outside. */
function curveThrough(points: readonly [number, number][], x: number): number {
  const last = points.length - 1;
  if (x <= points[0][0]) return points[0][1];
  if (x >= points[last][0]) return points[last][1];
  const secant = (i: number) => (points[i + 1][1] - points[i][1]) / (points[i + 1][0] - points[i][0]);
  const slope = (i: number) => {
    if (i === 0) return secant(0);
    if (i === last) return secant(last - 1);
    const [before, after] = [secant(i - 1), secant(i)];
    if (Math.sign(before) * Math.sign(after) <= 0) return 0;
    const alpha = (1 + (points[i + 1][0] - points[i][0]) / (points[i + 1][0] - points[i - 1][0])) / 3;
    return (before * after) / (alpha * after + (1 - alpha) * before);
  };
  const i = points.findIndex((_, k) => x < points[k + 1][0]);
  const [[x0, y0], [x1, y1]] = [points[i], points[i + 1]];
  const h = x1 - x0;
  const t = (x - x0) / h;
  return (
    (1 + 2 * t) * (1 - t) ** 2 * y0 +
    t * (1 - t) ** 2 * h * slope(i) +
    t * t * (3 - 2 * t) * y1 -
    t * t * (1 - t) * h * slope(i + 1)
  );
}

/** The light at a world position, with attenuation and cone as documented by three.js. */
function incident(light: ReferenceLight, at: Vec3): Incident | null {
  if (light.type === 'ambient' || light.type === 'hemisphere') return null;
  const axis = normalize(subtract(light.position!, light.target ?? [0, 0, 0]));
  if (light.type === 'directional') return { direction: axis, color: light.color, coneless: light.color };
  const toLight = subtract(light.position!, at);
  const length = vec3.length(toLight);
  const direction = normalize(toLight);
  let strength = 1 / Math.max(length ** (light.decay ?? 2), 0.01);
  if (light.distance) strength *= clamp01(1 - (length / light.distance) ** 4) ** 2;
  const coneless = scale(light.color, strength);
  if (light.type === 'spot') {
    const outer = Math.cos(light.angle!);
    const inner = Math.cos(light.angle! * (1 - (light.penumbra ?? 0)));
    const x = clamp01((dot(direction, axis) - outer) / (inner - outer || Number.EPSILON));
    strength *= x * x * (3 - 2 * x);
  }
  return { direction, color: scale(light.color, strength), coneless };
}

/** T and B in object space, and the disagreement of the lights: 1 minus the anisotropy of the structure tensor. */
interface Frame {
  tangent: Vec3;
  bitangent: Vec3;
  crossing: number;
}

/** The values of a scene that do not depend on the fragment. */
export class HatchingReference {
  private readonly scene: ReferenceScene;
  private readonly normalMatrix: number[];
  private readonly worldToObjectLinear: number[];
  private readonly frames = new Map<string, Frame>();

  constructor(scene: ReferenceScene) {
    this.scene = scene;
    const world = scene.matrixWorld as unknown as mat4;
    const linear = mat3.fromMat4(mat3.create(), world);
    const inverse = mat3.invert(mat3.create(), linear)!;
    this.worldToObjectLinear = [...inverse];
    this.normalMatrix = [...mat3.transpose(mat3.create(), inverse)];
  }

  toWorld(p: Vec3): Vec3 {
    return vec3.transformMat4([0, 0, 0], p, this.scene.matrixWorld as unknown as mat4) as Vec3;
  }

  normalToWorld(n: Vec3): Vec3 {
    return normalize(vec3.transformMat3([0, 0, 0], n, this.normalMatrix as unknown as mat3) as Vec3);
  }

  /** From a world position towards the eye, in object space, of any length. */
  toViewer(worldPosition: Vec3): Vec3 {
    const { eye, orthographic } = this.scene;
    const view = orthographic ? eye : subtract(eye, worldPosition);
    return vec3.transformMat3([0, 0, 0], view, this.worldToObjectLinear as unknown as mat3) as Vec3;
  }

  /** Algorithm 1: the frame of a triangle. */
  frame(triangle: Triangle): Frame {
    const id = triangle.flat().join(',');
    const known = this.frames.get(id);
    if (known) return known;
    const n = faceNormal(triangle);
    const centre = scale(
      vec3.add([0, 0, 0], vec3.add([0, 0, 0], triangle[0], triangle[1]), triangle[2]) as Vec3,
      1 / 3,
    );
    const frame = this.frameOfNormal(n, this.toWorld(centre));
    this.frames.set(id, frame);
    return frame;
  }

  /** T and B for a unit object-space normal, lit as at a world position. */
  frameOfNormal(n: Vec3, worldPosition: Vec3): Frame {
    const { bitangent, crossing } = this.bitangent(n, worldPosition);
    return { tangent: cross(bitangent, n), bitangent, crossing };
  }

  private bitangent(n: Vec3, worldCentre: Vec3): { bitangent: Vec3; crossing: number } {
    const axis = [0, 1, 2].reduce((least, i) => (Math.abs(n[i]) < Math.abs(n[least]) ? i : least), 0);
    const unit: Vec3 = [0, 0, 0];
    unit[axis] = 1;
    const e1 = normalize(subtract(unit, scale(n, dot(n, unit))));
    const e2 = cross(n, e1);
    let [q, r, x, y, weights, extent] = [0, 0, 0, 0, 0, 0];
    const directed = this.scene.lights.filter((light) => incident(light, worldCentre) !== null);
    const skies = this.scene.lights.filter((light) => light.type === 'hemisphere');
    for (const light of directed.length > 0 ? directed : skies) {
      let arriving = incident(light, worldCentre) ?? { direction: normalize(light.position!), color: light.color };
      if (this.turnsAway(light, this.normalToWorld(n), worldCentre)) {
        arriving = { direction: normalize(cross(arriving.direction, [0, 1, 0])), color: [0, 0, 0] };
      }
      const toLight = normalize(
        vec3.transformMat3([0, 0, 0], arriving.direction, this.worldToObjectLinear as unknown as mat3) as Vec3,
      );
      const lx = dot(toLight, e1);
      const ly = dot(toLight, e2);
      const w = luminance(arriving.color) * Math.max(dot(toLight, n) + 0.05, 0) + 1e-4 * luminance(light.color);
      q += w * (lx * lx - ly * ly);
      r += w * 2 * lx * ly;
      x += w * lx;
      y += w * ly;
      weights += w;
      extent += w * (lx * lx + ly * ly);
    }
    const crossing = directed.length > 1 && extent > 1e-8 * weights ? 1 - Math.hypot(q, r) / extent : 0;
    if (!(Math.hypot(q, r) > 1e-8 * weights)) return { bitangent: e1, crossing };
    const angle = Math.atan2(r, q) / 2;
    const sign = x * Math.cos(angle) + y * Math.sin(angle) < 0 ? -1 : 1;
    const along = scale(e1, sign * Math.cos(angle));
    return { bitangent: vec3.scaleAndAdd([0, 0, 0], along, e2, sign * Math.sin(angle)) as Vec3, crossing };
  }

  /** Whether strokes turn away from a light in its shadow, which they do above a sine of elevation of 0.05. `n` is in world space. */
  turnsAway(light: ReferenceLight, n: Vec3, at: Vec3): boolean {
    const isAsked = !!light.isBlocked && this.scene.material.shadowStrokes === 'reorient';
    return isAsked && dot(n, incident(light, at)!.direction) > 0.05;
  }

  /** Whether strokes turn away from all lights with a direction. `n` is in world space. */
  isDark(n: Vec3, at: Vec3): boolean {
    const directed = this.scene.lights.filter((light) => incident(light, at) !== null);
    return directed.length > 0 && directed.every((light) => this.turnsAway(light, n, at));
  }

  /** Texture coordinates of an object-space point in the frame of a triangle: project (Algorithm 2), then measure. */
  coordinates(point: Vec3, triangle: Triangle): [number, number] {
    const { tilesPerObjectUnit, strokeAngle, strokeOffset } = this.scene.material;
    const n = faceNormal(triangle);
    const projected = subtract(point, scale(n, dot(subtract(point, triangle[0]), n)));
    const { tangent, bitangent } = this.frame(triangle);
    const s = dot(projected, tangent);
    const t = dot(projected, bitangent);
    const cos = Math.cos(strokeAngle);
    const sin = Math.sin(strokeAngle);
    return [
      (s * cos - t * sin) * tilesPerObjectUnit + strokeOffset[0],
      (s * sin + t * cos) * tilesPerObjectUnit + strokeOffset[1],
    ];
  }

  /** Section 3.4: tone of a world position with a world normal, with the shadows or as if there were none. */
  tone(position: Vec3, n: Vec3, hasShadows = true, isPlane = false): number {
    const { lights, material, eye, orthographic } = this.scene;
    const view = orthographic ? normalize(eye) : normalize(subtract(eye, position));
    let radiance = 0;
    for (const light of lights) {
      if (light.type === 'ambient') radiance += luminance(light.color) / Math.PI;
      if (light.type === 'hemisphere') {
        const sky = 0.5 * dot(n, normalize(light.position!)) + 0.5;
        const mixed = light.color.map((c, i) => c * sky + light.groundColor![i] * (1 - sky)) as Vec3;
        radiance += luminance(mixed) / Math.PI;
      }
      const arriving = incident(light, position);
      if (arriving === null) continue;
      const cosine = dot(n, arriving.direction);
      let response = Math.max(cosine, 0);
      if (material.toneModel === 'halfLambert') response = (cosine / 2 + 0.5) ** 2;
      if (material.toneModel === 'phong' && cosine >= 0) {
        const mirrored = subtract(scale(n, 2 * cosine), arriving.direction);
        response += Math.max(dot(mirrored, view), 0) ** material.shininess;
      }
      if (!light.isBlocked || !hasShadows) radiance += (luminance(arriving.color) / Math.PI) * response;
      // Reflected light is a hemisphere light from the other side.
      let seen = (1 - cosine) / 2;
      const [x, y, z] = arriving.direction;
      // Planes get more of it on the side that they turn to the light.
      const side: Vec3 = [0.8 * y - 0.48 * z, 0.36 * z - 0.8 * x, 0.48 * x - 0.36 * y];
      if (isPlane) seen += 1.2 * Math.max(seen - 0.25, 0) * Math.max(dot(n, normalize(side)), 0);
      radiance += (material.reflectedLight * luminance(arriving.coneless) * seen) / Math.PI;
    }
    // A colour with half the lightness of white brings the tone half way to that of no light, times colorHatching.
    const darkness = material.colorHatching * (1 - lightness(luminance(material.color)));
    const printed =
      (1 - darkness) * this.printedTone((material.exposure ?? 1) * radiance) + darkness * this.printedTone(0);
    return this.fading(position) * printed;
  }

  /** A factor on the tone. */
  private fading(position: Vec3): number {
    const { camera, material, importance = 1 } = this.scene;
    const { depthFade = 0, depthFadeStart = 0, depthFadeEnd = 1, focus, focusRadius = 1, vignette = 0 } = material;
    let left = importance;
    if (focus) {
      const away = scale(subtract(position, focus), 1 / focusRadius);
      left *= 1 - smoothly(1, 2.5, vec3.length(away) * (1 + uneven(away)));
    }
    if (depthFade === 0 && vignette === 0) return left;
    const view = vec4.transformMat4([0, 0, 0, 0], [...position, 1], camera!.view as unknown as mat4);
    // Aerial perspective follows e^(−3 t), scaled to its value at the far end.
    const way = clamp01((-view[2] - depthFadeStart) / (depthFadeEnd - depthFadeStart));
    left *= 1 - (depthFade * Math.expm1(-3 * way)) / Math.expm1(-3);
    const clip = vec4.transformMat4([0, 0, 0, 0], view, camera!.projection as unknown as mat4);
    const [x, y] = [clip[0] / clip[3], clip[1] / clip[3]];
    return left * (1 - vignette * smoothly(0.55, 1, Math.hypot(x, y) * (1 + uneven([2 * x, 2 * y, 0]))));
  }

  /** The printed tone of a white surface's radiance. */
  private printedTone(radiance: number): number {
    const { toneModel, toneSteps, toneCurve } = this.scene.material;
    let tone = 1 - clamp01(radiance);
    if (toneModel === 'toon') {
      const last = Math.max(toneSteps - 1, 1);
      tone = Math.floor(tone * last + 0.5) / last;
    }
    if (toneCurve === 'linear') return tone;
    if (toneCurve === 'perceptual') return 1 - lightness(1 - tone);
    return curveThrough(toneCurve, tone);
  }

  /** The layers of strokes that give a tone together, 1 − T = Π (1 − Tᵢ). */
  layers(tone: number, crossing: number): ReferenceLayer[] {
    const { strokeLayers, crossFrom, crossAngle } = this.scene.material;
    if (strokeLayers === 'lights' && crossing > 0) {
      const blank = Math.max(1 - tone, 1e-3);
      return [
        { tone: 1 - blank ** (1 - crossing / 2), angle: 0 },
        { tone: 1 - blank ** (crossing / 2), angle: Math.PI / 2 },
      ];
    }
    if (strokeLayers !== 'tone') return [{ tone, angle: 0 }];
    // The third layer halves the angle between the second and the reversed first.
    const angles = [0, crossAngle, (crossAngle + Math.PI) / 2];
    const layers = (...tones: number[]) => tones.map((one, i) => ({ tone: one, angle: angles[i] }));
    if (tone <= crossFrom) return layers(tone, 0, 0);
    const first = kept(tone, crossFrom);
    const others = missing(tone, first);
    // The third layer begins half way between the second's tone and 1.
    const thirdFrom = (1 + crossFrom) / 2;
    const second = kept(others, missing(thirdFrom, kept(thirdFrom, crossFrom)));
    return layers(first, second, missing(others, second));
  }

  /**
   * Darkness of the hatch in one frame: the two neighbouring hatch images interpolated by tone, or the nearest under
   * `toon`; each from the two neighbouring levels.
   */
  private hatch([u, v]: readonly [number, number], tone: number, level: number): number {
    const { tones, image, levels = 1 } = this.scene;
    const fine = Math.min(Math.max(level, 0), levels - 1);
    const between = (x: number, last: number, at: (index: number) => number) => {
      const lower = Math.min(Math.floor(x), last);
      return (1 - (x - lower)) * at(lower) + (x - lower) * at(Math.min(lower + 1, last));
    };
    let x = tone * (tones - 1);
    if (this.scene.material.toneModel === 'toon') x = Math.round(x);
    return between(x, tones - 1, (i) => between(fine, levels - 1, (k) => image(i, u, v, k)));
  }

  /** Octaves by which the map is too fine at a world position: texels per pixel, by depth and scale. */
  private level(world: Vec3): number {
    const { size = 1, unitsPerPixel, material } = this.scene;
    if (material.levelRule !== 'depth') return 0;
    const objectPerWorld = Math.cbrt(Math.abs(mat3.determinant(this.worldToObjectLinear as unknown as mat3)));
    return Math.log2(material.tilesPerObjectUnit * size * objectPerWorld * unitsPerPixel!(world));
  }

  /** The values that are blended at the point b0·V0 + b1·V1 + b2·V2 of a triangle with these neighbours. */
  private shades(
    triangle: Triangle,
    neighbours: readonly (Triangle | null)[],
    barycentric: Vec3,
    faceDirection: number,
    smoothNormal: Vec3,
  ) {
    const { material } = this.scene;
    const point: Vec3 = [0, 1, 2].map(
      (axis) =>
        barycentric[0] * triangle[0][axis] + barycentric[1] * triangle[1][axis] + barycentric[2] * triangle[2][axis],
    ) as Vec3;
    const world = this.toWorld(point);
    const central = faceNormal(triangle);
    const shades = [{ t: triangle, n: central, f: 1 }];
    if (material.technique === 'adjacency') {
      const k = Math.cos(material.blendAngle);
      neighbours.forEach((neighbour, edge) => {
        if (neighbour === null) return;
        const n = faceNormal(neighbour);
        const shared = Math.max((dot(central, n) - k) / (1 - k), -1);
        const values: Vec3 = [shared, shared, shared];
        values[(edge + 2) % 3] = -1;
        const f = values[0] * barycentric[0] + values[1] * barycentric[1] + values[2] * barycentric[2];
        shades.push({ t: neighbour, n, f: Math.max(f, 0) });
      });
    }
    const sum = shades.reduce((total, { f }) => total + f, 0);
    const crossing = shades.reduce((total, { t, f }) => total + f * this.frame(t).crossing, 0) / sum;
    const frames = shades.map(({ t, n, f }) => {
      const toneNormal = this.normalToWorld(material.toneNormal === 'smooth' ? smoothNormal : n);
      const tone = this.tone(world, scale(toneNormal, faceDirection), true, material.toneNormal !== 'smooth');
      const [u, v] = this.coordinates(point, t);
      const layers = this.layers(tone, crossing).map((layer, i) => {
        const [cos, sin] = [Math.cos(layer.angle), Math.sin(layer.angle)];
        const place = [u * cos - v * sin + i * LAYER_SHIFT[0], u * sin + v * cos + i * LAYER_SHIFT[1]] as const;
        return { tone: layer.tone, place };
      });
      return { share: f / sum, layers };
    });
    return { world, frames };
  }

  /**
   * Algorithms 2 and 3 at the point b0·V0 + b1·V1 + b2·V2 of `triangle`, whose neighbours across V0V1, V1V2, V2V0 are
   * given. `smoothNormal` in object space is used where tone is to be smooth. Returns linear RGB.
   */
  shade(...at: Parameters<HatchingReference['shades']>): Vec3 {
    const { world, frames } = this.shades(...at);
    const level = this.level(world);
    // Each layer is blended by itself, and then printed over the others.
    const blank = [1, 1, 1];
    for (const { share, layers } of frames) {
      layers.forEach(({ tone, place }, i) => {
        blank[i] -= share * this.hatch(place, tone, level);
      });
    }
    const darkness = 1 - blank[0] * blank[1] * blank[2];
    const { material } = this.scene;
    const { paper, color, colorFill } = material;
    const ground = paper.map((c, i) => c * (1 - colorFill + colorFill * color[i]));
    const stroke = material.ink.map((c, i) => (material.inkBlend === 'multiply' ? c * ground[i] : c));
    return ground.map((c, i) => c * (1 - darkness) + stroke[i] * darkness) as Vec3;
  }

  /**
   * The crisp variant: the amount by which the tone exceeds the threshold, in the layer where it is largest. A positive amount is ink.
   * `field` is Φ⁻¹ of the threshold at (u, v).
   */
  crispExcess(field: (u: number, v: number) => number, ...at: Parameters<HatchingReference['shades']>): number {
    const { frames } = this.shades(...at);
    const blended = (of: (frame: (typeof frames)[number]) => number) =>
      frames.reduce((total, frame) => total + frame.share * of(frame), 0);
    const deviation = Math.sqrt(blended(({ share }) => share));
    const excesses = frames[0].layers.map(
      (_, i) =>
        blended(({ layers }) => layers[i].tone) -
        normalDistribution(blended(({ layers }) => field(...layers[i].place)) / deviation),
    );
    return Math.max(...excesses);
  }
}
