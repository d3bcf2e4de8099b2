import {
  BackSide,
  DoubleSide,
  type InstancedMesh,
  Matrix3,
  Matrix4,
  type Mesh,
  type Object3D,
  type SkinnedMesh,
  Vector3,
} from 'three';
import type { HatchingMaterialProperties } from '../HatchingMaterialProperties.js';
import { type Arriving, LightsAround } from './LightsAround.js';
import { lightnessOf } from './lightnessOf.js';
import { openToLamps } from './openToLamps.js';
import { SceneContents } from './SceneContents.js';
import { type SurfaceSamples, surfaceSamples } from './surfaceSamples.js';
import type { ToneFit } from './ToneFit.js';
import { WeightedValues } from './WeightedValues.js';

/** Quantiles of the radiance over a surface: what counts as its lights and as its darks. */
const BRIGHT = 0.9;
const DARK = 0.1;
/** The quantile of the colours' lightness that counts as white, and the least. What is nearly black does not become white. */
const WHITE = 0.9;
const LEAST_WHITE = 0.3;
/** The dark is not drawn further from the bright than by this factor, so that a faint difference does not become a rough one. */
const MOST_CONTRAST = 4;

/**
 * Fits the light that arrives on surfaces to the light that presets are made for, so that bright parts are as bright as there. Light
 * from all around leaves no darks: what is dark there is then brought down to where it would be. Darks are never lifted.
 *
 * The lightest colours, by area, are left white, so that a scene of middle greys is not all in half tone.
 *
 * @param arriving the radiance of the surfaces, by area
 * @param wanted the radiance to which it is fitted: that of a sphere in a single light of intensity π
 * @param lightness of their colours, as far as they become tone
 */
export function fitTones(arriving: WeightedValues, wanted: WeightedValues, lightness: WeightedValues): ToneFit {
  const white = lightness.isEmpty ? 1 : Math.min(1, Math.max(LEAST_WHITE, lightness.quantile(WHITE)));
  const bright = arriving.quantile(BRIGHT);
  const wantedBright = wanted.quantile(BRIGHT);
  if (!(bright > 0)) return { scale: 1, offset: 0, white };
  const plain = wantedBright / bright;
  const range = bright - arriving.quantile(DARK);
  const contrast = (wantedBright - wanted.quantile(DARK)) / (plain * range);
  if (!(contrast > 1)) return { scale: plain, offset: 0, white };
  const scale = plain * Math.min(contrast, MOST_CONTRAST);
  return { scale, offset: wantedBright - scale * bright, white };
}

/** Of all surfaces together about so many samples are lit, and at least one of each mesh, up to so many meshes. */
const MOST_SAMPLES = 2048;
const MOST_MESHES = 512;
/** The samples of one mesh, where there are few meshes and where there are many, and the triangles from which they are taken. */
const SAMPLES_OF_ONE = { least: 1 << 4, most: 1 << 10 };
const TRIANGLES_PER_SAMPLE = 1 << 4;
/** At most this many instances of a mesh are lit. */
const MOST_INSTANCES = 16;
/** The directions in which a sphere faces its light, evenly spread. */
const SPHERE_STEPS = 200;

/** A surface in one place of the world. */
interface Place {
  samples: SurfaceSamples;
  material: HatchingMaterialProperties;
  toWorld: Matrix4;
  /** Its share in the surfaces of the scene is that of its area times this. */
  weight: number;
  area: number;
}

/** What a surface gives off; nothing where a map says of which parts. */
const luminanceOf = ({ emissive: { r, g, b }, emissiveIntensity, emissiveMap }: HatchingMaterialProperties): number =>
  emissiveMap ? 0 : emissiveIntensity * (0.2126 * r + 0.7152 * g + 0.0722 * b);

/** Fits the exposure of a scene to its lights, and keeps what it has found until something changes. */
export class ExposureFit {
  readonly fit: ToneFit = { scale: 1, offset: 0, white: 1 };
  private readonly contents = new SceneContents();
  private readonly arriving = new WeightedValues();
  private readonly wanted = new WeightedValues();
  private readonly lightness = new WeightedValues();
  private isStale = true;

  /**
   * Brings the fit up to date with a scene, whose world matrices must be so.
   *
   * @param layers the mask of the layers whose lights count
   */
  update(scene: Object3D, layers: number): ToneFit {
    if (!this.contents.read(scene, layers) && !this.isStale) return this.fit;
    this.isStale = false;
    const { arriving, wanted, lightness, contents } = this;
    for (const values of [arriving, wanted, lightness]) values.clear();
    const places = placesOf(contents);
    const lights = new LightsAround(contents);
    const area = places.reduce((sum, place) => sum + place.area * place.weight, 0);
    for (const place of places) addPlace(arriving, lightness, place, lights, area);
    for (const [material, share] of responsesOf(places)) addSphere(wanted, material, share);
    return Object.assign(this.fit, fitTones(arriving, wanted, lightness));
  }
}

/** Where surfaces are; what is flat is left out unless all of it is: a ground or a wall says nothing of the form that stands there. */
function placesOf({ meshes, materials }: SceneContents): Place[] {
  const step = Math.max(1, Math.ceil(meshes.length / MOST_MESHES));
  const { least, most } = SAMPLES_OF_ONE;
  const share = 2 ** Math.floor(Math.log2((4 * MOST_SAMPLES * step) / Math.max(1, meshes.length)));
  const wanted = Math.min(most, Math.max(least, share));
  const places: Place[] = [];
  for (let i = 0; i < meshes.length; i += step) {
    const mesh = meshes[i];
    const samples = surfaceSamples(mesh.geometry, wanted, TRIANGLES_PER_SAMPLE * wanted);
    if (samples.count === 0) continue;
    const matrices = matricesOf(mesh);
    const weight = countOf(mesh) / matrices.length;
    for (const toWorld of matrices) {
      const area = samples.area * Math.abs(toWorld.determinant()) ** (2 / 3);
      places.push({ samples, material: materials[i], toWorld, weight, area });
    }
  }
  const formed = places.filter(({ samples }) => !samples.isFlat);
  return formed.length > 0 ? formed : places;
}

const countOf = (mesh: Mesh): number => ('isInstancedMesh' in mesh ? (mesh as InstancedMesh).count : 1);

/** The matrices to world space with which a mesh is drawn: of some of its instances, and of a skin that of its first bone. */
function matricesOf(mesh: Mesh): Matrix4[] {
  if ('isInstancedMesh' in mesh) {
    const { count } = mesh as InstancedMesh;
    const shown = Math.min(count, MOST_INSTANCES);
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

const position = /* @__PURE__ */ new Vector3();
const normal = /* @__PURE__ */ new Vector3();
const toWorldNormal = /* @__PURE__ */ new Matrix3();
const light: Arriving = { direct: 0, indirect: 0, reflected: 0 };

/** Adds the radiance of a surface, as its material shows it under the lights, and how light its colours look. */
function addPlace(
  arriving: WeightedValues,
  lightness: WeightedValues,
  place: Place,
  lights: LightsAround,
  all: number,
): void {
  const { samples, material, toWorld, weight } = place;
  const { positions, normals, occlusion } = samples;
  const share = (place.area * weight) / all;
  const count = Math.max(1, Math.min(samples.count, Math.round(MOST_SAMPLES * share)));
  const isHalfLambert = material.toneModel === 'halfLambert';
  const emitted = luminanceOf(material);
  const lightnessAt = material.localTone > 0 ? lightnessOf(material, samples) : () => 1;
  const determinant = Math.abs(toWorld.determinant());
  toWorldNormal.getNormalMatrix(toWorld);
  for (let i = 0; i < count; i++) {
    position.fromArray(positions, 3 * i).applyMatrix4(toWorld);
    normal.fromArray(normals, 3 * i).applyMatrix3(toWorldNormal);
    const stretched = normal.length();
    normal.divideScalar(stretched);
    if (material.side === BackSide) normal.negate();
    const open = openToLamps(occlusion[i], material.occlusion);
    const openToSky = 1 - material.occlusion * occlusion[i];
    // Of two sides either may be seen, which is up to the camera.
    const sides = material.side === DoubleSide ? 2 : 1;
    const area = (weight * samples.area * determinant * stretched) / count;
    lightness.add(lightnessAt(i), area);
    for (let side = 0; side < sides; side++) {
      lights.arriveAt(position, normal, isHalfLambert, light);
      const around = light.indirect + material.reflectedLight * light.reflected;
      const radiance = open * light.direct + openToSky * around + emitted;
      arriving.add(radiance, area / sides);
      normal.negate();
    }
  }
}

/** A material for each way to answer to light, with the area that has it. */
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

/** Adds a sphere of a material in a single light of intensity π. */
function addSphere(wanted: WeightedValues, material: HatchingMaterialProperties, weight: number): void {
  for (let i = 0; i < SPHERE_STEPS; i++) {
    const cosine = (2 * i + 1) / SPHERE_STEPS - 1;
    const direct = material.toneModel === 'halfLambert' ? (0.5 * cosine + 0.5) ** 2 : Math.max(cosine, 0);
    wanted.add(direct + material.reflectedLight * (0.5 - 0.5 * cosine), weight);
  }
}
