import type { Material, Mesh } from 'three';
import type { LineOptions, PrepareHatchingGeometryOptions } from '../geometry/prepareHatchingGeometry.js';
import type { HatchingLineParameters } from '../lines/HatchingLineMaterial.js';
import type { HatchingMaterialParameters } from '../material/HatchingMaterialParameters.js';
import type { MapDrawing, TonalArtMap } from '../tam/TonalArtMap.js';
import type { HatchedScene } from './HatchedScene.js';
import type { HatchingPreset, PresetName } from './presets.js';

/** Options of `applyHatching`, beside those of `prepareHatchingGeometry`, which hold for every mesh. */
export interface ApplyHatchingOptions extends Omit<PrepareHatchingGeometryOptions, 'lines'> {
  /**
   * A look to start from, by its name or as an object: material, lines and map. What the other options say counts before it,
   * parameters of `material` and `lines` one by one. Default: none.
   */
  preset?: PresetName | HatchingPreset | undefined;
  /**
   * What an earlier call made of the same scene, or of a part of it. It is drawn until the new look is ready, and is then disposed
   * of: the scene never shows its own materials in between. Default: nothing; the scene must not be hatched.
   */
  replaces?: HatchedScene | undefined;
  /**
   * The map for materials that need one and whose parameters name none: a map of yours, what `TonalArtMap.generate` is to draw,
   * or a function that resolves with a map of yours and is called only if a material needs it. By default one in the style
   * `hatching` is drawn. `dispose()` of the result frees what was drawn. `null`: none for now; the meshes stay blank paper until
   * you set one.
   */
  tonalArtMap?: TonalArtMap | MapDrawing | (() => Promise<TonalArtMap>) | null | undefined;
  /**
   * Parameters of the new materials. They override what is taken over from the old ones. A function is called once for every
   * material made, with the material it replaces and the first mesh that uses it.
   */
  material?: HatchingMaterialParameters | ((source: Material, mesh: Mesh) => HatchingMaterialParameters) | undefined;
  /**
   * Size of the strokes: tiles of the map per world unit, the same on small and large objects. The default is 3 divided by the
   * radius of the whole scene. A `strokeScale` among the materials' parameters counts per unit of object space instead.
   */
  strokeScale?: number | undefined;
  /**
   * Draws contours, borders and creases: gives every mesh a child, `HatchingLines`. `true`, or which edges are creases
   * (`LineOptions`) and how lines look (the properties of `HatchingLineMaterial`). Default: no lines.
   */
  lines?: boolean | (LineOptions & HatchingLineParameters) | undefined;
  /** Which meshes to hatch. Default: all. */
  filter?: ((mesh: Mesh) => boolean) | undefined;
  /** Called whenever a geometry is done, with how many are, and how many there are. Several are baked at a time. */
  onGeometry?: ((done: number, total: number) => void) | undefined;
}
