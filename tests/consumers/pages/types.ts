/** Compiled, never run: the declarations of the packed library, as a strict consumer's compiler sees them. */
import { BoxGeometry, Mesh } from 'three';
import { HatchingMaterial, prepareHatchingGeometry, type TaskOptions, TonalArtMap } from 'three-hatching';

export async function hatchedBox(options: TaskOptions): Promise<Mesh<BoxGeometry, HatchingMaterial>> {
  const tonalArtMap: TonalArtMap = await TonalArtMap.generate({ style: 'hatching', seed: 7, ...options });
  const material = new HatchingMaterial({ tonalArtMap, technique: 'adjacency', ink: '#222' });
  material.strokeAngle = Math.PI / 2;
  const size: number = tonalArtMap.size;
  material.perTriangle.strokeOffset.set(size, 0);
  // @ts-expect-error: an unknown technique is refused.
  material.technique = 'scribble';
  // @ts-expect-error: so is a number as style; neither is `any`.
  await TonalArtMap.generate({ style: 3 });
  return new Mesh((await prepareHatchingGeometry(new BoxGeometry(), options)) as BoxGeometry, material);
}
