import { Mesh, TorusGeometry } from 'three';
import { HatchingMaterial, type PrepareHatchingGeometryOptions, prepareHatchingGeometry } from 'three-hatching';
import { plainLook } from '../../plainLook.js';
import { loadModel } from '../loadModel.js';
import { Stage } from '../Stage.js';

const SIZE = 64;

/**
 * The additional milliseconds of a frame that uploads the geometry to the graphics card, measured `repeats`
 * times. The program is compiled before, and only one triangle is drawn, although all of the geometry is uploaded.
 */
export async function measureUpload(
  model: string,
  layout: PrepareHatchingGeometryOptions['layout'],
  repeats: number,
): Promise<{ bytes: number; times: number[] }> {
  const stage = new Stage(SIZE);
  const material = new HatchingMaterial(plainLook({ technique: 'hatching' }));
  stage.drawFrame(new Mesh(await prepareHatchingGeometry(new TorusGeometry(), { layout }), material));
  const geometry = await prepareHatchingGeometry(await loadModel(model), { layout });
  geometry.setDrawRange(0, 3);
  const mesh = new Mesh(geometry, material);
  const times = Array.from({ length: repeats }, () => {
    const time = stage.drawFrame(mesh) - stage.drawFrame(mesh);
    geometry.dispose();
    return Math.max(0, time);
  });
  return { bytes: geometry.userData.hatching.bytes, times };
}
