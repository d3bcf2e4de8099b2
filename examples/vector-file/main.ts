import {
  DirectionalLight,
  Mesh,
  MeshLambertMaterial,
  PerspectiveCamera,
  Scene,
  TorusKnotGeometry,
  WebGLRenderer,
} from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { applyHatching } from 'three-hatching';
import { drawSVG } from 'three-hatching/svg';

const knot = new Mesh(new TorusKnotGeometry(0.8, 0.3, 240, 48), new MeshLambertMaterial());
const light = new DirectionalLight(0xffffff, Math.PI);
light.position.set(-3, 3, 4);
const scene = new Scene().add(knot, light);
const camera = new PerspectiveCamera(30, 4 / 3, 0.1, 20);
camera.position.set(0, 1, 6);

const canvas = document.querySelector('canvas')!;
const renderer = new WebGLRenderer({ canvas, antialias: true });
renderer.setClearColor('#f7f3e8');

function draw() {
  renderer.setPixelRatio(devicePixelRatio);
  renderer.setSize(canvas.clientWidth, canvas.clientHeight, false);
  renderer.render(scene, camera);
}

const button = document.querySelector('button')!;
button.addEventListener('click', async () => {
  button.disabled = true;
  // A sheet in millimetres. For a plotter: { kind: 'pen', penWidth: 0.3 }.
  const { svg } = await drawSVG(scene, camera, { sheet: [120, 90], margin: 4 });
  const link = document.createElement('a');
  link.href = URL.createObjectURL(new Blob([svg], { type: 'image/svg+xml' }));
  link.download = 'knot.svg';
  link.click();
  URL.revokeObjectURL(link.href);
  button.disabled = false;
});
await applyHatching(scene, 'engraving');
draw();
new OrbitControls(camera, canvas).addEventListener('change', draw);
new ResizeObserver(draw).observe(canvas);
