import {
  Bone,
  BoxGeometry,
  DataTexture,
  DirectionalLight,
  Group,
  InstancedMesh,
  Mesh,
  MeshStandardMaterial,
  Skeleton,
  SkinnedMesh,
  Texture,
  WebGLRenderTarget,
} from 'three';
import { HatchingMaterial } from 'three-hatching';
import { describe, expect, test } from 'vitest';
import { freeGraphics, releaseGraphics, releaseMaterial } from '../../../../src/viewer/drawing/materials.js';

/** The names of those that were told to dispose of what they have. */
function watch(things: Record<string, { addEventListener(type: 'dispose', listener: () => void): void }>): string[] {
  const disposed: string[] = [];
  for (const [name, thing] of Object.entries(things)) thing.addEventListener('dispose', () => disposed.push(name));
  return disposed;
}

describe('what a scene has on the graphics card', () => {
  test('is disposed of: geometries, materials, textures, bones, instances and shadows, also of what is hidden', () => {
    const map = new Texture();
    const material = new MeshStandardMaterial({ map });
    const skinned = new SkinnedMesh(new BoxGeometry(), material);
    skinned.bind(new Skeleton([new Bone()]));
    skinned.skeleton.computeBoneTexture();
    const { boneTexture } = skinned.skeleton;
    const instances = new InstancedMesh(new BoxGeometry(), material, 2);
    const hidden = new Mesh(new BoxGeometry(), [new MeshStandardMaterial(), new HatchingMaterial()]);
    hidden.visible = false;
    const sun = new DirectionalLight();
    sun.shadow.map = new WebGLRenderTarget(1, 1);
    const things = {
      map,
      material,
      geometry: skinned.geometry,
      bones: boneTexture!,
      instances,
      first: hidden.material[0],
      second: hidden.material[1],
      shadow: sun.shadow.map,
    };
    const disposed = watch(things);
    releaseGraphics(new Group().add(skinned, instances, hidden, sun));
    expect(new Set(disposed)).toEqual(new Set(Object.keys(things)));
    // It can be drawn again.
    expect(material.map).toBe(map);
    expect(instances.count).toBe(2);
  });

  test('of a hatching material are the textures among its uniforms too', () => {
    const material = new HatchingMaterial();
    const map = new DataTexture();
    material.map = map;
    const own = new DataTexture();
    material.uniforms.own = { value: own };
    const disposed = watch({ map, own });
    releaseMaterial(material);
    expect(disposed.sort()).toEqual(['map', 'own']);
  });

  test('closes its bitmaps only if it will not be drawn again', () => {
    let closed = 0;
    const map = new Texture({ close: () => closed++ } as never);
    const root = new Group().add(new Mesh(new BoxGeometry(), new MeshStandardMaterial({ map })));
    releaseGraphics(root);
    expect(closed).toBe(0);
    freeGraphics(root);
    expect(closed).toBe(1);
  });
});
