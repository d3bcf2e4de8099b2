import {
  BackSide,
  DoubleSide,
  type InstancedMesh,
  type Material,
  Matrix3,
  Matrix4,
  type Mesh,
  type Object3D,
  type SkinnedMesh,
  Vector3,
} from 'three';
import { relativeOcclusion } from '../../look/relativeOcclusion.js';
import { lightness, luminanceOf, smoothstep } from '../../look/vectors.js';
import type { HatchingMaterialProperties } from '../HatchingMaterialProperties.js';
import { type Arriving, LightsAround } from './LightsAround.js';
import { openToLamps } from './openToLamps.js';
import { colorWriter } from './pixelColors.js';
import { isFittedMaterial, SceneContents } from './SceneContents.js';
import { type SurfaceSamples, surfaceSamples } from './surfaceSamples.js';
import type { ToneFit, ValuePlan } from './ToneFit.js';
import { type Color, WeightedColors } from './WeightedColors.js';
import { WHITE_PLAN } from './writeFit.js';

/** The number of bins: finer than differences of tone that are visible. */
const BINS = 4096;

/** A histogram of weighted numbers from 0 on, and its quantiles. Emptying it keeps its memory. */
export class WeightedValues {
  private values = new Float64Array(1024);
  private weights = new Float64Array(1024);
  private count = 0;
  private readonly bins = new Float64Array(BINS);

  clear(): void {
    this.count = 0;
  }

  get isEmpty(): boolean {
    return this.count === 0;
  }

  /** Adds a value. Values that are not finite or have no weight are left out. */
  add(value: number, weight: number): void {
    if (!(value >= 0 && value < Infinity && weight > 0 && weight < Infinity)) return;
    if (this.count === this.values.length) this.grow();
    this.values[this.count] = value;
    this.weights[this.count++] = weight;
  }

  /**
   * The value below which a share of the weight lies, to 1/4096 of the greatest value; 0 if the histogram is empty.
   *
   * @param share from 0 to 1
   */
  quantile(share: number): number {
    const { bins, values, weights, count } = this;
    let [most, all] = [0, 0];
    for (let i = 0; i < count; i++) {
      if (values[i] > most) most = values[i];
      all += weights[i];
    }
    if (most === 0) return 0;
    bins.fill(0);
    const perValue = (BINS - 1) / most;
    for (let i = 0; i < count; i++) bins[Math.round(values[i] * perValue)] += weights[i];
    const wanted = share * all;
    let sum = 0;
    for (let bin = 0; bin < BINS; bin++) {
      const next = sum + bins[bin];
      if (next >= wanted && next > sum) return Math.max(0, bin - 0.5 + (wanted - sum) / (next - sum)) / perValue;
      sum = next;
    }
    return most;
  }

  private grow(): void {
    const { values, weights } = this;
    this.values = new Float64Array(2 * values.length);
    this.weights = new Float64Array(2 * weights.length);
    this.values.set(values);
    this.weights.set(weights);
  }
}

/** Quantiles of the radiance over a surface that count as its bright and its dark parts. */
const BRIGHT = 0.9;
const DARK = 0.1;
/**
 * The quantile of the colours' lightness that counts as white, and the least lightness that does: nearly black colours do not become
 * white.
 */
const WHITE = 0.9;
const MIN_WHITE = 0.3;
/** The greatest factor by which the contrast of dark to bright is raised, so that a faint difference does not become a coarse one. */
const MAX_CONTRAST = 4;

/**
 * Fits the light that arrives on surfaces to the light that presets are made for, so that bright parts get the same brightness. Light
 * from all around leaves no dark parts: the darkest are then brought down to the wanted darkness. Dark parts are never lifted.
 *
 * The lightest colours, by area, become white, so that a scene of middle greys is not drawn in half tones alone.
 *
 * @param arriving the radiance of the surfaces, by area
 * @param wanted the radiance that it is fitted to: that of a sphere in a single light of intensity π
 * @param lightness the lightness of the surfaces' colours, as far as it becomes tone
 */
export function fitTones(
  arriving: WeightedValues,
  wanted: WeightedValues,
  lightness: WeightedValues,
): Pick<ToneFit, 'scale' | 'offset' | 'white'> {
  const white = lightness.isEmpty ? 1 : Math.min(1, Math.max(MIN_WHITE, lightness.quantile(WHITE)));
  const bright = arriving.quantile(BRIGHT);
  const wantedBright = wanted.quantile(BRIGHT);
  if (!(bright > 0)) return { scale: 1, offset: 0, white };
  const plain = wantedBright / bright;
  const range = bright - arriving.quantile(DARK);
  const contrast = (wantedBright - wanted.quantile(DARK)) / (plain * range);
  if (!(contrast > 1)) return { scale: plain, offset: 0, white };
  const scale = plain * Math.min(contrast, MAX_CONTRAST);
  return { scale, offset: wantedBright - scale * bright, white };
}

/** The number of samples of all surfaces together, of which each mesh has at least one, and the greatest number of meshes. */
const MAX_SAMPLES = 2048;
const MAX_MESHES = 512;
/**
 * The number of samples of one mesh if there are few meshes and if there are many, and the number of triangles that they are taken
 * from.
 */
const LEAST_SAMPLES = 1 << 4;
const MOST_SAMPLES = 1 << 10;
const TRIANGLES_PER_SAMPLE = 1 << 4;
/** The greatest number of instances of a mesh that are sampled. */
const MAX_INSTANCES = 16;
/** The number of directions, evenly spread, in which a sphere is sampled relative to its light. */
const SPHERE_STEPS = 200;

/** The code that plans the values of a scene that is not white all over. */
export type PlanScene = (colors: readonly Color[], samples: Samples) => ValuePlan;

/** The samples of the surfaces of a scene. */
export interface Samples {
  /** The distance between samples in the world, on the whole. */
  readonly spacing: number;
  /** The number of parts that each place stands for. */
  readonly counts: readonly number[];
  /** Calls back with each sample, how much of it is seen, and the index of its place. */
  readonly visit: (use: (sample: Sample, seen: number, place: number) => void) => void;
}

/** What the places of a scene have in common. */
interface Whole extends Openness {
  /** The area of all of them. */
  readonly area: number;
}

/** The occlusions that count as open. */
interface Openness {
  /** In the light that exposure is fitted to: that of the floor of a room; 0 elsewhere. */
  readonly ofRoom: number;
  /** In the drawing. */
  readonly openOcclusion: number;
}

/** A surface at one place in the world. */
interface Place {
  samples: SurfaceSamples;
  /** The first material whose exposure is fitted, and all that the groups of the mesh may have. */
  material: HatchingMaterialProperties;
  materials: Material | readonly Material[];
  toWorld: Matrix4;
  /** A factor on the area, which together give its share in the surfaces of the scene. */
  weight: number;
  area: number;
}

/** The luminance that a surface emits; 0 if it has an emissive map. */
const emittedBy = ({ emissive, emissiveIntensity, emissiveMap }: HatchingMaterialProperties): number =>
  emissiveMap ? 0 : emissiveIntensity * luminanceOf(emissive);

/** The exposure of a scene, fitted to its lights and kept until something changes. */
export class ExposureFit {
  readonly fit: ToneFit = { scale: 1, offset: 0, white: 1, openOcclusion: 0, plan: WHITE_PLAN };
  private readonly contents = new SceneContents();
  private readonly arriving = new WeightedValues();
  private readonly wanted = new WeightedValues();
  private readonly lightness = new WeightedValues();
  private readonly fromAbove = new WeightedValues();
  private readonly fromAround = new WeightedValues();
  private readonly ofWalls = new WeightedValues();
  private readonly colors = new WeightedColors();
  private isStale = true;

  /** @param withPlanner calls back with the code that plans values, at once or when it is there */
  constructor(private readonly withPlanner: (use: (planScene: PlanScene) => void) => void) {}

  /**
   * Updates the fit for a scene whose world matrices are up to date.
   *
   * @param layers the mask of the layers whose lights count
   */
  update(scene: Object3D, layers: number): ToneFit {
    if (!this.contents.read(scene, layers) && !this.isStale) return this.fit;
    this.isStale = false;
    const { arriving, wanted, lightness, fromAbove, fromAround, ofWalls, colors, contents } = this;
    for (const values of [arriving, wanted, lightness, fromAbove, fromAround, ofWalls, colors]) values.clear();
    const all = placesOf(contents);
    const openness = opennessOf(all, { fromAbove, fromAround, ofWalls });
    const places = formedAmong(all);
    const lights = new LightsAround(contents);
    const area = places.reduce((sum, place) => sum + place.area * place.weight, 0);
    for (const place of places) addPlace({ arriving, lightness, colors }, place, lights, { area, ...openness });
    for (const [material, share] of responsesOf(places)) addSphere(wanted, material, share);
    const plan = colors.isUnchanged ? this.fit.plan : this.planned(places, { area, ...openness });
    const { openOcclusion } = openness;
    return Object.assign(this.fit, fitTones(arriving, wanted, lightness), { openOcclusion, plan });
  }

  /** A plan of the values of the colours: until the code for it is there, that of white. */
  private planned(places: readonly Place[], whole: Whole): ValuePlan {
    const plan = { ...WHITE_PLAN };
    const { isWhite, means } = this.colors;
    const samples: Samples = {
      spacing: Math.sqrt(whole.area / MAX_SAMPLES),
      counts: places.map(({ weight }) => weight),
      visit: (use) => {
        for (const [i, place] of places.entries())
          visitSamples(place, whole, (one) => {
            const { y } = one.normal;
            use(one, seenOf(one, y) + (one.sides === 2 ? seenOf(one, -y) : 0), i);
          });
      },
    };
    if (!isWhite) this.withPlanner((planScene) => Object.assign(plan, planScene(means, samples)));
    return plan;
  }
}

/** The places of surfaces. */
function placesOf({ meshes, materials }: SceneContents): Place[] {
  const step = Math.max(1, Math.ceil(meshes.length / MAX_MESHES));
  const share = 2 ** Math.floor(Math.log2((4 * MAX_SAMPLES * step) / Math.max(1, meshes.length)));
  const wanted = Math.min(MOST_SAMPLES, Math.max(LEAST_SAMPLES, share));
  const places: Place[] = [];
  for (let i = 0; i < meshes.length; i += step) {
    const mesh = meshes[i];
    const samples = surfaceSamples(mesh.geometry, wanted, TRIANGLES_PER_SAMPLE * wanted);
    if (samples.count === 0) continue;
    const matrices = matricesOf(mesh);
    const weight = countOf(mesh) / matrices.length;
    for (const toWorld of matrices) {
      const area = samples.area * Math.abs(toWorld.determinant()) ** (2 / 3);
      places.push({ samples, material: materials[i], materials: mesh.material, toWorld, weight, area });
    }
  }
  return places;
}

/** All places but those of flat surfaces, unless all are flat: a ground or a wall says nothing about the form of what stands there. */
function formedAmong(places: readonly Place[]): readonly Place[] {
  const formed = places.filter(({ samples }) => !samples.isFlat);
  return formed.length > 0 ? formed : places;
}

const countOf = (mesh: Mesh): number => ('isInstancedMesh' in mesh ? (mesh as InstancedMesh).count : 1);

/** The matrices to world space that a mesh is drawn with: those of some of its instances, and that of a skin's first bone. */
function matricesOf(mesh: Mesh): Matrix4[] {
  if ('isInstancedMesh' in mesh) {
    const { count } = mesh as InstancedMesh;
    const shown = Math.min(count, MAX_INSTANCES);
    return Array.from({ length: shown }, (_, i) => {
      const matrix = new Matrix4();
      (mesh as InstancedMesh).getMatrixAt(Math.floor((i * count) / shown), matrix);
      return matrix.premultiply(mesh.matrixWorld);
    });
  }
  const { skeleton, bindMatrix, bindMatrixInverse } = mesh as SkinnedMesh;
  const bone = skeleton?.bones[0];
  if (!bone) return [mesh.matrixWorld];
  return [
    new Matrix4()
      .multiplyMatrices(mesh.matrixWorld, bindMatrixInverse)
      .multiply(bone.matrixWorld)
      .multiply(skeleton.boneInverses[0])
      .multiply(bindMatrix),
  ];
}

const normal = /* @__PURE__ */ new Vector3();
const toWorldNormal = /* @__PURE__ */ new Matrix3();
const light: Arriving = { direct: 0, indirect: 0, reflected: 0 };

/** The cosine to the vertical above which a surface is level. */
const LEVEL = 0.95;
/** The share of what is seen from above by whose occlusion rooms are told, and the occlusions from which on it may be and is a room. */
const ROOM_SHARE = 0.4;
const ROOM_FROM = 0.3;
const ROOM_TO = 0.45;
/** The shares in all that is seen from anywhere from which on level surfaces may be and are a floor. */
const FLOOR_FROM = 0.03;
const FLOOR_TO = 0.05;

/**
 * The share of all that is seen from anywhere that may lie in deep hollows, and the occlusions from which on that share is and all of it is deep.
 * Views show hollows from where they are open, so that a picture may have thrice that share. If there is more, all but the share `DEEP_LEFT` have no
 * more than `OPENED` once they are lightened.
 */
const DEEP_SHARE = 0.1;
const DEEP_FROM = 0.62;
const DEEP_TO = 0.75;
const DEEP_LEFT = 0.03;
const OPENED = 0.3;

/** The share of all surfaces from which on a triangle is a wall, such as the back of a cupboard, and no fold of a body. */
const WALL = 0.001;
/**
 * The share of all that is seen from anywhere that may lie in niches with walls, the occlusions of the walls from which on that share is and all
 * of it is opened, and that from which on a wall is the hidden inside of a body.
 */
const NICHE_SHARE = 0.04;
const NICHE_FROM = 0.6;
const NICHE_TO = 0.72;
const HIDDEN = 0.95;

/**
 * The occlusion that counts as open: 0, unless nearly all that is seen from above is a floor with walls around it, or so much lies in deep
 * hollows or in niches that it would be one black, as in a doll's house, cupboards or a lattice. What is not level counts as open to a floor, since
 * rooms have floors.
 */
function opennessOf(
  places: readonly Place[],
  { fromAbove, fromAround, ofWalls }: Record<'fromAbove' | 'fromAround' | 'ofWalls', WeightedValues>,
): Openness {
  let [level, all] = [0, 0];
  const wall = WALL * places.reduce((sum, { area, weight }) => sum + area * weight, 0);
  for (const { samples, material, toWorld, weight, area } of places) {
    const { normals, triangleAreas, occlusion, count } = samples;
    toWorldNormal.getNormalMatrix(toWorld);
    for (let i = 0; i < count; i++) {
      const isWall = triangleAreas[i] * area > wall * samples.area;
      const { y } = normal
        .fromArray(normals, 3 * i)
        .applyMatrix3(toWorldNormal)
        .normalize();
      for (const side of material.side === DoubleSide ? [0, 1] : [material.side === BackSide ? 1 : 0]) {
        const upwards = side === 0 ? y : -y;
        const occluded = occlusion[2 * i + side];
        const seen = (weight * area * (1 - occluded)) / count;
        all += seen;
        fromAround.add(occluded, seen);
        ofWalls.add(isWall && occluded < HIDDEN ? occluded : 0, seen);
        if (upwards > LEVEL) level += seen;
        fromAbove.add(upwards > LEVEL ? occluded : 0, seen * upwards);
      }
    }
  }
  if (all === 0) return { ofRoom: 0, openOcclusion: 0 };
  const floor = fromAbove.quantile(ROOM_SHARE);
  const ofRoom = floor * smoothstep(ROOM_FROM, ROOM_TO, floor) * smoothstep(FLOOR_FROM, FLOOR_TO, level / all);
  const deep = relativeOcclusion(fromAround.quantile(1 - DEEP_SHARE), ofRoom);
  const deepest = relativeOcclusion(fromAround.quantile(1 - DEEP_LEFT), ofRoom);
  const niches = relativeOcclusion(ofWalls.quantile(1 - NICHE_SHARE), ofRoom);
  const opened = Math.max(smoothstep(DEEP_FROM, DEEP_TO, deep), smoothstep(NICHE_FROM, NICHE_TO, niches));
  const ofHollows = ((deepest - OPENED) / (1 - OPENED)) * opened;
  return { ofRoom, openOcclusion: ofRoom + (1 - ofRoom) * ofHollows };
}

/** What is known of the surfaces of a scene, by their area. */
interface Seen {
  arriving: WeightedValues;
  lightness: WeightedValues;
  colors: WeightedColors;
}

/** How much a surface that faces the ground counts in the plan of values, beside nearly 1 for one that faces upwards. */
const FROM_BELOW = 0.05;

/** A sample of a surface in the world. The next one overwrites it. */
export interface Sample {
  material: HatchingMaterialProperties;
  readonly position: Vector3;
  /** The normal of the side that is drawn, or of the front if both are. */
  readonly normal: Vector3;
  /** Its colour in linear light; white where colours make no tone. */
  readonly color: Float64Array;
  area: number;
  /** The number of sides that are drawn. */
  sides: number;
  /** The occlusion of the side that is more open, relative to what counts as open in the drawing. */
  occluded: number;
  /** The same relative to what counts as open in the light that exposure is fitted to. */
  occludedInRoom: number;
}

const sample: Sample = /* @__PURE__ */ {
  material: undefined as unknown as HatchingMaterialProperties,
  position: /* @__PURE__ */ new Vector3(),
  normal: /* @__PURE__ */ new Vector3(),
  color: /* @__PURE__ */ new Float64Array(3),
  ...{ area: 0, sides: 1, occluded: 0, occludedInRoom: 0 },
};

/** How much of what a side of a sample shows is seen: what lies in a hollow or faces the ground hardly is. @param y the height of its normal */
const seenOf = ({ area, sides, occluded }: Sample, y: number): number =>
  (area * (1 - occluded) * (FROM_BELOW + (0.5 + 0.5 * y) ** 2)) / sides;

/** Calls back with each sample of a place that is drawn and whose exposure is fitted, with the material of its group. */
function visitSamples(
  place: Place,
  { area: all, ofRoom, openOcclusion }: Whole,
  visit: (sample: Sample) => void,
): void {
  const { samples, material: first, materials, toWorld, weight } = place;
  const { positions, normals, occlusion, groups } = samples;
  const { position, normal, color } = sample;
  const count = Math.max(1, Math.min(samples.count, Math.round((MAX_SAMPLES * place.area * weight) / all)));
  const writers = new Map<HatchingMaterialProperties, ReturnType<typeof colorWriter>>();
  const determinant = Math.abs(toWorld.determinant());
  toWorldNormal.getNormalMatrix(toWorld);
  for (let i = 0; i < count; i++) {
    const own = groups && Array.isArray(materials) ? (materials[groups[i]] as Material | undefined) : undefined;
    if (groups && Array.isArray(materials) && !isFittedMaterial(own)) continue;
    const material = (own as unknown as HatchingMaterialProperties | undefined) ?? first;
    position.fromArray(positions, 3 * i).applyMatrix4(toWorld);
    normal.fromArray(normals, 3 * i).applyMatrix3(toWorldNormal);
    const stretched = normal.length();
    normal.divideScalar(material.side === BackSide ? -stretched : stretched);
    sample.material = material;
    sample.area = (weight * samples.area * determinant * stretched) / count;
    color.fill(1);
    if (material.colorHatching > 0) {
      if (!writers.has(material)) writers.set(material, colorWriter(material, samples));
      writers.get(material)!(i, color);
    }
    // Either side of a double-sided surface may be seen, depending on the camera, and mostly the one that is more open.
    const [front, back] = [occlusion[2 * i], occlusion[2 * i + 1]];
    sample.sides = material.side === DoubleSide ? 2 : 1;
    const least = sample.sides === 2 ? Math.min(front, back) : material.side === BackSide ? back : front;
    sample.occluded = relativeOcclusion(least, openOcclusion);
    sample.occludedInRoom = relativeOcclusion(least, ofRoom);
    visit(sample);
  }
}

/**
 * Adds the radiance of a surface, as its material shows it under the lights, and the lightness of its colours. Deep hollows count as dark,
 * also where the drawing opens them: light does not reach them, and what lies outside is as light as on a body without hollows.
 */
function addPlace(seen: Seen, place: Place, lights: LightsAround, whole: Whole): void {
  visitSamples(place, whole, (one) => {
    const { material, position, normal, color, area, sides, occludedInRoom } = one;
    const emitted = emittedBy(material);
    const isHalfLambert = material.toneModel === 'halfLambert';
    const luminance = 0.2126 * color[0] + 0.7152 * color[1] + 0.0722 * color[2];
    seen.lightness.add(lightness(Math.min(luminance, 1)), area);
    for (let side = 0; side < sides; side++) {
      seen.colors.add(color, seenOf(one, normal.y));
      const open = openToLamps(occludedInRoom, material.occlusion);
      const openToSky = 1 - material.occlusion * occludedInRoom;
      lights.arriveAt(position, normal, isHalfLambert, light);
      const around = light.indirect + material.reflectedLight * light.reflected;
      const radiance = open * light.direct + openToSky * around + emitted;
      seen.arriving.add(radiance, area / sides);
      normal.negate();
    }
  });
}

/** One material per kind of response to light, with the area that has it. */
function responsesOf(places: readonly Place[]): Iterable<[HatchingMaterialProperties, number]> {
  const responses = new Map<string, [HatchingMaterialProperties, number]>();
  for (const { material, area, weight } of places) {
    const key = `${material.toneModel === 'halfLambert'} ${material.reflectedLight}`;
    const known = responses.get(key);
    if (known) known[1] += area * weight;
    else responses.set(key, [material, area * weight]);
  }
  return responses.values();
}

/** Adds a sphere of one material in a single light of intensity π. */
function addSphere(wanted: WeightedValues, material: HatchingMaterialProperties, weight: number): void {
  for (let i = 0; i < SPHERE_STEPS; i++) {
    const cosine = (2 * i + 1) / SPHERE_STEPS - 1;
    const direct = material.toneModel === 'halfLambert' ? (0.5 * cosine + 0.5) ** 2 : Math.max(cosine, 0);
    wanted.add(direct + material.reflectedLight * (0.5 - 0.5 * cosine), weight);
  }
}
