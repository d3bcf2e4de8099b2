import { Mesh } from 'three';
import type { HatchingTechnique, PrepareHatchingGeometryOptions } from 'three-hatching';
import { loadModel } from '../loadModel.js';
import { Stage } from '../Stage.js';
import { alternate, type Effort, type Side, type Times } from './alternate.js';
import { loadLibraries } from './loadLibraries.js';

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
      new HatchingMaterial({ tonalArtMap: await TonalArtMap.generate() }),
    );
  };
  const meshes = { old: await prepare('old'), new: await prepare('new') };
  const stage = new Stage(size);
  const times: Record<string, Times> = {};
  for (const technique of techniques) {
    for (const { material } of Object.values(meshes)) material.technique = technique;
    times[technique] = await alternate(effort, (side) => stage.timeFrame(meshes[side]));
  }
  return times;
}
