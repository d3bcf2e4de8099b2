import { MeshPhongMaterial, PCFShadowMap } from 'three';
import { MeshPhongNodeMaterial } from 'three/webgpu';
import { knot, shadowed } from '../knot.js';
import type { SceneCase } from '../SceneCase.js';

/** three's own materials, which show how much the renderers themselves differ. */
export const cases: readonly SceneCase[] = [
  {
    name: 'Phong',
    show: ({ either }) => {
      const look = { color: 0xcc8866, shininess: 40 };
      return knot(
        either(
          () => new MeshPhongMaterial(look),
          () => new MeshPhongNodeMaterial(look),
        ),
      );
    },
  },
  {
    name: 'Phong under a shadow',
    most: 0.001,
    shadows: PCFShadowMap,
    show: ({ either }) =>
      shadowed(
        knot(
          either(
            () => new MeshPhongMaterial(),
            () => new MeshPhongNodeMaterial(),
          ),
        ),
      ),
  },
];
