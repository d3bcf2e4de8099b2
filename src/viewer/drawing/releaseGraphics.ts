import type { DirectionalLight, InstancedMesh, Material, Object3D, SkinnedMesh, Texture } from 'three';

/**
 * Disposes of what objects have on the graphics card; they upload it again when they are drawn. To be called while the context is
 * lost. three.js remembers what it uploaded also when the context has come back: disposed of later, that would be deleted in a
 * context that has never seen it.
 */
export function releaseGraphics(root: Object3D): void {
  root.traverse((object) => {
    const { geometry, material, skeleton } = object as Partial<SkinnedMesh>;
    geometry?.dispose();
    for (const one of material ? [material].flat() : []) releaseMaterial(one);
    // The texture that it keeps its bones in is made again when they are drawn.
    skeleton?.dispose();
    if ('isLight' in object) (object as DirectionalLight).shadow?.dispose();
    // The instances keep their data; the event only tells the renderer that uploaded them.
    if ('isInstancedMesh' in object) (object as InstancedMesh).dispatchEvent({ type: 'dispose' });
  });
}

/** As {@link releaseGraphics}, for a material and its textures. */
export function releaseMaterial(material: Material): void {
  material.dispose();
  for (const texture of texturesOf(material)) texture.dispose();
}

/** As {@link releaseGraphics}, for objects that will not be drawn again: their pictures are given back at once. */
export function freeGraphics(root: Object3D): void {
  releaseGraphics(root);
  root.traverse((object) => {
    const { material } = object as Partial<SkinnedMesh>;
    for (const one of material ? [material].flat() : []) {
      for (const { image } of texturesOf(one)) (image as Partial<ImageBitmap> | null)?.close?.();
    }
  });
}

function texturesOf(material: Material): Texture[] {
  const { uniforms = {} } = material as { uniforms?: Record<string, { value: unknown }> };
  const values: unknown[] = [...Object.values(material), ...Object.values(uniforms).map(({ value }) => value)];
  return values.filter(isTexture);
}

const isTexture = (value: unknown): value is Texture =>
  typeof value === 'object' && value !== null && 'isTexture' in value && value.isTexture === true;
