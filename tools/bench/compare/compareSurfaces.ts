import { Mesh, MeshStandardMaterial } from 'three';
import { loadModel } from '../loadModel.js';
import { type LookName, lookOptions } from '../presets/lookOptions.js';
import { Stage } from '../Stage.js';
import { alternate, type Effort, type Times } from './alternate.js';
import { loadLibraries } from './loadLibraries.js';

/** Frames of a model as `applyHatching` of both libraries makes it, without outlines. */
export async function compareSurfaces(model: string, look: LookName, effort: Effort, size: number): Promise<Times> {
  const libraries = await loadLibraries();
  const source = await loadModel(model);
  const hatch = async ({ applyHatching }: typeof libraries.old): Promise<Mesh> => {
    const mesh = new Mesh(source.clone(), new MeshStandardMaterial());
    const { formReady } = await applyHatching(mesh, lookOptions(look), { outlines: false });
    await formReady;
    return mesh;
  };
  const meshes = { old: await hatch(libraries.old), new: await hatch(libraries.new) };
  const stage = new Stage(size);
  return alternate(effort, (side) => stage.timeFrame(meshes[side]));
}
