import type { Object3D } from 'three';
import type { OutlineOptions } from '../material/geometry/PrepareHatchingGeometryOptions.js';
import type { HatchingMaterial } from '../material/HatchingMaterial.js';
import type { HatchingOutlineParameters } from '../material/outlines/HatchingOutlineMaterial.js';
import type { ApplyHatchingOptions } from './ApplyHatchingOptions.js';
import type { FirstFrame } from './FirstFrame.js';
import type { OldLook } from './geometryPlans.js';
import type { SkippedMesh } from './HatchedScene.js';
import type { MakeLevels } from './levelMaker.js';
import type { OutlineMaker } from './OutlineMaker.js';

/** Makes materials and outlines for one kind of renderer. */
export interface LookMakers<Made extends HatchingMaterial = HatchingMaterial> {
  /** Makes a material with default values. */
  material(): Made;
  /** Fetches the code that a material needs, if it is loaded separately. */
  fetchPartsOf(material: Made): Promise<void>;
  /** Makes outlines. @throws RangeError or TypeError for a wrong parameter */
  outlineMaker(parameters: OutlineOptions & HatchingOutlineParameters): Promise<OutlineMaker>;
}

/** One call of `applyHatching`, as its steps share it. */
export interface HatchingCall {
  root: Object3D;
  options: ApplyHatchingOptions;
  makers: LookMakers;
  /** Prepares frames, if the renderer is known. */
  firstFrame: FirstFrame | null;
  /** Makes outlines, if they are requested. */
  outlineMaker: OutlineMaker | null;
  /** Makes levels of detail, if they are requested. */
  detail: MakeLevels | null;
  /** Everything that was made: freed if the call fails, otherwise by `dispose()` of its result. */
  disposables: { dispose(): void }[];
  /** Runs a function while the meshes have the looks that they had before the ones that are replaced. */
  asBefore<Result>(work: () => Result): Result;
}

/** The former looks of meshes, and the meshes that cannot be read. */
export interface OldLooks {
  seen: OldLook[];
  unreadable: SkippedMesh[];
}
