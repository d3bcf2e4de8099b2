import { MeshPhongMaterial } from 'three';
import { MeshPhongNodeMaterial } from 'three/webgpu';
import { knot } from '../knot.js';
import type { SceneCase } from '../SceneCase.js';

/** Differences that the comparison must notice. */
export const cases: readonly SceneCase[] = [
  {
    name: 'another colour',
    show: ({ either }) =>
      knot(
        either(
          () => new MeshPhongMaterial({ color: 0xcc8866 }),
          () => new MeshPhongNodeMaterial({ color: 0xcc8888 }),
        ),
      ),
  },
];
