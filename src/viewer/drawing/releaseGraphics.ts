import type { DirectionalLight, InstancedMesh, Material, Object3D, SkinnedMesh, Texture } from 'three';

/**
 * Disposes of the GPU resources of objects while the context is lost; they are uploaded again when drawn. If they were disposed of after
 * the context is restored, three.js would delete them in a context that never had them.
 */
export function releaseGraphics(root: Object3D): void {
  root.traverse((object) => {
    const { geometry, material, skeleton } = object as Partial<SkinnedMesh>;
    geometry?.dispose();
    for (const one of material ? [material].flat() : []) releaseMaterial(one);
    // The skeleton's bone texture is created again at the next rendering.
    skeleton?.dispose();
    if ('isLight' in object) (object as DirectionalLight).shadow?.dispose();
    // The event makes the renderer free its copy; the instances keep their data.
    if ('isInstancedMesh' in object) (object as InstancedMesh).dispatchEvent({ type: 'dispose' });
  });
}

/** As {@link releaseGraphics}, for a material and its textures. */
export function releaseMaterial(material: Material): void {
  material.dispose();
  for (const texture of texturesOf(material)) texture.dispose();
}

/** As {@link releaseGraphics}, for objects that will not be drawn again: closes their bitmaps too. */
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
