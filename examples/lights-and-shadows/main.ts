import {
  ConeGeometry,
  Mesh,
  MeshLambertMaterial,
  PerspectiveCamera,
  PlaneGeometry,
  Scene,
  SphereGeometry,
  SpotLight,
  TorusGeometry,
  WebGLRenderer,
} from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { RoundedBoxGeometry } from 'three/addons/geometries/RoundedBoxGeometry.js';
import { applyHatching } from 'three-hatching';

const canvas = document.querySelector('canvas')!;
const renderer = new WebGLRenderer({ canvas, antialias: true });
renderer.setClearColor('#f7f3e8');
renderer.setPixelRatio(devicePixelRatio);
renderer.shadowMap.enabled = true;

const material = new MeshLambertMaterial();
const solids = [
  new SphereGeometry(0.6, 64, 32).translate(0, 0.6, 0.5),
  new RoundedBoxGeometry(1, 1, 1, 4, 0.04).rotateY(0.5).translate(-1.35, 0.5, -0.5),
  new ConeGeometry(0.55, 1.5, 64, 8).translate(1.25, 0.75, -0.4),
  new TorusGeometry(0.38, 0.14, 24, 64).rotateX(-Math.PI / 2).translate(1.35, 0.14, 0.95),
  new PlaneGeometry(40, 40, 100, 100).rotateX(-Math.PI / 2),
];
const scene = new Scene();
for (const solid of solids) {
  const mesh = new Mesh(solid, material);
  mesh.castShadow = mesh.receiveShadow = true;
  scene.add(mesh);
}

await applyHatching(scene, {
  preset: 'pen',
  // Shadows have their own strokes.
  material: { shadowStrokes: 'cross' },
});

/** A lamp. The intensities of all lamps sum to π. */
function lamp(x: number, y: number, z: number, intensity: number) {
  const light = new SpotLight(0xffffff, intensity, 0, 0.8, 1, 0);
  light.position.set(x, y, z);
  light.castShadow = true;
  light.shadow.normalBias = 0.02;
  light.shadow.mapSize.set(2048, 2048);
  light.shadow.camera.near = 1;
  return light;
}
scene.add(lamp(-4, 5, 4, 0.6 * Math.PI), lamp(5, 5, 2, 0.4 * Math.PI));

const camera = new PerspectiveCamera(26, 4 / 3, 0.1, 40);
camera.position.set(0, 3.6, 7.6);
const draw = () => renderer.render(scene, camera);
const controls = new OrbitControls(camera, canvas);
controls.target.set(0, 0.5, 0);
controls.addEventListener('change', draw);
controls.update();
new ResizeObserver(() => {
  renderer.setSize(canvas.clientWidth, canvas.clientHeight, false);
  draw();
}).observe(canvas);
