import type { BufferAttribute, BufferGeometry, Mesh, Object3D, Vector3 } from 'three';
import type { SceneExtent } from '../material/fading/SceneExtent.js';
import type { OutlineOptions } from '../material/geometry/PrepareHatchingGeometryOptions.js';
import type { HatchingComposition } from '../material/groups/HatchingComposition.js';
import type { HatchingMaterial } from '../material/HatchingMaterial.js';
import type { HatchingOutlineParameters } from '../material/outlines/HatchingOutlineMaterial.js';
import type { TonalArtMap } from '../material/tam/TonalArtMap.js';
import type { StrokeStyleName } from '../strokes/strokeStyleNames.js';
import type { ApplyHatchingOptions } from './ApplyHatchingOptions.js';
import type { ChosenMeshes } from './chooseMeshes.js';
import type { FirstFrame } from './FirstFrame.js';
import type { MeshLook, OldLook } from './geometryPlans.js';
import type { LaterForms } from './LaterForms.js';
import type { HideDetail, MakeLevels } from './levelMaker.js';
import type { OutlineMaker } from './OutlineMaker.js';
import type { Replacement } from './Replacement.js';
import type { SkippedMesh } from './SkippedMesh.js';

/** Makes materials and outlines for one kind of renderer. */
export interface LookMakers<Made extends HatchingMaterial = HatchingMaterial> {
  /** Makes a material with default values. */
  material(): Made;
  /** Fetches the code that materials and outlines with these options need, before there are any. */
  fetchAhead(options: ApplyHatchingOptions): Promise<unknown>;
  /** Fetches the code that a material needs, if it is loaded separately. */
  fetchPartsOf(material: Made): Promise<void>;
  /** Makes outlines. @throws RangeError or TypeError for a wrong parameter */
  outlineMaker(parameters: OutlineOptions & HatchingOutlineParameters): Promise<OutlineMaker>;
}

/** What all meshes of a scene share, so that lines continue from mesh to mesh. */
export interface SceneMeasures {
  tilesPerWorldUnit: number;
  /** The origin of the coordinate frame of engraved lines, in world space. */
  center: Vector3;
  /** Grows with the meshes that are added. */
  extent: SceneExtent;
}

/** A baked geometry, and what it was baked from. */
export interface BakedGeometry {
  geometry: BufferGeometry;
  /** The options of the bake and the versions of the source's attributes. */
  key: string;
  /** The other geometries of its bake, with their places; undefined if it was baked alone. */
  groupKey: string | undefined;
  positions: BufferAttribute;
}

/** What has been made for a look: further meshes get the same. */
export interface SceneStyle {
  /** The options, with those of the preset. */
  readonly options: ApplyHatchingOptions;
  /** The composition that the materials share. */
  readonly composition: HatchingComposition;
  /** The replacements of materials, keyed as `MaterialReplacer` does. */
  readonly replacements: Map<string, Replacement>;
  /** The maps of the styles that materials have named. */
  readonly maps: Map<StrokeStyleName, TonalArtMap | null>;
  outlineMaker: OutlineMaker | null;
  measures: SceneMeasures | null;
  /** Maps that were generated for this look. */
  readonly disposables: { dispose(): void }[];
}

/** One call that hatches meshes, as its steps share it. */
export interface HatchingCall {
  root: Object3D;
  makers: LookMakers;
  /** The options, with those of the preset, and the signal of this call. */
  options: ApplyHatchingOptions;
  choice: ChosenMeshes;
  /** The look of the meshes: a new one, or that of the meshes that are hatched already. */
  style: SceneStyle;
  /** Prepares frames, if the renderer is known. */
  firstFrame: FirstFrame | null;
  /** Makes outlines, if they are requested. */
  outlineMaker: OutlineMaker | null;
  /** Makes levels of detail, if they are requested. */
  detail: MakeLevels | null;
  /** Baked geometries, by their sources, which need no other bake if nothing has changed. */
  reusable: Map<BufferGeometry, BakedGeometry>;
  /** Whether an error is to be thrown if no mesh could be hatched. */
  mustHatch: boolean;
  /** Everything that was made: freed if the call fails. */
  disposables: { dispose(): void }[];
  /** Maps that were generated for this call. */
  madeMaps: { dispose(): void }[];
  /** Whether a mesh is not below the root at present. */
  isDetached(mesh: Mesh): boolean;
  /** The frame of engraved lines that a mesh has at present. */
  fieldFrameOf(mesh: Mesh): number[] | undefined;
  /** Takes over edits from the materials that new ones replace. */
  takeEdits(added: readonly Replacement[]): void;
  /** Runs a function while the meshes have the looks that they had before they were hatched. */
  asBefore<Result>(work: () => Result): Result;
}

/** The former looks of meshes, and the meshes that cannot be read. */
export interface OldLooks {
  seen: OldLook[];
  unreadable: SkippedMesh[];
}

/** New looks of meshes that are ready to be shown. */
export interface MadeLooks {
  looks: readonly MeshLook[];
  /** The replacements of all materials of these looks, new and known ones. */
  replacements: ReadonlyMap<string, Replacement>;
  /** The maps of all styles that materials name. */
  maps: ReadonlyMap<StrokeStyleName, TonalArtMap | null>;
  measures: SceneMeasures;
  /** Meshes that could not be hatched. */
  failed: readonly SkippedMesh[];
  /** The baked geometries, by their sources, if others may use them. */
  baked: ReadonlyMap<BufferGeometry, BakedGeometry>;
  /** The geometries that were made for this call. */
  geometries: Set<BufferGeometry>;
  /** Bakes form fields from now on, if lines follow the form anywhere. */
  forms: LaterForms | null;
  /** Starts to draw levels of detail. */
  showDetail: (() => HideDetail) | undefined;
}
