/**
 * Hatching for three.js: materials, lines, maps and presets, and what prepares a scene for them.
 *
 * @module three-hatching
 */

export type { HatchingOwner } from './look/HatchingProperty.js';
// The types of all choices.
export type * from './look/hatchingProperties.js';
export type { HiddenOutlines } from './look/hiddenOutlines.js';
export type { BackgroundNumberName } from './material/backgroundProperties.js';
export type { HatchingMaterialParameters } from './material/checkValues.js';
export type { PlannedTones, SurfaceFacts, ToneFit, ValueCurve, ValuePlan } from './material/exposure/ToneFit.js';
export { SceneExtent } from './material/fading/SceneExtent.js';
export type { ToneCurve, ToneCurvePoint } from './material/fitToneCurve.js';
export type { HatchingFormOptions } from './material/geometry/HatchingFormOptions.js';
export type {
  OutlineOptions,
  PrepareHatchingGeometryOptions,
} from './material/geometry/PrepareHatchingGeometryOptions.js';
export type { HatchingStatistics } from './material/geometry/preparedGeometry.js';
export { prepareHatchingGeometry } from './material/geometry/prepareHatchingGeometry.js';
export type { Repairs } from './material/geometry/repairValues.js';
export { HatchingComposition } from './material/groups/HatchingComposition.js';
export type {
  HatchingCompositionOptions,
  HatchingCompositionProperties,
  HatchingShadowOptions,
  HatchingShadowProperties,
  PerTriangleOptions,
  PerTriangleProperties,
} from './material/groups/ownedProperties.js';
export type { PerTriangle } from './material/groups/PerTriangle.js';
export type { PropertyGroup } from './material/groups/PropertyGroup.js';
export type { HatchingShadowMaterialParameters } from './material/groups/shadows.js';
export { HatchingBackground, type HatchingBackgroundParameters } from './material/HatchingBackground.js';
export { HatchingMaterial } from './material/HatchingMaterial.js';
export type { HatchingMaterialOptions, HatchingMaterialProperties } from './material/HatchingMaterialProperties.js';
export { HatchingShadowMaterial } from './material/HatchingShadowMaterial.js';
export type { HatchingMaterialJSON } from './material/hatchingJSON.js';
export {
  HatchingOutlineMaterial,
  type HatchingOutlineParameters,
} from './material/outlines/HatchingOutlineMaterial.js';
export { HatchingOutlines } from './material/outlines/HatchingOutlines.js';
export type { MeshOutlines } from './material/outlines/MeshOutlines.js';
export type { OutlineWeights } from './material/outlines/OutlineWeights.js';
export type { OutlineNumberName } from './material/outlines/outlineProperties.js';
export { millimetresToPixels } from './material/outlines/outlineProperties.js';
export type { PropertyFields } from './material/PropertyFields.js';
export type { HatchingMap, Vector2Like, Vector3Like } from './material/propertyValues.js';
export { TonalArtMap, type TonalArtMapOptions } from './material/tam/TonalArtMap.js';
export type { TonalArtMapTexture } from './material/tam/TonalArtMapTexture.js';
export type { ThresholdMoments, ThresholdTexture } from './material/tam/thresholds.js';
export type { SpriteLike } from './material/three/posing.js';
export type { EdgeCounts } from './mesh/adjacency/pairEdges.js';
export { AdaptiveResolution, type AdaptiveResolutionOptions } from './scene/AdaptiveResolution.js';
export type { ApplyHatchingOptions } from './scene/ApplyHatchingOptions.js';
export { applyHatching } from './scene/applyHatching.js';
export { type BakeOcclusionOptions, bakeOcclusion } from './scene/bakeOcclusion.js';
export { fitExposure } from './scene/fitExposure.js';
export type { HatchedScene, HatchingTask } from './scene/HatchedScene.js';
export type { DetailOptions } from './scene/levelMaker.js';
export {
  type FlatteringLight,
  type FlatteringLightOptions,
  flatteringLight,
} from './scene/lighting/flatteringLight.js';
export type { OcclusionBake } from './scene/OcclusionBake.js';
export { type HatchingPreset, type PresetName, presets, withPreset } from './scene/presets.js';
export type { SkippedMesh } from './scene/SkippedMesh.js';
export { scalePreset } from './scene/scalePreset.js';
export {
  type Hand,
  type HandLines,
  type HandLinesOptions,
  type HandNumbers,
  type HandStroke,
  handLines,
  type SwatchTone,
} from './strokes/hand/Hand.js';
export { type LearnHandOptions, learnHand } from './strokes/hand/learnHand.js';
export type { TonalArtMapSource } from './strokes/mapFiles/readSource.js';
export type { StrokeStyleName } from './strokes/strokeStyleNames.js';
export type { ScannedImage } from './strokes/strokeTracing/ScannedImage.js';
export type { TraceOptions } from './strokes/strokeTracing/traceStrokesSteps.js';
export type { HatchImageReport } from './strokes/tamImages/checkHatchImages.js';
export type { HatchImages } from './strokes/tamImages/HatchImages.js';
export type { MapDrawing } from './strokes/tamImages/hatchImageOptions.js';
export {
  type LearnHandAsyncOptions,
  learnHandAsync,
  type TraceStrokesOptions,
  traceStrokes,
} from './worker/handsAsync.js';
export { disposeHatchingWorkers } from './worker/runTask.js';
export type { TaskOptions } from './worker/TaskOptions.js';
