import {
  DirectionalLight,
  Group,
  Mesh,
  MeshLambertMaterial,
  PerspectiveCamera,
  Scene,
  TorusGeometry,
  WebGLRenderer,
} from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { applyHatching } from 'three-hatching';
// The policy of this page forbids workers from blob: URLs, so the worker is a file from the same server.
// This is the import for Vite; docs/recipes.md says more.
import BakeWorker from 'three-hatching/bake.worker?worker';

/** One function for all calls: the library knows its workers by it. */
const createWorker = () => new BakeWorker();

const canvas = document.querySelector('canvas')!;
const renderer = new WebGLRenderer({ canvas, antialias: true });
renderer.setClearColor('#f7f3e8');
renderer.setPixelRatio(devicePixelRatio);

const rings = new Group();
for (const [x, turn] of [
  [-0.85, 0.5],
  [0, Math.PI / 2 + 0.5],
  [0.85, 0.5],
]) {
  const ring = new Mesh(new TorusGeometry(0.6, 0.18, 40, 96).rotateX(turn), new MeshLambertMaterial());
  ring.position.x = x;
  rings.add(ring);
}
await applyHatching(rings, { preset: 'engraving', createWorker });

const light = new DirectionalLight(0xffffff, Math.PI);
light.position.set(-3, 4, 3);
const scene = new Scene().add(rings, light);
const camera = new PerspectiveCamera(30, 4 / 3, 0.1, 20);
camera.position.set(0, 0.6, 5);
const draw = () => renderer.render(scene, camera);
new OrbitControls(camera, canvas).addEventListener('change', draw);
new ResizeObserver(() => {
  renderer.setSize(canvas.clientWidth, canvas.clientHeight, false);
  draw();
}).observe(canvas);
