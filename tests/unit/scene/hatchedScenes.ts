import type { Mesh, Object3D } from 'three';
import { expect } from 'vitest';
import { HatchingMaterial } from '../../../src/material/HatchingMaterial.js';
import { TonalArtMap } from '../../../src/material/tam/TonalArtMap.js';

export const tonalArtMap = TonalArtMap.fromHatchImages({
  size: 4,
  images: [255, 128, 0].map((v) => [new Uint8Array(16).fill(v)]),
});

export const hatched = (mesh: Mesh): HatchingMaterial => {
  expect(mesh.material).toBeInstanceOf(HatchingMaterial);
  return mesh.material as HatchingMaterial;
};

/** Everything that hatching could change, by identity. */
export const looksOf = (root: Object3D) => {
  const looks: unknown[] = [];
  root.traverse((object) => {
    if ('geometry' in object) looks.push(object, object.geometry, (object as Mesh).material);
  });
  return looks;
};

/** Counts the `dispose` events of whatever `watch` is given. */
export function disposals() {
  let count = 0;
  const onDispose = () => {
    count++;
  };
  return {
    watch: (things: { addEventListener(type: 'dispose', listener: () => void): void }[]) => {
      for (const thing of things) thing.addEventListener('dispose', onDispose);
    },
    get count() {
      return count;
    },
  };
}
