import {
  type BufferGeometry,
  CatmullRomCurve3,
  DirectionalLight,
  Group,
  LatheGeometry,
  Mesh,
  MeshStandardMaterial,
  PerspectiveCamera,
  Scene,
  SphereGeometry,
  TubeGeometry,
  Vector2,
  Vector3,
  WebGLRenderer,
} from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { applyHatching, type PresetName } from 'three-hatching';

// A lamp of three parts, each with a material of its own, as a file would have them.
const lathe = (...radii: [number, number][]) =>
  new LatheGeometry(
    radii.map(([x, y]) => new Vector2(x, y)),
    64,
  );
const shades: Record<string, () => BufferGeometry> = {
  cone: () => lathe([0.78, 0.95], [0.3, 1.75], [0.26, 1.75], [0.74, 0.95], [0.78, 0.95]),
  globe: () => new SphereGeometry(0.55, 64, 48).translate(0, 1.4, 0),
  drum: () => lathe([0.62, 0.95], [0.55, 1.65], [0.51, 1.65], [0.58, 0.95], [0.62, 0.95]),
};
const bends = [
  [0.4, 0.2],
  [0.9, 0.5],
  [1.2, 0.1],
  [1.7, 0.3],
].map(([x, z]) => new Vector3(x, 0.03, z));
const foot = new Mesh(
  lathe([0, 0], [0.5, 0], [0.5, 0.06], [0.16, 0.16], [0.09, 0.3], [0.17, 0.5], [0.07, 0.72], [0.05, 1.2], [0, 1.2]),
  new MeshStandardMaterial(),
);
const cord = new Mesh(new TubeGeometry(new CatmullRomCurve3(bends), 80, 0.03, 12), new MeshStandardMaterial());
let shade = new Mesh(shades.cone(), new MeshStandardMaterial());

const light = new DirectionalLight(0xffffff, Math.PI);
light.position.set(-2, 3, 3);
const lamp = new Group().add(foot, cord, shade);
const scene = new Scene().add(lamp, light);
const camera = new PerspectiveCamera(32, 4 / 3, 0.1, 20);
camera.position.set(0.4, 1.8, 4.6);

const canvas = document.querySelector('canvas')!;
const renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true });
renderer.setPixelRatio(devicePixelRatio);
const choice = (name: string) => document.querySelector<HTMLInputElement>(`[name=${name}]`)!;

const hatched = await applyHatching(lamp, 'pen');
const draw = () => {
  renderer.setClearColor(hatched.background);
  renderer.render(scene, camera);
};

// A colour: the materials of the model stay the truth.
choice('color').addEventListener('input', ({ currentTarget }) => {
  shade.material.color.set((currentTarget as HTMLInputElement).value);
  draw();
});

// Hide a part.
choice('cord').addEventListener('change', ({ currentTarget }) => {
  cord.visible = (currentTarget as HTMLInputElement).checked;
  draw();
});

// Fade a part: its strokes, and its outlines with them.
choice('opacity').addEventListener('input', ({ currentTarget }) => {
  shade.material.opacity = (currentTarget as HTMLInputElement).valueAsNumber;
  shade.material.transparent = shade.material.opacity < 1;
  draw();
});

// Swap a part: the old one is drawn until the new one is hatched. Of two choices in a row the later one wins.
let swap = new AbortController();
choice('shade').addEventListener('change', async ({ currentTarget }) => {
  swap.abort();
  swap = new AbortController();
  const { signal } = swap;
  const next = new Mesh(shades[(currentTarget as HTMLSelectElement).value](), shade.material);
  next.visible = false;
  lamp.add(next);
  try {
    await hatched.update({ signal });
  } catch (error) {
    next.removeFromParent();
    if (signal.aborted) return;
    throw error;
  }
  next.visible = true;
  shade.removeFromParent();
  hatched.release(shade);
  shade.geometry.dispose();
  shade = next;
  draw();
});

// Another look, in place: colours, opacity and hidden parts stay as they were chosen.
let change = new AbortController();
choice('look').addEventListener('change', async ({ currentTarget }) => {
  change.abort();
  change = new AbortController();
  const { signal } = change;
  try {
    await hatched.setPreset((currentTarget as HTMLSelectElement).value as PresetName, { signal });
  } catch (error) {
    if (signal.aborted) return;
    throw error;
  }
  draw();
});

// A picture with a clear ground.
choice('save').addEventListener('click', () => {
  renderer.setClearColor(hatched.background, 0);
  renderer.render(scene, camera);
  canvas.toBlob((blob) => {
    const link = document.createElement('a');
    link.href = URL.createObjectURL(blob!);
    link.download = 'lamp.png';
    link.click();
    URL.revokeObjectURL(link.href);
  });
  draw();
});

// Free all of it.
choice('free').addEventListener('click', () => {
  controls.dispose();
  resized.disconnect();
  hatched.dispose();
  for (const { geometry, material } of [foot, cord, shade]) {
    geometry.dispose();
    material.dispose();
  }
  renderer.dispose();
  document.querySelector('form')!.inert = true;
});

const controls = new OrbitControls(camera, canvas);
controls.target.set(0.4, 0.85, 0);
controls.addEventListener('change', draw);
controls.update();
const resized = new ResizeObserver(() => {
  renderer.setSize(canvas.clientWidth, canvas.clientHeight, false);
  draw();
});
resized.observe(canvas);
