import { Group, Mesh, MeshStandardMaterial, PlaneGeometry } from 'three';
import type { PresetName } from 'three-hatching';
import { loadModel } from '../loadModel.js';
import { Stage } from '../Stage.js';
import { alternate, type Effort, type Side, type Times } from './alternate.js';
import { type Library, loadLibraries } from './loadLibraries.js';

/** Frames of presets in both libraries, by preset: a model with outlines, shadows and occlusion, its shadow on the ground. */
export async function compareLooks(
  model: string,
  names: readonly PresetName[],
  effort: Effort,
  size: number,
): Promise<Record<string, Times>> {
  const libraries = await loadLibraries();
  const source = await loadModel(model);
  const times: Record<string, Times> = {};
  for (const name of names) {
    const scenes = { old: await sceneOf(libraries.old, source, name), new: await sceneOf(libraries.new, source, name) };
    const stage = new Stage(size, true);
    // Lists of contours come from the worker, and code is fetched: what is timed is a scene at rest.
    for (const side of ['old', 'new'] as const) await settle(stage, scenes[side].root);
    times[name] = await alternate(effort, (side: Side) => stage.timeFrame(scenes[side].root));
    for (const { dispose } of Object.values(scenes)) dispose();
  }
  return times;
}

const SETTLING_FRAMES = 4;
const SETTLING_PAUSE = 400;

async function settle(stage: Stage, root: Group): Promise<void> {
  for (let i = 0; i < SETTLING_FRAMES; i++) {
    await stage.timeFrame(root);
    await new Promise((resolve) => setTimeout(resolve, SETTLING_PAUSE));
  }
}

async function sceneOf(
  { applyHatching, bakeOcclusion, HatchingShadowMaterial, prepareHatchingGeometry, presets }: Library,
  source: Awaited<ReturnType<typeof loadModel>>,
  name: PresetName,
): Promise<{ root: Group; dispose(): void }> {
  const subject = new Mesh(source.clone(), new MeshStandardMaterial());
  subject.castShadow = subject.receiveShadow = true;
  const root = new Group().add(subject);
  const hatched = await applyHatching(subject, {
    ...presets[name],
    material: { ...presets[name].material, shadowStrokes: 'cross' },
  });
  await hatched.formReady;
  const occlusion = await bakeOcclusion(root);
  const [{ tonalArtMap }] = hatched.materials;
  const material = new HatchingShadowMaterial({ preset: name, tonalArtMap, depthWrite: false });
  await material.ready;
  const plane = new PlaneGeometry(6, 6, 8, 8).rotateX(-Math.PI / 2);
  const ground = new Mesh(await prepareHatchingGeometry(plane), material);
  ground.position.y = -0.7;
  ground.receiveShadow = true;
  root.add(ground);
  return {
    root,
    dispose: () => {
      occlusion.dispose();
      hatched.dispose();
      ground.geometry.dispose();
      material.dispose();
    },
  };
}
