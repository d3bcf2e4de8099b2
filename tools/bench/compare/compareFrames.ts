import { Mesh } from 'three';
import type {
  HatchingMaterial,
  HatchingMaterialParameters,
  HatchingTechnique,
  PrepareHatchingGeometryOptions,
} from 'three-hatching';
import { plainLook } from '../../plainLook.js';
import { loadModel } from '../loadModel.js';
import { Stage } from '../Stage.js';
import { alternate, type Effort, type Side, type Times } from './alternate.js';
import { type Library, loadLibraries } from './loadLibraries.js';

/** Names that libraries had before; null for a value that they had where nothing was set. */
const FORMER_NAMES: Readonly<Record<string, string | null>> = {
  screenSpaceShare: 'screenConstancy',
  strokeWidth: null,
};

/** The plain look of a technique, in the names that a library knows: defaults differ from commit to commit. */
function lookOf(
  { HatchingMaterial: Material }: Library,
  technique: HatchingTechnique,
  { tonalArtMap }: HatchingMaterial,
): HatchingMaterialParameters {
  const look = plainLook({ technique, tonalArtMap });
  const isFormer = !('screenSpaceShare' in Material.prototype);
  const named = Object.entries(look).flatMap(([name, value]) => {
    const known = isFormer && name in FORMER_NAMES ? FORMER_NAMES[name] : name;
    return known === null ? [] : [[known, value]];
  });
  return Object.fromEntries(named);
}

/** Frames of both libraries, by technique. */
export async function compareFrames(
  model: string,
  layout: PrepareHatchingGeometryOptions['layout'],
  techniques: readonly HatchingTechnique[],
  effort: Effort,
  size: number,
): Promise<Record<string, Times>> {
  const libraries = await loadLibraries();
  const source = await loadModel(model);
  const prepare = async (side: Side) => {
    const { prepareHatchingGeometry, HatchingMaterial, TonalArtMap } = libraries[side];
    return new Mesh(
      await prepareHatchingGeometry(source, { layout }),
      new HatchingMaterial({ tonalArtMap: await TonalArtMap.generate(), technique: 'adjacency' }),
    );
  };
  const meshes = { old: await prepare('old'), new: await prepare('new') };
  const stage = new Stage(size);
  const times: Record<string, Times> = {};
  for (const technique of techniques) {
    for (const side of ['old', 'new'] as const) {
      const { material } = meshes[side];
      material.setValues(lookOf(libraries[side], technique, material));
      // Older versions have all code at once.
      await material.ready;
    }
    times[technique] = await alternate(effort, (side) => stage.timeFrame(meshes[side]));
  }
  return times;
}
