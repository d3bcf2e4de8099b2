/** Compiled, never run: what draws with WebGPURenderer, as a strict consumer's compiler sees it. */
import { BoxGeometry, Mesh, MeshBasicMaterial, Scene } from 'three';
import { WebGPURenderer } from 'three/webgpu';
import { prepareHatchingGeometry } from 'three-hatching';
import { HatchingOutlineNodeMaterial, HatchingOutlines } from 'three-hatching/webgpu';

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
