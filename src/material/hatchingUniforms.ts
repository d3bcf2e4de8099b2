import {
  DataArrayTexture,
  DataTexture,
  type IUniform,
  LinearFilter,
  Matrix3,
  RGFormat,
  type Texture,
  UniformsLib,
  UniformsUtils,
  Vector2,
  Vector3,
  Vector4,
} from 'three';
import type { HatchingProperty } from '../look/HatchingProperty.js';
import { HATCHING_PROPERTIES, type HatchingPropertyName } from '../look/hatchingProperties.js';
import { familyOf } from '../look/presetParameters.js';
import { hasOwner, runsAway } from '../look/queries.js';
import { axisAngle } from '../look/vectors.js';
import { isFitted, LUMINANCE, writeFilter } from './exposure/ToneFit.js';
import { createFadingUniforms } from './fading/fading.js';
import { curveEnds } from './fitToneCurve.js';
import type { HatchingMaterialProperties } from './HatchingMaterialProperties.js';
import type { TonalArtMap } from './tam/TonalArtMap.js';

let blankThresholds: DataTexture | undefined;
let blankImages: DataArrayTexture | undefined;

/** One texel of blank paper for materials without a tonal art map. Shared and never disposed of. */
export function blankThresholdMap(): DataTexture {
  if (blankThresholds === undefined) {
    blankThresholds = new DataTexture(new Uint8Array([255, 255]), 1, 1, RGFormat);
    blankThresholds.unpackAlignment = 2;
    // The filters of real maps: WebGPURenderer keeps the filter of the first texture that it binds.
    blankThresholds.magFilter = blankThresholds.minFilter = LinearFilter;
    blankThresholds.needsUpdate = true;
  }
  return blankThresholds;
}

/** The same as an array, for techniques that read images. */
function blankTonalArtMap(): DataArrayTexture {
  if (blankImages === undefined) {
    blankImages = new DataArrayTexture(new Uint8Array([255, 255, 255, 255]), 1, 1, 1);
    blankImages.needsUpdate = true;
  }
  return blankImages;
}

type Uniforms = Record<string, IUniform>;

/** The uniforms that may differ between meshes with the same material, textures excepted. */
export const MESH_UNIFORMS = ['fieldOrigin', 'importance', 'lineContrast', 'objectToField', 'objectToFieldNormal'];

/** Creates the uniforms of one material: those of its properties, those computed from them, and those of lights, fog and meshes. */
export function createHatchingUniforms(): Uniforms {
  const uniforms: Uniforms = UniformsUtils.merge([
    UniformsLib.lights,
    UniformsLib.fog,
    createFadingUniforms(),
    {
      alphaTest: { value: 0 },
      inked: { value: 1 },
      blendCosine: { value: 0 },
      colorExposure: { value: 1 },
      colorFilter: { value: new Vector4() },
      exposure: { value: new Vector2(1, 0) },
      highlightRamp: { value: new Vector2() },
      layerTurns: { value: new Vector4() },
      opacity: { value: 1 },
      openOcclusion: { value: 0 },
      strokeDirection: { value: new Vector2() },
      strokeTransform: { value: new Matrix3() },
      texelPixels: { value: 1 },
      mapBlur: { value: 0 },
      toneCurveTable: { value: null },
      toneEnds: { value: new Vector2(0, 1) },
      valueBends: { value: new Vector4() },
      valueKnots: { value: new Vector4() },
      viewportHeight: { value: 1 },
      // Tonal art map.
      thresholdMap: { value: null },
      thresholdMapLevels: { value: 1 },
      thresholdMapSize: { value: 1 },
      thresholdMapTexel: { value: new Vector2(1, 1) },
      thresholdMoments: { value: new Vector3(1, 1, 0) },
      tonalArtMap: { value: null },
      tonalArtMapLastLayer: { value: 0 },
      tonalArtMapTones: { value: 2 },
      // Dots.
      dotPixels: { value: 1 },
      stippleMap: { value: null },
      // Strokes of a hand.
      handReach: { value: new Vector4() },
      handRows: { value: new Vector2() },
      handLanes: { value: new Vector2() },
      handStrokes: { value: null },
      // Paper.
      toothMap: { value: null },
      toothOffset: { value: new Vector2() },
      // Environment.
      environment: { value: null },
      environmentAtlas: { value: new Vector3() },
      environmentIntensity: { value: 0 },
      environmentRotation: { value: new Matrix3() },
      // Mesh.
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
 * Gives uniforms a `toStringTag` other than `Object`, so that Vue does not wrap them in a proxy. To the renderer, a texture behind a
 * proxy is another texture than the one that it has drawn into.
 */
export const keptFromProxies = (uniforms: Uniforms): Uniforms =>
  Object.defineProperty(uniforms, Symbol.toStringTag, { value: 'Uniforms' });

/** Writes each property that has a uniform of the same name. Allocates nothing. */
export function writePropertyUniforms(material: HatchingMaterialProperties, uniforms: Uniforms): void {
  for (const key in HATCHING_PROPERTIES) {
    const name = key as HatchingPropertyName;
    const property: HatchingProperty = HATCHING_PROPERTIES[name];
    if (!('uniform' in property) || property.uniform === undefined) continue;
    if (!hasOwner(material, property)) continue;
    const value = (material as Readonly<Partial<Record<HatchingPropertyName, unknown>>>)[name];
    uniforms[property.uniform].value = value;
    if (property.kind === 'texture') writeTransform(value as Texture | null, uniforms[property.transform]);
  }
}

/** Writes a computed number if it differs: V8 allocates each such number that is stored. */
function write(uniform: IUniform, value: number): void {
  if (uniform.value !== value) uniform.value = value;
}

function writeTransform(texture: Texture | null, uniform: IUniform<Matrix3>): void {
  if (texture === null) return;
  if (texture.matrixAutoUpdate) texture.updateMatrix();
  uniform.value.copy(texture.matrix);
}

/** The least distance of lines in pixels of the render target; lines closer than this merge. */
const MIN_SPACING = 2;

/**
 * Writes sizes in pixels of the render target, the unit of the shaders. Allocates nothing.
 *
 * @param map the map in use, ready or not
 * @param pixelRatio pixels of the render target per CSS pixel
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
  write(u.paperGrainSize, pixelRatio * material.paperGrainSize);
  // `screenSpaceShare` blends the spacing of lines and the length of their strokes from object to screen space.
  const onScreen = pixelRatio ** material.screenSpaceShare;
  write(u.lineSpacing, onScreen * material.lineSpacing);
  write(u.strokeLength, onScreen * material.strokeLength);
  write(u.minLineSpacing, Math.max(pixelRatio * material.minLineSpacing, MIN_SPACING));
  write(u.mapBlur, mapBlurOf(material, strokeTexels, pixelRatio));
}

/** How far apart strokes of a map and dots count as, in widths of theirs. */
const WIDTHS_APART = 3;

/**
 * How many levels coarser a map is read for its tone than the screen shows it: details finer than four spacings of the strokes are left
 * out. 0 where colours are measured, not planned.
 *
 * @param strokeTexels the width of the strokes of the tonal art map
 * @param pixelRatio pixels of the render target per CSS pixel
 */
export function mapBlurOf(material: HatchingMaterialProperties, strokeTexels: number, pixelRatio: number): number {
  if (!isFitted(material)) return 0;
  const { technique, lineSpacing, strokeWidth, composition } = material;
  const spacing = familyOf(technique) === 'lines' ? lineSpacing : WIDTHS_APART * (strokeWidth ?? strokeTexels);
  return composition.plannedValues * Math.max(Math.log2(spacing * pixelRatio), 0);
}

/**
 * Writes the uniforms of a tonal art map; null stands for blank paper. Allocates nothing.
 *
 * @param isOfThresholds whether strokes are drawn from the map's thresholds instead of its images
 */
export function writeMapUniforms(map: TonalArtMap | null, isOfThresholds: boolean, u: Uniforms): void {
  u.tonalArtMap.value = map?.texture ?? blankTonalArtMap();
  const tones = map?.tones ?? 2;
  u.tonalArtMapTones.value = tones;
  // Neighbouring layers share a tone: the last of one is the first of the next.
  u.tonalArtMapLastLayer.value = Math.ceil((tones - 1) / 3) - 1;
  // Without a map no stroke is drawn, whatever the numbers of the last map are.
  if (map === null) u.thresholdMap.value = blankThresholdMap();
  else if (isOfThresholds) {
    u.thresholdMap.value = map.thresholdTexture;
    u.thresholdMapLevels.value = map.levels;
    const { variance, coarserVariance, covariance } = map.thresholdMoments;
    u.thresholdMoments.value.set(variance, coarserVariance, covariance);
    u.thresholdMapSize.value = map.size;
    const { width, height } = map.thresholdTexture.image;
    u.thresholdMapTexel.value.set(1 / width, 1 / height);
  }
}

/** The tone after highlights were left blank, as in shaders/chunks/tone.glsl. */
const highlightKept = (tone: number, { x, y }: Vector2): number => tone * Math.min(Math.max(x * tone + y, 0), 1);

/** Writes the uniforms that are computed from several properties, or from one in another unit. Allocates nothing. */
export function writeComputedUniforms(material: HatchingMaterialProperties, u: Uniforms): void {
  write(u.blendCosine, Math.cos(material.perTriangle.blendAngle));
  // u = s·cos + t·sin, v = t·cos − s·sin, in tiles
  const { tilesPerObjectUnit: scale } = material;
  const { strokeOffset: offset } = material.perTriangle;
  const isAway = runsAway(material);
  // Turned by a right angle, the strokes of a map run along the direction of the light.
  const turn = axisAngle(isAway ? Math.PI / 2 : material.strokeAngle);
  const cos = Math.cos(turn);
  const sin = Math.sin(turn);
  // Matrix3.set with nine arguments would allocate each of them; this writes the elements, column by column.
  const { elements } = u.strokeTransform.value as Matrix3;
  elements[0] = elements[4] = cos * scale;
  elements[3] = sin * scale;
  elements[1] = -elements[3];
  elements[6] = offset.x;
  elements[7] = offset.y;
  u.strokeDirection.value.set(cos, sin);
  u.crossFrom.value = isAway ? 1 : material.crossFrom;
  const highlightReach = Math.max(material.highlightThreshold * material.highlightSoftness, 1e-6);
  // An exposure that is fitted to the scene is written later, when the scene is drawn.
  const { exposure, exposureCompensation } = material.composition;
  u.exposure.value.set(typeof exposure === 'number' ? exposure : isFitted(material) ? exposureCompensation : 1, 0);
  u.colorExposure.value = 1;
  u.openOcclusion.value = 0;
  writeFilter(LUMINANCE, 0, u.colorFilter.value);
  const ramp = u.highlightRamp.value.set(
    0.5 / highlightReach,
    0.5 - (0.5 * material.highlightThreshold) / highlightReach,
  );
  const [blank, full] = curveEnds(material.toneCurve);
  u.toneEnds.value.set(highlightKept(blank, ramp), highlightKept(full, ramp));
  // The third layer bisects the wider angle between the first two: it is turned by (π + crossAngle) / 2.
  const { crossAngle } = material;
  u.layerTurns.value.set(
    Math.cos(crossAngle),
    Math.sin(crossAngle),
    -Math.sin(crossAngle / 2),
    Math.cos(crossAngle / 2),
  );
}
