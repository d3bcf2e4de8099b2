import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { fitModel } from '../../viewer/files/mesh/fitModel.js';
import type { PlainMesh } from '../../viewer/files/mesh/PlainMesh.js';
import { mergeScene } from '../../viewer/files/scenes/mergeScene.js';
import handUrl from './assets/hand.glb?url';

/** A right hand in its rest pose, with fingers up and its back to the viewer. */
export async function loadHand(): Promise<PlainMesh> {
  const { scene } = await new GLTFLoader().loadAsync(handUrl);
  const mesh = mergeScene(scene);
  fitModel(mesh);
  const { positions, normals } = mesh;
  // In the file, the fingers point down and the back of the hand faces x.
  for (const triples of [positions, normals]) {
    for (let i = 0; triples && i < triples.length; i += 3) {
      const [x, y, z] = triples.subarray(i, i + 3) as unknown as [number, number, number];
      triples.set([z, -y, x], i);
    }
  }
  return mesh;
}
