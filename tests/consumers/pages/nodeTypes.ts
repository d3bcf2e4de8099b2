/** Compiled, never run: what draws with WebGPURenderer, as a strict consumer's compiler sees it. */
import { BoxGeometry, DirectionalLight, Mesh, MeshBasicMaterial, PerspectiveCamera, Scene } from 'three';
import { WebGPURenderer } from 'three/webgpu';
import { prepareHatchingGeometry } from 'three-hatching';
import {
  applyHatching,
  type HatchedNodeScene,
  HatchingNodeMaterial,
  HatchingOutlineNodeMaterial,
  HatchingOutlines,
} from 'three-hatching/webgpu';

export async function outlinedBox(): Promise<{ renderer: WebGPURenderer; scene: Scene }> {
  const geometry = await prepareHatchingGeometry(new BoxGeometry(), { outlines: true });
  const mesh = new Mesh(geometry, new MeshBasicMaterial());
  const material = new HatchingOutlineNodeMaterial({ outlineWidth: 2 });
  material.overshoot = 3;
  const outlines = new HatchingOutlines(mesh, material);
  outlines.material.ink.set('#222');
  // @ts-expect-error: a width is a number.
  outlines.material.outlineWidth = 'thick';
  mesh.add(outlines);
  return { renderer: new WebGPURenderer(), scene: new Scene().add(mesh) };
}

export async function engravedScene(): Promise<HatchedNodeScene> {
  const material = new HatchingNodeMaterial({ preset: 'engraving', lineSpacing: 5 });
  material.lineField = 'y';
  material.ink.set('#222');
  // @ts-expect-error: there is no such field.
  material.lineField = 'round';
  const scene = new Scene().add(new Mesh(new BoxGeometry(), material), new DirectionalLight());
  const hatched = await applyHatching(scene, { material: { technique: 'engraved' }, outlines: true });
  hatched.materials[0].crossFrom = 0.4;
  hatched.outlines[0].material.outlineWidth = 3;
  const again = await applyHatching(scene, { replaces: hatched });
  await new WebGPURenderer().compileAsync(scene, new PerspectiveCamera());
  return again;
}
