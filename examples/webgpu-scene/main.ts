import {
  BoxGeometry,
  CylinderGeometry,
  DirectionalLight,
  HemisphereLight,
  Mesh,
  MeshStandardMaterial,
  PerspectiveCamera,
  PlaneGeometry,
  Scene,
  SphereGeometry,
  TorusGeometry,
} from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { WebGPURenderer } from 'three/webgpu';
import { type PresetName, presets } from 'three-hatching';
import { applyHatching, type HatchedNodeScene } from 'three-hatching/webgpu';

const canvas = document.querySelector('canvas')!;
const renderer = new WebGPURenderer({ canvas, antialias: true });
renderer.setPixelRatio(devicePixelRatio);
renderer.shadowMap.enabled = true;
await renderer.init();

const scene = new Scene();
const solids = [
  new SphereGeometry(0.5, 64, 48),
  new BoxGeometry(0.8, 0.8, 0.8),
  new CylinderGeometry(0.35, 0.35, 1, 64),
];
for (const [i, geometry] of [...solids, new TorusGeometry(0.4, 0.15, 32, 96)].entries()) {
  const mesh = new Mesh(geometry, new MeshStandardMaterial({ color: ['#bbb', '#789', '#a86', '#ddd'][i] }));
  mesh.position.set(1.1 * (i % 2) - 0.55, 0, 1.2 * Math.floor(i / 2) - 0.6);
  mesh.castShadow = mesh.receiveShadow = true;
  scene.add(mesh);
}
const ground = new Mesh(new PlaneGeometry(8, 8), new MeshStandardMaterial());
ground.rotation.x = -Math.PI / 2;
ground.position.y = -0.5;
ground.receiveShadow = true;

const light = new DirectionalLight(0xffffff, 2.4);
light.position.set(-3, 4, 2);
light.castShadow = true;
light.shadow.normalBias = 0.02;
Object.assign(light.shadow.camera, { left: -3, right: 3, bottom: -3, top: 3 });
scene.add(ground, light, new HemisphereLight(0xffffff, 0x888888, 0.6));

const camera = new PerspectiveCamera(30, 4 / 3, 0.1, 20);
camera.position.set(0.6, 2.4, 5.4);
camera.lookAt(0, -0.1, 0);

const draw = () => renderer.render(scene, camera);
let hatched: HatchedNodeScene | undefined;

async function show(preset: PresetName) {
  hatched = await (hatched?.setPreset(preset) ?? applyHatching(scene, preset));
  renderer.setClearColor(hatched.background);
  await renderer.compileAsync(scene, camera);
  draw();
}

const choice = document.createElement('select');
choice.ariaLabel = 'Preset';
choice.append(...Object.keys(presets).map((name) => new Option(name)));
choice.addEventListener('change', () => show(choice.value as PresetName));
choice.value = 'engraving';
canvas.after(choice);

await show('engraving');
const controls = new OrbitControls(camera, canvas);
controls.target.set(0, -0.1, 0);
controls.addEventListener('change', draw);
new ResizeObserver(() => {
  renderer.setSize(canvas.clientWidth, canvas.clientHeight, false);
  draw();
}).observe(canvas);
