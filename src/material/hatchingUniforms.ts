import {
  DataArrayTexture,
  type IUniform,
  Matrix3,
  type Texture,
  UniformsLib,
  UniformsUtils,
  Vector2,
  Vector3,
  Vector4,
} from 'three';
import type { HatchingProperty } from '../look/HatchingProperty.js';
import { HATCHING_PROPERTIES, type HatchingPropertyName } from '../look/hatchingProperties.js';
import { runsAway } from '../look/queries.js';
import { blankThresholdMap } from './blankThresholdMap.js';
import { isFitted } from './exposure/isFitted.js';
import { createEmphasisUniforms } from './fading/emphasis.js';
import { curveEnds, fittedCurve, type ToneCurve } from './fitToneCurve.js';
import type { HatchingMaterialProperties } from './HatchingMaterialProperties.js';
import type { TonalArtMap } from './tam/TonalArtMap.js';

let blank: DataArrayTexture | undefined;

/** One texel for materials without a tonal art map, which print nothing of it. Shared and never disposed of. */
function blankTonalArtMap(): DataArrayTexture {
  if (blank === undefined) {
    blank = new DataArrayTexture(new Uint8Array([255, 255, 255, 255]), 1, 1, 1);
    blank.needsUpdate = true;
  }
  return blank;
}

type Uniforms = Record<string, IUniform>;

/** The uniforms of which meshes of one material have different values, but for textures. */
export const MESH_UNIFORMS = ['fieldOrigin', 'importance', 'lineContrast', 'objectToField', 'objectToFieldNormal'];

/** The uniforms of one material: those of its properties, those computed from them, and those of lights, fog and meshes. */
export function createHatchingUniforms(): Uniforms {
  const uniforms: Uniforms = UniformsUtils.merge([
    UniformsLib.lights,
    UniformsLib.fog,
    createEmphasisUniforms(),
    {
      alphaTest: { value: 0 },
      inked: { value: 1 },
      blendCosine: { value: 0 },
      colorExposure: { value: 1 },
      exposure: { value: new Vector2(1, 0) },
      highlightRamp: { value: new Vector2() },
      layerTurns: { value: new Vector4() },
      opacity: { value: 1 },
      strokeDirection: { value: new Vector2() },
      strokeTransform: { value: new Matrix3() },
      texelPixels: { value: 1 },
      toneCurveCubics: { value: null },
      toneCurveSpans: { value: null },
      toneCurveStart: { value: 0 },
      toneEnds: { value: new Vector2(0, 1) },
      viewportHeight: { value: 1 },
      // of the tonal art map
      thresholdMap: { value: null },
      thresholdMapLevels: { value: 1 },
      thresholdMapSize: { value: 1 },
      thresholdMapTexel: { value: new Vector2(1, 1) },
      thresholdMoments: { value: new Vector3(1, 1, 0) },
      tonalArtMap: { value: null },
      tonalArtMapLastLayer: { value: 0 },
      tonalArtMapTones: { value: 2 },
      // of dots
      dotPixels: { value: 1 },
      stippleMap: { value: null },
      // of the paper
      toothMap: { value: null },
      toothOffset: { value: new Vector2() },
      // of the scene's environment
      environment: { value: null },
      environmentAtlas: { value: new Vector3() },
      environmentIntensity: { value: 0 },
      environmentRotation: { value: new Matrix3() },
      // of the mesh that is drawn
      deformedNormals: { value: null },
      deformedPositions: { value: null },
      deformedTurns: { value: null },
      fieldOrigin: { value: new Vector3() },
      lineContrast: { value: 1 },
      objectToField: { value: new Matrix3() },
      objectToFieldNormal: { value: new Matrix3() },
      pullRowShift: { value: 0 },
      restPositions: { value: null },
      triangleVertices: { value: null },
    },
  ]);
  for (const property of Object.values<HatchingProperty>(HATCHING_PROPERTIES)) {
    if (!('uniform' in property) || property.uniform === undefined) continue;
    uniforms[property.uniform] = { value: null };
    if (property.kind === 'texture') uniforms[property.transform] = { value: new Matrix3() };
  }
  return keptFromProxies(uniforms);
}

/**
 * Gives uniforms another tag than `Object`, so that Vue does not wrap them in a proxy. The renderer takes a texture behind a proxy for another
 * texture, and would find nothing in one that it has drawn into.
 */
export const keptFromProxies = (uniforms: Uniforms): Uniforms =>
  Object.defineProperty(uniforms, Symbol.toStringTag, { value: 'Uniforms' });

/** Writes the properties that have a uniform of their own into it. Allocates nothing. */
export function writePropertyUniforms(material: HatchingMaterialProperties, uniforms: Uniforms): void {
  for (const key in HATCHING_PROPERTIES) {
    const name = key as HatchingPropertyName;
    const property: HatchingProperty = HATCHING_PROPERTIES[name];
    if (!('uniform' in property) || property.uniform === undefined) continue;
    uniforms[property.uniform].value = material[name];
    if (property.kind === 'texture') writeTransform(material[name] as Texture | null, uniforms[property.transform]);
  }
}

/** Writes a number that was computed. V8 allocates each such number that is kept, so it is kept only where it is another. */
function write(uniform: IUniform, value: number): void {
  if (uniform.value !== value) uniform.value = value;
}

function writeTransform(texture: Texture | null, uniform: IUniform<Matrix3>): void {
  if (texture === null) return;
  if (texture.matrixAutoUpdate) texture.updateMatrix();
  uniform.value.copy(texture.matrix);
}

/** Lines that lie closer, in pixels of what is drawn to, could not be told apart. */
const LEAST_SPACING = 2;

/**
 * Writes the sizes, which shaders measure in pixels of what is drawn to. Allocates nothing.
 *
 * @param map the one that is drawn with, ready or not
 * @param pixelRatio these pixels to a CSS pixel
 */
export function writeSizeUniforms(
  material: HatchingMaterialProperties,
  map: TonalArtMap | null,
  pixelRatio: number,
  u: Uniforms,
): void {
  const strokeTexels = map?.strokeTexels ?? 1;
  const dotPixels = pixelRatio * (material.strokeWidth ?? strokeTexels);
  write(u.dotPixels, dotPixels);
  write(u.texelPixels, dotPixels / strokeTexels);
  write(u.toothSize, pixelRatio * material.toothSize);
  // Lines are spaced on the screen as far as `sizedOnScreen` says, and their strokes as long.
  const onScreen = pixelRatio ** material.sizedOnScreen;
  write(u.lineSpacing, onScreen * material.lineSpacing);
  write(u.strokeLength, onScreen * material.strokeLength);
  write(u.finestSpacing, Math.max(pixelRatio * material.finestSpacing, LEAST_SPACING));
}

/**
 * Writes what the shaders know of a tonal art map; null stands for blank paper. Allocates nothing.
 *
 * @param isOfThresholds whether strokes are drawn from the map's thresholds
 */
export function writeMapUniforms(map: TonalArtMap | null, isOfThresholds: boolean, u: Uniforms): void {
  u.tonalArtMap.value = map?.texture ?? blankTonalArtMap();
  const tones = map?.tones ?? 2;
  u.tonalArtMapTones.value = tones;
  // A layer begins with the last tone of the one before.
  u.tonalArtMapLastLayer.value = Math.ceil((tones - 1) / 3) - 1;
  if (map === null) {
    u.thresholdMap.value = blankThresholdMap();
    u.thresholdMapLevels.value = 1;
    u.thresholdMoments.value.set(1, 1, 0);
    u.thresholdMapSize.value = 1;
    u.thresholdMapTexel.value.set(1, 1);
  } else if (isOfThresholds) {
    u.thresholdMap.value = map.thresholdTexture;
    u.thresholdMapLevels.value = map.levels;
    const { variance, coarserVariance, covariance } = map.thresholdMoments;
    u.thresholdMoments.value.set(variance, coarserVariance, covariance);
    u.thresholdMapSize.value = map.size;
    const { width, height } = map.thresholdTexture.image;
    u.thresholdMapTexel.value.set(1 / width, 1 / height);
  }
}

/** As shaders/chunks/tone.glsl leaves highlights blank. */
const highlightKept = (tone: number, { x, y }: Vector2): number => tone * Math.min(Math.max(x * tone + y, 0), 1);

/** Writes the uniforms that are computed from several properties, or from one in another unit. Allocates nothing. */
export function writeComputedUniforms(material: HatchingMaterialProperties, u: Uniforms): void {
  write(u.blendCosine, Math.cos(material.blendAngle));
  // u = s·cos − t·sin, v = s·sin + t·cos, in tiles
  const { tilesPerUnit: scale, strokeOffset: offset } = material;
  const isAway = runsAway(material);
  // Strokes of a map run towards the light, and away from it, at a right angle.
  const rotation = isAway ? Math.PI / 2 : material.strokeRotation;
  const cos = Math.cos(rotation);
  const sin = Math.sin(rotation);
  // Column by column. Nine numbers handed to a function would be allocated one by one.
  const { elements } = u.strokeTransform.value as Matrix3;
  elements[0] = elements[4] = cos * scale;
  elements[1] = sin * scale;
  elements[3] = -elements[1];
  elements[6] = offset.x;
  elements[7] = offset.y;
  u.strokeDirection.value.set(cos, sin);
  u.crossFrom.value = isAway ? 1 : material.crossFrom;
  const highlightReach = Math.max(material.highlightTone * material.highlightSoftness, 1e-6);
  // What is fitted to a scene follows when that is drawn.
  const { exposure, exposureCompensation } = material;
  u.exposure.value.set(exposure !== 'auto' ? exposure : isFitted(material) ? exposureCompensation : 1, 0);
  u.colorExposure.value = 1;
  const ramp = u.highlightRamp.value.set(0.5 / highlightReach, 0.5 - (0.5 * material.highlightTone) / highlightReach);
  const [blank, full] = curveEnds(material.toneCurve);
  u.toneEnds.value.set(highlightKept(blank, ramp), highlightKept(full, ramp));
  // The third layer halves the wider angle between the first two: it is turned by (π + crossAngle) / 2.
  const { crossAngle } = material;
  u.layerTurns.value.set(
    Math.cos(crossAngle),
    Math.sin(crossAngle),
    -Math.sin(crossAngle / 2),
    Math.cos(crossAngle / 2),
  );
}

/** Writes a tone curve that the shader is given as points; one that it computes changes nothing. */
export function writeCurveUniforms(curve: ToneCurve, u: Uniforms): void {
  const fitted = fittedCurve(curve);
  if (!fitted) return;
  u.toneCurveStart.value = fitted.start;
  u.toneCurveSpans.value = fitted.spans;
  u.toneCurveCubics.value = fitted.cubics;
}
