import { DirectionalLight, PerspectiveCamera, Scene, WebGLRenderer } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { applyHatching, flatteringLight } from 'three-hatching';

const canvas = document.querySelector('canvas')!;
const renderer = new WebGLRenderer({ canvas, antialias: true });
renderer.setClearColor('#f7f3e8');
renderer.setPixelRatio(devicePixelRatio);
renderer.shadowMap.enabled = true;

const gltf = await new GLTFLoader().loadAsync('../models/still-life.glb');
gltf.scene.traverse((object) => {
  object.castShadow = object.receiveShadow = true;
});

// Every mesh is baked, and every material is replaced; colours and maps are taken over.
await applyHatching(gltf.scene, 'crossHatching');

const light = new DirectionalLight(0xffffff, Math.PI);
light.castShadow = true;
light.shadow.normalBias = 0.02;
light.shadow.mapSize.set(2048, 2048);
Object.assign(light.shadow.camera, { left: -2, right: 2, bottom: -2, top: 2 });

const scene = new Scene().add(gltf.scene, light);
const camera = new PerspectiveCamera(26, 4 / 3, 0.1, 30);
camera.position.set(1, 2.2, 6.2);

const draw = () => renderer.render(scene, camera);
const controls = new OrbitControls(camera, canvas);
controls.target.set(0.22, 0.62, 0);
controls.addEventListener('change', draw);
controls.update();

// A light that suits the first view, from the model to the sun.
light.position.copy(flatteringLight(gltf.scene, camera).direction).multiplyScalar(5);

new ResizeObserver(() => {
  renderer.setSize(canvas.clientWidth, canvas.clientHeight, false);
  draw();
}).observe(canvas);
