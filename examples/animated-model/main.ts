import { AnimationMixer, DirectionalLight, PerspectiveCamera, Scene, Timer, WebGLRenderer } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { applyHatching } from 'three-hatching';

const canvas = document.querySelector('canvas')!;
const renderer = new WebGLRenderer({ canvas, antialias: true });
renderer.setClearColor('#f7f3e8');
renderer.setPixelRatio(devicePixelRatio);

const { scene: fish, animations } = await new GLTFLoader().loadAsync('../models/fish.glb');
await applyHatching(fish, 'engraving');

const mixer = new AnimationMixer(fish);
mixer.clipAction(animations[0]).play();
mixer.update(0.4);

const light = new DirectionalLight(0xffffff, Math.PI);
light.position.set(-2, 3, 0.4);

const scene = new Scene().add(fish, light);
const camera = new PerspectiveCamera(30, 4 / 3, 0.1, 20);
camera.position.set(-1.8, 0.7, 2.75);
new OrbitControls(camera, canvas);

new ResizeObserver(() => {
  renderer.setSize(canvas.clientWidth, canvas.clientHeight, false);
}).observe(canvas);

const isStill = matchMedia('(prefers-reduced-motion: reduce)');
const timer = new Timer();
renderer.setAnimationLoop((time) => {
  timer.update(time);
  if (!isStill.matches) mixer.update(timer.getDelta());
  renderer.render(scene, camera);
});
