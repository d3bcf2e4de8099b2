import {
  DirectionalLight,
  Mesh,
  MeshStandardMaterial,
  PerspectiveCamera,
  Scene,
  TorusKnotGeometry,
  WebGLRenderer,
} from 'three';
import { applyHatching } from 'three-hatching';

const scene = new Scene().add(new Mesh(new TorusKnotGeometry(1, 0.4, 64, 8), new MeshStandardMaterial()));
const camera = new PerspectiveCamera(40, 1, 0.1, 20);
camera.position.z = 5;
const renderer = new WebGLRenderer({ preserveDrawingBuffer: true });
renderer.setClearColor(0xffffff);
renderer.setSize(128, 128, false);
document.body.append(renderer.domElement);

window.isHatching = true;

// The three lines of the README.
scene.add(new DirectionalLight(0xffffff, Math.PI));
await applyHatching(scene, 'pen');
renderer.setAnimationLoop(() => renderer.render(scene, camera));
