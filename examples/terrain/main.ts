import { DirectionalLight, Mesh, PerspectiveCamera, PlaneGeometry, Scene, WebGLRenderer } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { ImprovedNoise } from 'three/addons/math/ImprovedNoise.js';
import { HatchingMaterial, HatchingOutlines, prepareHatchingGeometry, presets, type ToneCurve } from 'three-hatching';

const canvas = document.querySelector('canvas')!;
const renderer = new WebGLRenderer({ canvas, antialias: true });
renderer.setClearColor('#f7f3e8');
renderer.setPixelRatio(devicePixelRatio);

/** The tone curve, from light to ink: lines are thin even in full light. */
const TONES: ToneCurve = [
  [0, 0.1],
  [0.4, 0.16],
  [0.8, 0.6],
  [1, 0.85],
];
const noise = new ImprovedNoise();
/** Ridges: noise folded at 0, in octaves, each of which is smaller and lower than the previous one. */
function heightAt(x: number, z: number): number {
  let height = 0;
  for (let octave = 0, size = 2; octave < 4; octave++, size /= 2) {
    height += size * (1 - 2 * Math.abs(noise.noise(x / size, z / size, 7.3 + octave)));
  }
  return 0.6 * Math.max(0, height - 0.9) * Math.exp(-(x * x + z * z) / 5);
}

const ground = new PlaneGeometry(14, 14, 400, 400).rotateX(-Math.PI / 2);
const { position } = ground.attributes;
for (let i = 0; i < position.count; i++) position.setY(i, heightAt(position.getX(i), position.getZ(i)));
ground.computeVertexNormals();

// With 'y', lines follow the height, as contour lines on a map do. They need no tonal art map.
const mesh = new Mesh(
  await prepareHatchingGeometry(ground, { outlines: true }),
  new HatchingMaterial({ preset: 'engraving', direction: 'y', toneCurve: TONES, crossFrom: 0.75 }),
);
mesh.add(new HatchingOutlines(mesh, { ...presets.engraving.outlines, weights: { creases: 0, borders: 0 } }));

const light = new DirectionalLight(0xffffff, Math.PI);
light.position.set(-4, 2.6, 0.5);

const scene = new Scene().add(mesh, light);
const camera = new PerspectiveCamera(26, 4 / 3, 0.1, 40);
camera.position.set(0, 2.2, 7);
const draw = () => renderer.render(scene, camera);
// The code of its technique is fetched when it is first used.
mesh.material.ready.then(draw);
const controls = new OrbitControls(camera, canvas);
controls.target.set(0, 0.3, 0);
controls.addEventListener('change', draw);
controls.update();
new ResizeObserver(() => {
  renderer.setSize(canvas.clientWidth, canvas.clientHeight, false);
  draw();
}).observe(canvas);
