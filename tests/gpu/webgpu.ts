/** Draws a hatched scene with three's other renderer, on its WebGL 2 backend, which needs no WebGPU. */
import { BoxGeometry, DirectionalLight, Mesh, MeshStandardMaterial, PerspectiveCamera, Scene } from 'three';
import { WebGPURenderer } from 'three/webgpu';
import { applyHatching } from 'three-hatching';

async function drawWithWebGPURenderer(outlines: boolean): Promise<number> {
  const mesh = new Mesh(new BoxGeometry(), new MeshStandardMaterial());
  const scene = new Scene().add(mesh, new DirectionalLight());
  const camera = new PerspectiveCamera(40, 1, 0.1, 10);
  camera.position.z = 4;
  await applyHatching(scene, { preset: 'technical', outlines });
  let calls = 0;
  // The user's own handler must still be called.
  mesh.onBeforeRender = () => {
    calls++;
  };
  const renderer = new WebGPURenderer({ forceWebGL: true });
  renderer.setSize(64, 64);
  await renderer.init();
  for (let i = 0; i < 3; i++) {
    renderer.render(scene, camera);
    await new Promise((go) => requestAnimationFrame(go));
  }
  renderer.dispose();
  return calls;
}

declare global {
  interface Window {
    drawWithWebGPURenderer: typeof drawWithWebGPURenderer;
  }
}
window.drawWithWebGPURenderer = drawWithWebGPURenderer;
