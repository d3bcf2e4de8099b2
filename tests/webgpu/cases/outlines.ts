import { BoxGeometry, type BufferGeometry, MeshBasicMaterial, TorusKnotGeometry } from 'three';
import { HatchingOutlines, prepareHatchingGeometry } from 'three-hatching';
import { HatchingOutlines as NodeOutlines } from '../../../src/webgpu/outlines/HatchingOutlines.js';
import { knot } from '../knot.js';
import type { Kit, SceneCase, Stage } from '../SceneCase.js';

type Look = NonNullable<ConstructorParameters<typeof HatchingOutlines>[1]> &
  NonNullable<ConstructorParameters<typeof NodeOutlines>[1]>;

/** A mesh of one tone and its outlines. */
async function outlined({ either }: Kit, look: Look, geometry: BufferGeometry): Promise<ReturnType<typeof knot>> {
  const stage = knot(new MeshBasicMaterial({ color: 0xfff4dd }));
  stage.mesh.geometry = await prepareHatchingGeometry(geometry, { outlines: true });
  stage.mesh.add(
    either(
      () => new HatchingOutlines(stage.mesh, look),
      () => new NodeOutlines(stage.mesh, look),
    ),
  );
  return stage;
}

const ofKnot = (): BufferGeometry => new TorusKnotGeometry(0.62, 0.24, 96, 20);

const show =
  (look: Look, geometry = ofKnot, arrange?: (stage: ReturnType<typeof knot>) => void) =>
  async (kit: Kit): Promise<Stage> => {
    const stage = await outlined(kit, look, geometry());
    arrange?.(stage);
    return stage;
  };

export const cases: readonly SceneCase[] = [
  { name: 'a knot', show: show({ outlineWidth: 3 }) },
  {
    name: 'creases and borders of a box',
    show: show(
      { outlineWidth: 4, overshoot: 6 },
      () => {
        const box = new BoxGeometry(1.2, 0.9, 0.8);
        // Without its last side it has borders.
        box.setIndex([...box.getIndex()!.array].slice(0, 30));
        return box;
      },
      ({ mesh }) => mesh.rotation.set(0.5, 0.6, 0.2),
    ),
  },
];
