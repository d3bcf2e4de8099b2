import {
  DirectionalLight,
  LatheGeometry,
  Mesh,
  PerspectiveCamera,
  Scene,
  SplineCurve,
  Vector2,
  WebGLRenderer,
} from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import {
  HatchingMaterial,
  HatchingOutlines,
  type HatchingPreset,
  prepareHatchingGeometry,
  presets,
  scalePreset,
} from 'three-hatching';

/** The size of the print in pixels: 10 × 7.5 cm at 300 dpi. */
const DPI = 300;
const PRINT = { width: Math.round((10 / 2.54) * DPI), height: Math.round((7.5 / 2.54) * DPI) };
/** CSS pixels per inch. Sizes are in CSS pixels. */
const CSS_DPI = 96;

const radii = [0.001, 0.34, 0.36, 0.28, 0.44, 0.62, 0.66, 0.54, 0.34, 0.22, 0.21, 0.27, 0.38];
const profile = new SplineCurve(radii.map((radius, i) => new Vector2(radius, 0.17 * Math.max(0, i - 1) - 0.9)));
const vase = new LatheGeometry(profile.getPoints(120), 96);
const material = new HatchingMaterial({ preset: 'engraving' });
const mesh = new Mesh(await prepareHatchingGeometry(vase, { outlines: true }), material);
const outlines = new HatchingOutlines(mesh);
mesh.add(outlines);

const light = new DirectionalLight(0xffffff, Math.PI);
light.position.set(-3, 3, 4);
const scene = new Scene().add(mesh, light);
const camera = new PerspectiveCamera(30, 4 / 3, 0.1, 20);
camera.position.set(0, 1, 4.6);

function setLook(preset: HatchingPreset) {
  material.setValues(preset.material);
  outlines.material.setValues(preset.outlines);
}

const canvas = document.querySelector('canvas')!;
const renderer = new WebGLRenderer({ canvas, antialias: true });
renderer.setClearColor('#f7f3e8');

function draw() {
  renderer.setPixelRatio(devicePixelRatio);
  renderer.setSize(canvas.clientWidth, canvas.clientHeight, false);
  setLook(presets.engraving);
  renderer.render(scene, camera);
}

document.querySelector('button')!.addEventListener('click', () => {
  renderer.setPixelRatio(1);
  renderer.setSize(PRINT.width, PRINT.height, false);
  // All widths are the same in centimetres on paper and on the screen.
  setLook(scalePreset(presets.engraving, DPI / CSS_DPI));
  renderer.render(scene, camera);
  // The pixels must be read in the same task, because the drawing buffer is not preserved.
  canvas.toBlob((png) => {
    const link = document.createElement('a');
    link.href = URL.createObjectURL(png!);
    link.download = 'vase.png';
    link.click();
    URL.revokeObjectURL(link.href);
  });
  draw();
});
// The code of its technique is fetched when it is first used.
material.ready.then(draw);
new OrbitControls(camera, canvas).addEventListener('change', draw);
new ResizeObserver(draw).observe(canvas);
