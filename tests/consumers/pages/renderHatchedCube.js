import { BoxGeometry, DirectionalLight, Mesh, PerspectiveCamera, Scene, WebGLRenderer } from 'three';
import { HatchingMaterial, prepareHatchingGeometry, TonalArtMap } from 'three-hatching';

const SIZE = 96;

/**
 * What every consumer does: bakes a cube, draws a map, renders, reads the pixels back.
 *
 * @param {{ createWorker?: () => Worker }} options
 * @returns {Promise<number[]>} the red channel of every pixel
 */
export async function renderHatchedCube({ createWorker } = {}) {
  const [geometry, tonalArtMap] = await Promise.all([
    prepareHatchingGeometry(new BoxGeometry(), { createWorker }),
    TonalArtMap.generate({ size: 64, tones: 4, createWorker }),
  ]);
  const mesh = new Mesh(geometry, new HatchingMaterial({ tonalArtMap, tilesPerUnit: 1 }));
  mesh.rotation.set(0.5, 0.6, 0);
  const sun = new DirectionalLight(0xffffff, Math.PI);
  sun.position.set(2, 1, 1);
  const scene = new Scene().add(mesh, sun);
  const camera = new PerspectiveCamera(30, 1, 0.1, 10);
  camera.position.z = 3.5;

  const renderer = new WebGLRenderer();
  renderer.setClearColor(0xffffff);
  renderer.setSize(SIZE, SIZE, false);
  document.body.append(renderer.domElement);
  renderer.render(scene, camera);
  const gl = renderer.getContext();
  const pixels = new Uint8Array(SIZE * SIZE * 4);
  gl.readPixels(0, 0, SIZE, SIZE, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  return Array.from({ length: SIZE * SIZE }, (_, i) => pixels[4 * i]);
}
