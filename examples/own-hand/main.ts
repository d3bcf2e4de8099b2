import { DirectionalLight, Mesh, PerspectiveCamera, Scene, TorusKnotGeometry, WebGLRenderer } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import {
  type Hand,
  type HandStroke,
  HatchingMaterial,
  HatchingOutlines,
  learnHand,
  prepareHatchingGeometry,
  TonalArtMap,
} from 'three-hatching';
import { exampleHand } from 'three-hatching/hands';

/** The width of the swatch, in millimetres. */
const SWATCH = 40;

const material = new HatchingMaterial({ strokeWidth: 2.2, paper: '#f7f3e8' });
const geometry = await prepareHatchingGeometry(new TorusKnotGeometry(0.8, 0.3, 240, 48), { outlines: true });
const mesh = new Mesh(geometry, material);
mesh.position.set(0.3, -0.1, 0);
mesh.add(new HatchingOutlines(mesh));
const light = new DirectionalLight(0xffffff, Math.PI);
light.position.set(-3, 3, 4);
const scene = new Scene().add(mesh, light);
const camera = new PerspectiveCamera(30, 4 / 3, 0.1, 20);
camera.position.set(0, 1, 6);

const canvas = document.querySelector<HTMLCanvasElement>('.drawing')!;
const renderer = new WebGLRenderer({ canvas, antialias: true });
renderer.setClearColor('#f7f3e8');

function draw() {
  renderer.setPixelRatio(devicePixelRatio);
  renderer.setSize(canvas.clientWidth, canvas.clientHeight, false);
  renderer.render(scene, camera);
}

let latest: TonalArtMap | undefined;

/** Hatches with a hand. Its map is drawn in a worker, and shown if no other was asked for meanwhile. */
async function hatch(hand: Hand) {
  const map = TonalArtMap.draw({ hand });
  latest = map;
  await map.ready;
  if (map !== latest) return map.dispose();
  const { tonalArtMap: former } = material;
  material.tonalArtMap = map;
  if (former instanceof TonalArtMap) former.dispose();
  draw();
}

// The strokes of the swatch. Pens tell their pressure; others draw with the same width everywhere.
const swatch = document.querySelector<HTMLCanvasElement>('.swatch')!;
const pen = swatch.getContext('2d')!;
let strokes: HandStroke[] = [];
let points: number[] = [];
let widths: number[] = [];

function clear() {
  strokes = [];
  swatch.width = swatch.height = 2 * swatch.clientWidth;
  pen.scale(swatch.width / SWATCH, swatch.width / SWATCH);
  pen.lineCap = 'round';
}

swatch.addEventListener('pointerdown', (event) => {
  swatch.setPointerCapture(event.pointerId);
  points = [];
  widths = [];
});
swatch.addEventListener('pointermove', (event) => {
  if (!swatch.hasPointerCapture(event.pointerId)) return;
  const scale = SWATCH / swatch.clientWidth;
  for (const { offsetX, offsetY, pressure, pointerType } of event.getCoalescedEvents()) {
    const [x, y] = [scale * offsetX, scale * offsetY];
    const width = pointerType === 'pen' ? 0.15 + 0.9 * pressure : 0.5;
    if (points.length > 0) {
      pen.lineWidth = width;
      pen.beginPath();
      pen.moveTo(points.at(-2)!, points.at(-1)!);
      pen.lineTo(x, y);
      pen.stroke();
    }
    points.push(x, y);
    widths.push(width);
  }
});
swatch.addEventListener('lostpointercapture', () => {
  if (widths.length > 1) strokes.push({ points, widths });
  if (strokes.length >= 5) hatch(learnHand(strokes));
});
document.querySelector('button')!.addEventListener('click', () => {
  clear();
  hatch(exampleHand('finePen'));
});

clear();
await hatch(exampleHand('finePen'));
new OrbitControls(camera, canvas).addEventListener('change', draw);
new ResizeObserver(draw).observe(canvas);
