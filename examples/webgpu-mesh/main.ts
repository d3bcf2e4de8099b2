import { DirectionalLight, Mesh, PerspectiveCamera, Scene, TorusKnotGeometry } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { WebGPURenderer } from 'three/webgpu';
import { prepareHatchingGeometry, presets } from 'three-hatching';
import { HatchingNodeMaterial, HatchingOutlines } from 'three-hatching/webgpu';

const canvas = document.querySelector('canvas')!;
const renderer = new WebGPURenderer({ canvas, antialias: true });
renderer.setClearColor('#f7f3e8');
renderer.setPixelRatio(devicePixelRatio);
await renderer.init();

const material = new HatchingNodeMaterial({ preset: 'pen' });
const knot = new TorusKnotGeometry(0.7, 0.24, 320, 40, 2, 3);
const mesh = new Mesh(await prepareHatchingGeometry(knot, { outlines: true, form: true }), material);
mesh.add(new HatchingOutlines(mesh, presets.pen.outlines));

const light = new DirectionalLight(0xffffff, Math.PI);
light.position.set(-3, 4, 3);

const scene = new Scene().add(mesh, light);
const camera = new PerspectiveCamera(30, 4 / 3, 0.1, 20);
camera.position.set(0, 0, 5);
await Promise.all([material.ready, renderer.compileAsync(scene, camera)]);

// A frame is drawn only when something changes.
const draw = () => renderer.render(scene, camera);
new OrbitControls(camera, canvas).addEventListener('change', draw);
new ResizeObserver(() => {
  renderer.setSize(canvas.clientWidth, canvas.clientHeight, false);
  draw();
}).observe(canvas);
