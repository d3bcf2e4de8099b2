/**
 * Hatching for three.js: materials, lines, maps and presets, and what prepares a scene for them.
 *
 * @module three-hatching
 */

export type { EdgeCounts } from './adjacency/EdgeCounts.js';
export type { BackgroundNumberName } from './background/backgroundProperties.js';
export { HatchingBackground, type HatchingBackgroundParameters } from './background/HatchingBackground.js';
export type { HiddenOutlines } from './engraving/hiddenOutlines.js';
export type { HatchingFormOptions } from './geometry/HatchingFormOptions.js';
export type { HatchingStatistics } from './geometry/HatchingStatistics.js';
export type { OutlineOptions, PrepareHatchingGeometryOptions } from './geometry/PrepareHatchingGeometryOptions.js';
export { prepareHatchingGeometry } from './geometry/prepareHatchingGeometry.js';
export type { Repairs } from './geometry/repairValues.js';
export { type EngravedHand, type EngravedHandOptions, engravedHand } from './hand/engravedHand.js';
export type { Hand, HandNumbers, HandStroke, SwatchTone } from './hand/Hand.js';
export { type LearnHandOptions, learnHand } from './hand/learnHand.js';
export { type LearnHandAsyncOptions, learnHandAsync } from './handTasks/learnHandAsync.js';
export { type TraceStrokesOptions, traceStrokes } from './handTasks/traceStrokes.js';
export type { HatchImageReport } from './hatchImages/checkHatchImages.js';
export type { HatchImages } from './hatchImages/HatchImages.js';
export type { MapDrawing } from './hatchImages/hatchImageOptions.js';
export type { TonalArtMapSource } from './mapFiles/readSource.js';
export type { HatchingMap } from './material/checkTonalArtMap.js';
export { SceneExtent } from './material/emphasis/SceneExtent.js';
export type { ToneFit } from './material/exposure/ToneFit.js';
// The types of all choices.
export type * from './material/facts/hatchingProperties.js';
export type { ToneCurve, ToneCurvePoint } from './material/fitToneCurve.js';
export { HatchingMaterial } from './material/HatchingMaterial.js';
export type { HatchingMaterialParameters } from './material/HatchingMaterialParameters.js';
export type { HatchingMaterialOptions, HatchingMaterialProperties } from './material/HatchingMaterialProperties.js';
export type { HatchingMaterialJSON } from './material/hatchingJSON.js';
export type { PropertyFields } from './material/PropertyFields.js';
export type { Vector2Like, Vector3Like } from './material/vectorValues.js';
export { HatchingOutlineMaterial, type HatchingOutlineParameters } from './outlines/HatchingOutlineMaterial.js';
export { HatchingOutlines } from './outlines/HatchingOutlines.js';
export type { MeshOutlines } from './outlines/MeshOutlines.js';
export { millimetresToPixels } from './outlines/millimetresToPixels.js';
export type { OutlineNumberName } from './outlines/outlineProperties.js';
export type { ScannedImage } from './scan/ScannedImage.js';
export type { TraceOptions } from './scan/traceStrokesSteps.js';
export { AdaptiveResolution, type AdaptiveResolutionOptions } from './scene/AdaptiveResolution.js';
export type { ApplyHatchingOptions } from './scene/ApplyHatchingOptions.js';
export { applyHatching } from './scene/applyHatching.js';
export { type BakeOcclusionOptions, bakeOcclusion } from './scene/bakeOcclusion.js';
export type { DetailOptions } from './scene/detail/DetailOptions.js';
export { fitExposure } from './scene/exposing/fitExposure.js';
export {
  type FlatteringLight,
  type FlatteringLightOptions,
  flatteringLight,
} from './scene/flattering/flatteringLight.js';
export type { HatchedScene, SkippedMesh } from './scene/HatchedScene.js';
export type { OcclusionBake } from './scene/occlusion/OcclusionBake.js';
export { type HatchingPreset, type PresetName, presets } from './scene/presets.js';
export { scalePreset } from './scene/scalePreset.js';
export { withPreset } from './scene/withPreset.js';
export type { StrokeStyleName } from './strokes/strokeStyleNames.js';
export type { ThresholdMoments } from './tam/measureThresholdMoments.js';
export type { ThresholdTexture } from './tam/ThresholdTexture.js';
export type { TonalArtMapOptions } from './tam/TonalArtMap.js';
export { TonalArtMap } from './tam/TonalArtMap.js';
export type { TonalArtMapTexture } from './tam/TonalArtMapTexture.js';
export { disposeHatchingWorkers } from './worker/runTask.js';
export type { TaskOptions } from './worker/TaskOptions.js';
