import { DirectionalLight, Mesh, PerspectiveCamera, Scene, TorusKnotGeometry, WebGLRenderer } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { HatchingMaterial, HatchingOutlines, prepareHatchingGeometry, presets } from 'three-hatching';

const canvas = document.querySelector('canvas')!;
const renderer = new WebGLRenderer({ canvas, antialias: true });
renderer.setClearColor('#f7f3e8');
renderer.setPixelRatio(devicePixelRatio);
renderer.shadowMap.enabled = true;

const material = new HatchingMaterial({ preset: 'pen' });
const knot = new TorusKnotGeometry(0.7, 0.24, 320, 40, 2, 3);
const mesh = new Mesh(await prepareHatchingGeometry(knot, { outlines: true }), material);
mesh.add(new HatchingOutlines(mesh, presets.pen.outlines));
mesh.castShadow = mesh.receiveShadow = true;

const light = new DirectionalLight(0xffffff, Math.PI);
light.position.set(-3, 4, 3);
light.castShadow = true;
light.shadow.normalBias = 0.02;
Object.assign(light.shadow.camera, { left: -1.2, right: 1.2, bottom: -1.2, top: 1.2 });

const scene = new Scene().add(mesh, light);
const camera = new PerspectiveCamera(30, 4 / 3, 0.1, 20);
camera.position.set(0, 0, 5);

// A frame is drawn only when something changes.
const draw = () => renderer.render(scene, camera);
// Its map of strokes is drawn in a worker.
material.ready.then(draw);
new OrbitControls(camera, canvas).addEventListener('change', draw);
new ResizeObserver(() => {
  renderer.setSize(canvas.clientWidth, canvas.clientHeight, false);
  draw();
}).observe(canvas);
