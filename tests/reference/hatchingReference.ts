/**
 * Algorithms 1, 2 and 3 of Suarez, Belhadj and Boyer, "GPU real time hatching", 2013, one fragment at a time, in double
 * precision and without a graphics card. Written from the paper and from the conventions in the documentation; shares no
 * code with the shader. Several lights: structure tensor of their directions. Radiance: as three documents its lights.
 */
import { glMatrix, mat3, type mat4, vec3 } from 'gl-matrix';
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
  /** Distance at which the light ends; 0 never. */
  distance?: number;
  decay?: number;
  /** Spot: half angle of the cone in radians, and the share of it that fades. */
  angle?: number;
  penumbra?: number;
}

export interface ReferenceMaterial {
  technique: 'triangle' | 'adjacency' | 'anchored';
  toneModel: 'lambert' | 'halfLambert' | 'phong' | 'toon';
  toneSteps: number;
  shininess: number;
  toneNormal: 'face' | 'smooth';
  strokeScale: number;
  strokeRotation: number;
  strokeOffset: [number, number];
  creaseAngle: number;
  ink: Vec3;
  paper: Vec3;
  color: Vec3;
}

/** Darkness ∈ [0, 1] of hatch image `tone` at (u, v), in tiles. */
export type HatchImageFunction = (tone: number, u: number, v: number) => number;

export interface ReferenceScene {
  matrixWorld: number[];
  /** World position of the eye; for an orthographic camera, the world direction towards it. */
  eye: Vec3;
  orthographic?: boolean;
  lights: ReferenceLight[];
  material: ReferenceMaterial;
  tones: number;
  image: HatchImageFunction;
}

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
  /** What arrives, linear RGB. */
  color: Vec3;
}

/** What a light sends to a world position. Attenuation and cone as three documents them. */
function incident(light: ReferenceLight, at: Vec3): Incident | null {
  if (light.type === 'ambient' || light.type === 'hemisphere') return null;
  const axis = normalize(subtract(light.position!, light.target ?? [0, 0, 0]));
  if (light.type === 'directional') return { direction: axis, color: light.color };
  const toLight = subtract(light.position!, at);
  const length = vec3.length(toLight);
  const direction = normalize(toLight);
  let strength = 1 / Math.max(length ** (light.decay ?? 2), 0.01);
  if (light.distance) strength *= clamp01(1 - (length / light.distance) ** 4) ** 2;
  if (light.type === 'spot') {
    const outer = Math.cos(light.angle!);
    const inner = Math.cos(light.angle! * (1 - (light.penumbra ?? 0)));
    const x = clamp01((dot(direction, axis) - outer) / (inner - outer || Number.EPSILON));
    strength *= x * x * (3 - 2 * x);
  }
  return { direction, color: scale(light.color, strength) };
}

/** Per scene, everything that does not depend on the fragment. */
export class HatchingReference {
  readonly #scene: ReferenceScene;
  readonly #normalMatrix: number[];
  readonly #worldToObjectLinear: number[];
  readonly #frames = new Map<string, { tangent: Vec3; bitangent: Vec3 }>();

  constructor(scene: ReferenceScene) {
    this.#scene = scene;
    const world = scene.matrixWorld as unknown as mat4;
    const linear = mat3.fromMat4(mat3.create(), world);
    const inverse = mat3.invert(mat3.create(), linear)!;
    this.#worldToObjectLinear = [...inverse];
    this.#normalMatrix = [...mat3.transpose(mat3.create(), inverse)];
  }

  toWorld(p: Vec3): Vec3 {
    return vec3.transformMat4([0, 0, 0], p, this.#scene.matrixWorld as unknown as mat4) as Vec3;
  }

  normalToWorld(n: Vec3): Vec3 {
    return normalize(vec3.transformMat3([0, 0, 0], n, this.#normalMatrix as unknown as mat3) as Vec3);
  }

  /** Algorithm 1: T and B of a triangle, object space. */
  frame(triangle: Triangle): { tangent: Vec3; bitangent: Vec3 } {
    const id = triangle.flat().join(',');
    const known = this.#frames.get(id);
    if (known) return known;
    const n = faceNormal(triangle);
    const centre = scale(
      vec3.add([0, 0, 0], vec3.add([0, 0, 0], triangle[0], triangle[1]), triangle[2]) as Vec3,
      1 / 3,
    );
    const frame = this.frameOfNormal(n, this.toWorld(centre));
    this.#frames.set(id, frame);
    return frame;
  }

  /** T and B for a unit object-space normal, lit as at a world position. */
  frameOfNormal(n: Vec3, worldPosition: Vec3): { tangent: Vec3; bitangent: Vec3 } {
    const bitangent = this.#bitangent(n, worldPosition);
    return { tangent: cross(bitangent, n), bitangent };
  }

  #bitangent(n: Vec3, worldCentre: Vec3): Vec3 {
    const axis = [0, 1, 2].reduce((least, i) => (Math.abs(n[i]!) < Math.abs(n[least]!) ? i : least), 0);
    const unit: Vec3 = [0, 0, 0];
    unit[axis] = 1;
    const e1 = normalize(subtract(unit, scale(n, dot(n, unit))));
    const e2 = cross(n, e1);
    let [q, r, x, y, weights] = [0, 0, 0, 0, 0];
    const directed = this.#scene.lights.filter((light) => incident(light, worldCentre) !== null);
    const skies = this.#scene.lights.filter((light) => light.type === 'hemisphere');
    for (const light of directed.length > 0 ? directed : skies) {
      const arriving = incident(light, worldCentre) ?? { direction: normalize(light.position!), color: light.color };
      const toLight = normalize(
        vec3.transformMat3([0, 0, 0], arriving.direction, this.#worldToObjectLinear as unknown as mat3) as Vec3,
      );
      const lx = dot(toLight, e1);
      const ly = dot(toLight, e2);
      const w = luminance(arriving.color) * Math.max(dot(toLight, n) + 0.05, 0) + 1e-4 * luminance(light.color);
      q += w * (lx * lx - ly * ly);
      r += w * 2 * lx * ly;
      x += w * lx;
      y += w * ly;
      weights += w;
    }
    if (!(Math.hypot(q, r) > 1e-8 * weights)) return e1;
    const angle = Math.atan2(r, q) / 2;
    const sign = x * Math.cos(angle) + y * Math.sin(angle) < 0 ? -1 : 1;
    return vec3.scaleAndAdd([0, 0, 0], scale(e1, sign * Math.cos(angle)), e2, sign * Math.sin(angle)) as Vec3;
  }

  /** Texture coordinates of an object-space point in the frame of a triangle: project (Algorithm 2), then measure. */
  coordinates(point: Vec3, triangle: Triangle): [number, number] {
    const { strokeScale, strokeRotation, strokeOffset } = this.#scene.material;
    const n = faceNormal(triangle);
    const projected = subtract(point, scale(n, dot(subtract(point, triangle[0]), n)));
    const { tangent, bitangent } = this.frame(triangle);
    const s = dot(projected, tangent);
    const t = dot(projected, bitangent);
    const cos = Math.cos(strokeRotation);
    const sin = Math.sin(strokeRotation);
    return [(s * cos - t * sin) * strokeScale + strokeOffset[0], (s * sin + t * cos) * strokeScale + strokeOffset[1]];
  }

  /** Section 3.4: tone of a world position with a world normal. */
  tone(position: Vec3, n: Vec3): number {
    const { lights, material, eye, orthographic } = this.#scene;
    const view = orthographic ? normalize(eye) : normalize(subtract(eye, position));
    let radiance = 0;
    for (const light of lights) {
      if (light.type === 'ambient') radiance += luminance(light.color) / Math.PI;
      if (light.type === 'hemisphere') {
        const sky = 0.5 * dot(n, normalize(light.position!)) + 0.5;
        const mixed = light.color.map((c, i) => c * sky + light.groundColor![i]! * (1 - sky)) as Vec3;
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
      radiance += (luminance(arriving.color) / Math.PI) * response;
    }
    const tone = 1 - clamp01(radiance);
    if (material.toneModel !== 'toon') return tone;
    const last = Math.max(material.toneSteps - 1, 1);
    return Math.floor(tone * last + 0.5) / last;
  }

  /** Darkness of the hatch in one frame: the two neighbouring hatch images, interpolated by tone. */
  #hatch(uv: [number, number], tone: number): number {
    const x = tone * (this.#scene.tones - 1);
    const lower = Math.min(Math.floor(x), this.#scene.tones - 1);
    const upper = Math.min(lower + 1, this.#scene.tones - 1);
    const share = x - lower;
    return (1 - share) * this.#scene.image(lower, ...uv) + share * this.#scene.image(upper, ...uv);
  }

  /**
   * Algorithms 2 and 3 at the point b0·V0 + b1·V1 + b2·V2 of `triangle`, whose neighbours across V0V1, V1V2, V2V0 are
   * given. `smoothNormal` in object space is used where tone is to be smooth. Returns linear RGB.
   */
  shade(
    triangle: Triangle,
    neighbours: readonly (Triangle | null)[],
    barycentric: Vec3,
    faceDirection: number,
    smoothNormal: Vec3,
  ): Vec3 {
    const { material } = this.#scene;
    const point: Vec3 = [0, 1, 2].map(
      (axis) =>
        barycentric[0] * triangle[0][axis]! + barycentric[1] * triangle[1][axis]! + barycentric[2] * triangle[2][axis]!,
    ) as Vec3;
    const world = this.toWorld(point);
    const central = faceNormal(triangle);
    const shades = [{ t: triangle, n: central, f: 1 }];
    if (material.technique === 'adjacency') {
      const k = Math.cos(material.creaseAngle);
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
    let darkness = 0;
    let sum = 0;
    for (const { t, n, f } of shades) {
      const toneNormal = this.normalToWorld(material.toneNormal === 'smooth' ? smoothNormal : n);
      const tone = this.tone(world, scale(toneNormal, faceDirection));
      darkness += f * this.#hatch(this.coordinates(point, t), tone);
      sum += f;
    }
    darkness /= sum;
    const { ink, paper, color } = material;
    return [0, 1, 2].map((i) => paper[i]! * color[i]! * (1 - darkness) + ink[i]! * darkness) as Vec3;
  }
}
