import { DirectionalLight, Mesh, PerspectiveCamera, Scene, SphereGeometry, WebGLRenderer } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { HatchingMaterial, HatchingOutlines, prepareHatchingGeometry, TonalArtMap } from 'three-hatching';

const SIZE = 512;

/** An image of curls that tiles. An image with more curls contains those of every image with fewer, so that none vanishes in the shade. */
async function drawCurls(count: number): Promise<File> {
  const sheet = new OffscreenCanvas(SIZE, SIZE);
  const pen = sheet.getContext('2d')!;
  pen.fillStyle = 'white';
  pen.fillRect(0, 0, SIZE, SIZE);
  pen.lineWidth = 4;
  pen.lineCap = 'round';
  for (let i = 0; i < count; i++) {
    // The curls are spread evenly, however many there are.
    const [x, y] = [SIZE * ((0.7549 * i) % 1), SIZE * ((0.5698 * i) % 1)];
    for (const [left, top] of [-SIZE, 0, SIZE].flatMap((left) => [-SIZE, 0, SIZE].map((top) => [left, top]))) {
      pen.beginPath();
      pen.arc(x + left - 8, y + top, 8, Math.PI, 2.1 * Math.PI);
      pen.moveTo(x + left, y + top);
      pen.arc(x + left + 8, y + top, 8, Math.PI, 0.1 * Math.PI, true);
      pen.stroke();
    }
  }
  return new File([await sheet.convertToBlob()], `${count}.png`);
}

// Images are sorted by darkness, and their coarser levels are made. You can load an artist's PNG files in the same way.
const tonalArtMap = await TonalArtMap.load(await Promise.all([30, 90, 200, 400, 800].map(drawCurls)));

const mesh = new Mesh(
  await prepareHatchingGeometry(new SphereGeometry(1, 96, 48), { outlines: true }),
  new HatchingMaterial({
    tonalArtMap,
    strokeWidth: 1.4,
    latticeSpacing: 0.6,
    ink: '#1d3550',
    paper: '#f7f3e8',
  }),
);
mesh.add(new HatchingOutlines(mesh, { outlineWidth: 1.8, ink: '#1d3550' }));

const canvas = document.querySelector('canvas')!;
const renderer = new WebGLRenderer({ canvas, antialias: true });
renderer.setClearColor('#f7f3e8');
renderer.setPixelRatio(devicePixelRatio);

const light = new DirectionalLight(0xffffff, Math.PI);
light.position.set(-3, 4, 4);

const scene = new Scene().add(mesh, light);
const camera = new PerspectiveCamera(30, 4 / 3, 0.1, 20);
camera.position.set(0, 0, 4.6);
const draw = () => renderer.render(scene, camera);
// The code of a technique is fetched with its first material.
mesh.material.ready.then(draw);
new OrbitControls(camera, canvas).addEventListener('change', draw);
new ResizeObserver(() => {
  renderer.setSize(canvas.clientWidth, canvas.clientHeight, false);
  draw();
}).observe(canvas);
