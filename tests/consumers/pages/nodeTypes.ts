/** Compiled, never run: what draws with WebGPURenderer, as a strict consumer's compiler sees it. */
import {
  BoxGeometry,
  type BufferGeometry,
  DirectionalLight,
  InstancedMesh,
  Mesh,
  MeshBasicMaterial,
  PerspectiveCamera,
  Plane,
  Scene,
  SkinnedMesh,
  Vector3,
} from 'three';
import { mrt, normalView, output, pass } from 'three/tsl';
import { ClippingGroup, RenderPipeline, WebGPURenderer } from 'three/webgpu';
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
  material.direction = 'y';
  material.ink.set('#222');
  // @ts-expect-error: there is no such field.
  material.direction = 'round';
  const scene = new Scene().add(new Mesh(new BoxGeometry(), material), new DirectionalLight());
  const hatched = await applyHatching(scene, { material: { technique: 'engraving' }, outlines: true });
  hatched.materials[0].crossFrom = 0.4;
  hatched.outlines[0].material.outlineWidth = 3;
  const again: HatchedNodeScene = await hatched.setPreset({ preset: 'pen', outlines: false });
  await new WebGPURenderer().compileAsync(scene, new PerspectiveCamera());
  return again;
}

/** Meshes of every kind, each with a material of nodes and outlines. */
export async function everyKind(): Promise<Scene> {
  const geometry: BufferGeometry = await prepareHatchingGeometry(new BoxGeometry(), { outlines: true });
  const material = new HatchingNodeMaterial({
    technique: 'engraving',
    ink: 0x224466,
    composition: { focus: new Vector3() },
  });
  const mesh: Mesh<BufferGeometry, HatchingNodeMaterial> = new Mesh(geometry, material);
  mesh.material.lineSpacing = 6;
  mesh.material = material.clone();
  const scene = new Scene().add(mesh);
  for (const other of [new SkinnedMesh(geometry, material), new InstancedMesh(geometry, material, 3)]) {
    other.add(new HatchingOutlines(other, { outlineWidth: 2, hidden: 'dashed', ink: '#000' }));
    scene.add(other);
  }
  const outlines = new HatchingOutlines();
  const clone: HatchingOutlines = outlines.clone();
  clone.mesh = mesh;
  clone.material.weights.shade = 2;
  const shared: HatchingOutlineNodeMaterial = clone.material;
  scene.add(clone, new HatchingOutlines(mesh, shared));
  // @ts-expect-error: there is no such property.
  material.setValues({ lineSpacng: 3 });
  // @ts-expect-error: outlines have a material of outlines.
  outlines.material = material;
  await material.ready;
  outlines.dispose();
  return scene;
}

/** The surroundings of a scene. */
export async function drawn(renderer: WebGPURenderer, scene: Scene, camera: PerspectiveCamera): Promise<void> {
  const hatched = await applyHatching(scene, 'pen');
  const material: HatchingNodeMaterial = hatched.materials[0];
  material.preset = 'chalk';
  // @ts-expect-error: the renderer is asked to compile afterwards.
  await applyHatching(scene, { renderer });
  const group = new ClippingGroup();
  group.clippingPlanes = [new Plane(new Vector3(0, 1, 0), 0.5)];
  scene.add(group);
  const both = pass(scene, camera);
  both.setMRT(mrt({ output, normal: normalView }));
  await renderer.compileAsync(scene, camera);
  new RenderPipeline(renderer, both.getTextureNode('output')).render();
  hatched.dispose();
}
