import {
  BoxGeometry,
  type BufferGeometry,
  ConeGeometry,
  CylinderGeometry,
  Mesh,
  MeshBasicMaterial,
  PerspectiveCamera,
  PlaneGeometry,
  Scene,
  WebGLRenderer,
} from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { applyHatching } from 'three-hatching';

const paper = '#fdfbf5';
const canvas = document.querySelector('canvas')!;
const renderer = new WebGLRenderer({ canvas, antialias: true });
renderer.setClearColor(paper);
renderer.setPixelRatio(devicePixelRatio);

const parts: BufferGeometry[] = [new PlaneGeometry(5, 5).rotateX(-Math.PI / 2)];
for (const [x, z, height] of [
  [-1, -1, 2],
  [1, -1, 1.6],
  [-1, 1, 1.4],
  [1, 1, 1.8],
]) {
  parts.push(new CylinderGeometry(0.34, 0.4, height, 48).translate(x, height / 2, z));
  parts.push(new ConeGeometry(0.5, 0.8, 48).translate(x, height + 0.4, z));
}
for (const turn of [0, 1, 2, 3]) {
  parts.push(new BoxGeometry(2, 1, 0.16).translate(0, 0.5, 1).rotateY((turn * Math.PI) / 2));
  for (const x of [-0.4, 0, 0.4]) {
    parts.push(new BoxGeometry(0.22, 0.2, 0.16).translate(x, 1.1, 1).rotateY((turn * Math.PI) / 2));
  }
}
parts.push(
  new BoxGeometry(0.44, 0.6, 0.2).translate(0, 0.3, 1),
  new BoxGeometry(0.9, 1.7, 0.9).translate(0, 0.85, -0.2),
);
parts.push(new ConeGeometry(0.8, 0.9, 4).rotateY(Math.PI / 4).translate(0, 2.15, -0.2));

const material = new MeshBasicMaterial();
const scene = new Scene().add(...parts.map((part) => new Mesh(part, material)));

// Without a map, and with a tone curve that prints nothing, surfaces are blank paper that hides the outlines behind it.
await applyHatching(scene, {
  tonalArtMap: null,
  material: {
    paper,
    toneCurve: [
      [0, 0],
      [1, 0],
    ],
  },
  outlines: {
    outlineWidth: 2.2,
    wobble: 0.7,
    overshoot: 3,
    weights: { creases: 0.8, lit: 1, shade: 1 },
    ink: '#1c1a17',
  },
});

const camera = new PerspectiveCamera(26, 4 / 3, 0.1, 40);
camera.position.set(4.4, 3.6, 7.4);
const draw = () => renderer.render(scene, camera);
const controls = new OrbitControls(camera, canvas);
controls.target.set(0, 0.9, 0);
controls.addEventListener('change', draw);
controls.update();
new ResizeObserver(() => {
  renderer.setSize(canvas.clientWidth, canvas.clientHeight, false);
  draw();
}).observe(canvas);
