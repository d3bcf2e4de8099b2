import { DirectionalLight, Mesh, PerspectiveCamera, PlaneGeometry, Scene, WebGLRenderer } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import {
  HatchingMaterial,
  HatchingOutlines,
  type HatchingPreset,
  prepareHatchingGeometry,
  presets,
  TonalArtMap,
} from 'three-hatching';

/** Red chalk on warm paper: strokes across the folds, crossed by others in their depth. */
const sanguine: HatchingPreset = {
  material: {
    ...presets.pencil.material,
    strokeWidth: 2.4,
    strokeAngle: 0.4 * Math.PI,
    softness: 0.85,
    smudge: 0.3,
    ink: '#94351b',
    paper: '#f3e6cf',
  },
  outlines: { outlineWidth: 2, wobble: 1, ink: '#94351b' },
  tonalArtMap: { style: 'hatching', seed: 4 },
};

const canvas = document.querySelector('canvas')!;
const renderer = new WebGLRenderer({ canvas, antialias: true });
renderer.setClearColor(sanguine.material.paper!);
renderer.setPixelRatio(devicePixelRatio);
renderer.shadowMap.enabled = true;

// A cloth that hangs from two nails: folds run out from each, deeper and wider the farther they are.
const cloth = new PlaneGeometry(3.2, 2.4, 300, 220);
const { position } = cloth.attributes;
for (let i = 0; i < position.count; i++) {
  const [x, y] = [position.getX(i), position.getY(i)];
  let fold = 0;
  for (const side of [-1, 1]) {
    const [across, down] = [x - 1.1 * side, 1.25 - y];
    const angle = Math.atan2(across, down);
    const depth = Math.exp(-((across / 1.3) ** 2)) * Math.min(1, Math.hypot(across, down));
    fold += depth * (0.13 * Math.sin(13 * angle + 1.3 * side) + 0.05 * Math.sin(29 * angle));
  }
  const sag =
    0.3 * Math.exp(-((x / 0.7) ** 2)) * (1 - 0.4 * (1.2 - y)) - 0.16 * Math.exp(-(((Math.abs(x) - 1.1) / 0.16) ** 2));
  position.setXYZ(i, x, y - sag, fold);
}
cloth.computeVertexNormals();

const { material, outlines, tonalArtMap } = sanguine;
const mesh = new Mesh(
  await prepareHatchingGeometry(cloth, { outlines: true, form: true }),
  new HatchingMaterial({ ...material, tonalArtMap: await TonalArtMap.generate(tonalArtMap!) }),
);
mesh.add(new HatchingOutlines(mesh, outlines));
mesh.castShadow = mesh.receiveShadow = true;

const light = new DirectionalLight(0xffffff, Math.PI);
light.position.set(-3, 2, 1.8);
light.castShadow = true;
light.shadow.normalBias = 0.03;

const scene = new Scene().add(mesh, light);
const camera = new PerspectiveCamera(30, 4 / 3, 0.1, 20);
camera.position.set(0.3, -0.1, 5.6);
const draw = () => renderer.render(scene, camera);
// The code of dry media is fetched when it is first used.
mesh.material.ready.then(draw);
const controls = new OrbitControls(camera, canvas);
controls.target.set(0, -0.2, 0);
controls.addEventListener('change', draw);
controls.update();
new ResizeObserver(() => {
  renderer.setSize(canvas.clientWidth, canvas.clientHeight, false);
  draw();
}).observe(canvas);
