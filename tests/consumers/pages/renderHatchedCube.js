import { BoxGeometry, DirectionalLight, Mesh, PerspectiveCamera, Scene, WebGLRenderer } from 'three';
import { HatchingMaterial, prepareHatchingGeometry, TonalArtMap } from 'three-hatching';

const SIZE = 96;

/**
 * The task of every consumer: bakes a cube, draws a map, renders, reads the pixels back, before and after the code of the technique is there.
 *
 * @param {{ createWorker?: () => Worker }} options
 * @returns {Promise<number[]>} the red channel of every pixel
 */
export async function renderHatchedCube({ createWorker } = {}) {
  const [geometry, tonalArtMap] = await Promise.all([
    prepareHatchingGeometry(new BoxGeometry(), { adjacency: true, createWorker }),
    TonalArtMap.generate({ size: 64, tones: 4, createWorker }),
  ]);
  // The code of the technique is loaded later, from its own file.
  const material = new HatchingMaterial({ technique: 'adjacency', tonalArtMap, tilesPerObjectUnit: 1 });
  const mesh = new Mesh(geometry, material);
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
  const draw = () => {
    renderer.render(scene, camera);
    const gl = renderer.getContext();
    const pixels = new Uint8Array(SIZE * SIZE * 4);
    gl.readPixels(0, 0, SIZE, SIZE, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
    return Array.from({ length: SIZE * SIZE }, (_, i) => pixels[4 * i]);
  };
  const before = draw();
  if (before.some((red) => red < 255)) throw new Error('Before its code is there, the cube is not white paper.');
  await material.ready;
  return draw();
}
