import type { Camera, Material, Mesh, WebGLRenderer } from 'three';
import type { PresetName } from '../look/presetMaterials.js';
import type { HatchingMaterialParameters } from '../material/checkValues.js';
import type {
  OutlineOptions,
  PrepareHatchingGeometryOptions,
} from '../material/geometry/PrepareHatchingGeometryOptions.js';
import type { HatchingShadowOptions } from '../material/groups/ownedProperties.js';
import type { HatchingOutlineParameters } from '../material/outlines/HatchingOutlineMaterial.js';
import type { TonalArtMap } from '../material/tam/TonalArtMap.js';
import type { MapDrawing } from '../strokes/tamImages/hatchImageOptions.js';
import type { DetailOptions } from './levelMaker.js';

/** A complete look: the material, outlines and tonal art map, in the form of the options of `applyHatching`. */
export interface HatchingPreset {
  /** The parameters of the material, including ink and paper. */
  readonly material: Readonly<HatchingMaterialParameters>;
  /** The options and parameters of the outlines. */
  readonly outlines: Readonly<OutlineOptions & HatchingOutlineParameters>;
  /** What a `HatchingShadowMaterial` adds to `material` for shadows on a ground. */
  readonly shadow?: Readonly<Partial<HatchingShadowOptions>>;
  /** The options of `TonalArtMap.generate`; `null` if the preset needs no map. */
  readonly tonalArtMap: Readonly<MapDrawing> | null;
}

/** Options of `applyHatching`. They include those of `prepareHatchingGeometry`, which apply to every mesh. */
export interface ApplyHatchingOptions
  extends Omit<PrepareHatchingGeometryOptions, 'orient' | 'outlines' | 'technique'> {
  /**
   * The preset to start from, by name or as an object: it sets the material, outlines and map. The other options override it; the
   * parameters in `material` and `outlines` do so one by one. Default: no preset.
   */
  preset?: PresetName | HatchingPreset | undefined;
  /** What presets say of shadows on a ground, for a `HatchingShadowMaterial` of yours; `applyHatching` itself makes no ground. */
  shadow?: HatchingPreset['shadow'] | undefined;
  /**
   * The tonal art map for those materials that need one and have none among their parameters: your own map, the options of
   * `TonalArtMap.generate`, or a function that resolves with your own map. The function is called with a progress listener while
   * geometries are prepared, and only if a material needs a map. With `null` the meshes stay blank paper until you set a map. Default:
   * the map of the style that the material names, `hatching` unless its parameters name another. The map of a style without further
   * options is shared (`TonalArtMap.shared`); a map that is generated for this call is freed by `dispose()` of the result.
   */
  tonalArtMap?:
    | TonalArtMap
    | MapDrawing
    | ((onProgress: (progress: number) => void) => Promise<TonalArtMap>)
    | null
    | undefined;
  /**
   * Parameters of the new materials. They override what is copied from the old materials. A function is called once for every
   * new material, with the material that it replaces and the first mesh that uses it.
   */
  material?: HatchingMaterialParameters | ((source: Material, mesh: Mesh) => HatchingMaterialParameters) | undefined;
  /**
   * The size of the strokes, in tiles of the map per world unit, which is the same on small and large objects. A `tilesPerObjectUnit` among
   * the parameters of the materials, in contrast, is per unit of object space. Default: 3 divided by the radius of the whole scene.
   */
  tilesPerWorldUnit?: number | undefined;
  /**
   * Draws contours, borders and creases: every mesh gets a child of the class `HatchingOutlines`. Pass `true`, or an object that
   * says which edges are creases (`OutlineOptions`) and how the outlines look (the properties of `HatchingOutlineMaterial`). Default: no
   * outlines.
   */
  outlines?: boolean | (OutlineOptions & HatchingOutlineParameters) | undefined;
  /**
   * The renderer that will draw the scene. With it and `camera` the promise, and its progress, include the work that would delay the
   * first frame: the compilation of programs, beside the preparation of geometries, and the upload. The root and the lights must be in
   * the scene already. Default: the first frame does all that.
   */
  renderer?: WebGLRenderer | undefined;
  /** The camera that will draw the scene with `renderer`. Its layers decide which lights count. */
  camera?: Camera | undefined;
  /**
   * Draws meshes of more than 200,000 triangles with no more triangles than can be seen: simpler levels of the baked mesh, which
   * deviate from it by at most a third of a pixel in any view. It needs meshoptimizer, whose address you pass. Instances, batches, and
   * meshes that deform or have several materials or adjacency are drawn whole, and so are meshes whose form field is still being baked.
   * Default: all meshes are drawn whole.
   */
  detail?: DetailOptions | undefined;
  /** Returns whether to hatch a mesh. Default: all meshes are hatched. */
  filter?: ((mesh: Mesh) => boolean) | undefined;
  /**
   * Called with the progress, from 0 to 1, of form fields that are baked after the first picture: those of geometries of more than
   * 200,000 triangles, and those whose `crossAngle` was changed. See `formReady` of the result.
   */
  onFormProgress?: ((progress: number) => void) | undefined;
  /**
   * Called whenever a frame must be drawn because lines change by themselves: while they change over to the form, for half a second.
   * Pass it if frames are drawn on demand.
   */
  invalidate?: (() => void) | undefined;
  /** Called whenever a geometry is finished, with the number of finished geometries and the total. Several are baked at a time. */
  onGeometry?: ((done: number, total: number) => void) | undefined;
}
