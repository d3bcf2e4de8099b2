import { Canvas, type RootState, useFrame } from '@react-three/fiber';
import { Component, type ReactNode, useSyncExternalStore } from 'react';
import { createRoot } from 'react-dom/client';
import type { BufferGeometry, Material, Mesh, Object3D } from 'three';
import { Hatched } from 'three-hatching/react';
import { PARTS, Shown } from './dreiParts.js';

/** What the page shows: a part inside of `<Hatched>` or outside of it, before or after its change. */
interface Content {
  name: string;
  changed: boolean;
  hatched: boolean;
}

let content: Content | null = null;
const listeners = new Set<() => void>();
let state: RootState | undefined;
let errors: string[] = [];
/** Frames in which a mesh named "model" was drawn with its own material inside of `<Hatched>`. */
let flashes = 0;
let frames = 0;
let hatchings = 0;

// An error in a frame stops all further frames.
window.addEventListener('error', ({ message }) => errors.push(message));

const BACKGROUND = [0, 255, 0] as const;
const SIZE = 128;
/** Outlines and edges of triangles reach a little farther than the surface. */
const REACH = 4;

/** Colours of the pixels, row by row. */
type Picture = Uint8Array;

const nextFrame = () => new Promise((go) => requestAnimationFrame(go));

async function drawFrames(count: number): Promise<void> {
  const until = frames + count;
  while (frames < until && errors.length === 0) await nextFrame();
}

function picture(): Picture {
  const context = state!.gl.getContext();
  const bytes = new Uint8Array(SIZE * SIZE * 4);
  context.readPixels(0, 0, SIZE, SIZE, context.RGBA, context.UNSIGNED_BYTE, bytes);
  return bytes;
}

const isDrawn = (pixels: Picture, i: number): boolean =>
  BACKGROUND.some((value, channel) => Math.abs(pixels[4 * i + channel] - value) > 8);

const near = (i: number): number[] => {
  const [x, y] = [i % SIZE, Math.floor(i / SIZE)];
  const found: number[] = [];
  for (let row = Math.max(0, y - REACH); row <= Math.min(SIZE - 1, y + REACH); row++)
    for (let column = Math.max(0, x - REACH); column <= Math.min(SIZE - 1, x + REACH); column++)
      found.push(row * SIZE + column);
  return found;
};

const percent = (count: number, all: number): string => `${((100 * count) / Math.max(all, 1)).toFixed(1)} %`;

/** Whether a hatched picture covers what the plain one does, in ink and paper; a sentence if not. */
function coverage(plain: Picture, hatched: Picture): string {
  let [drawn, missing, beyond, dark] = [0, 0, 0, 0];
  for (let i = 0; i < SIZE * SIZE; i++) {
    if (isDrawn(plain, i)) {
      drawn++;
      if (!near(i).some((other) => isDrawn(hatched, other))) missing++;
      if (hatched[4 * i] < 100 && isDrawn(hatched, i)) dark++;
    } else if (isDrawn(hatched, i) && !near(i).some((other) => isDrawn(plain, other))) beyond++;
  }
  if (drawn < 100) return `the plain picture has only ${drawn} pixels`;
  if (missing > 0.02 * drawn) return `${percent(missing, drawn)} of it is missing`;
  if (beyond > 0.02 * drawn) return `${percent(beyond, drawn)} more than it is drawn`;
  return dark < 0.005 * drawn ? `only ${percent(dark, drawn)} of it is ink` : '';
}

/** Whether two pictures are the same; a sentence if not. */
function difference(one: Picture, other: Picture): string {
  let differing = 0;
  for (let i = 0; i < one.length; i++) if (Math.abs(one[i] - other[i]) > 4) differing++;
  return differing > 0.002 * one.length ? `${percent(differing, one.length)} looks otherwise` : '';
}

/** The meshes named "model". */
function models(): Mesh<BufferGeometry, Material>[] {
  const found: Mesh<BufferGeometry, Material>[] = [];
  state!.scene.traverse((object) => {
    if (object.name === 'model' && 'isMesh' in object) found.push(object as Mesh<BufferGeometry, Material>);
  });
  return found;
}

const isPrepared = (mesh: Mesh): boolean => isHatched(mesh) && 'hatching' in mesh.geometry.userData;
const isHatched = ({ material }: Mesh): boolean => 'isHatchingMaterial' in material;

function show(next: Content | null): void {
  page.isLoaded = false;
  content = next;
  for (const tell of listeners) tell();
}

/** Waits until a condition holds that says why not; returns the reason after some hundred frames. */
async function eventually(reason: () => string): Promise<string> {
  for (let i = 0; i < 100; i++) {
    await drawFrames(3);
    if (errors.length > 0 || reason() === '') break;
  }
  return reason();
}

const memory = (): number => state!.gl.info.memory.geometries + state!.gl.info.memory.textures;

/** Waits until nothing more is freed. */
async function freed(upTo: number): Promise<string> {
  return eventually(() => {
    const { geometries, textures } = state!.gl.info.memory;
    return memory() > upTo ? `${geometries} geometries and ${textures} textures are left` : '';
  });
}

/** Unmounts a part. @returns the number of things that are left when no more are freed */
async function unmounted(): Promise<number> {
  show(null);
  let left = Number.POSITIVE_INFINITY;
  for (let quiet = 0; quiet < 3; quiet++) {
    await drawFrames(8);
    if (memory() < left) quiet = 0;
    left = memory();
  }
  return left;
}

async function mountedAgain(name: string): Promise<number> {
  for (const changed of [false, true]) {
    show({ name, changed, hatched: false });
    await drawFrames(10);
  }
  return unmounted();
}

/** Mounts, changes and unmounts a part outside and inside of `<Hatched>`. @returns what is wrong, in sentences */
async function wrongWith(name: string): Promise<string[]> {
  const { expected } = PARTS[name];
  const wrong: string[] = [];
  errors = [];
  const plain: Picture[] = [];
  for (const changed of [false, true]) {
    show({ name, changed, hatched: false });
    await settled();
    plain.push(picture());
  }
  const [once, twice] = [await unmounted(), await mountedAgain(name)];
  [flashes, hatchings] = [0, 0];
  for (const changed of [false, true]) {
    show({ name, changed, hatched: true });
    if (models().length > 0) await eventually(() => (hatchings > 0 ? '' : 'it is not hatched'));
    await drawFrames(3);
    const reason = await eventually(() => {
      if (expected === 'same') return difference(plain[Number(changed)], picture());
      if (!models().every(isPrepared)) return 'a mesh is not hatched';
      return expected === 'varies' ? '' : coverage(plain[Number(changed)], picture());
    });
    if (reason) wrong.push(`${changed ? 'changed' : 'mounted'}: ${reason}`);
  }
  show(null);
  await drawFrames(3);
  if (models().length > 0) wrong.push('unmounted: it is still there');
  // Some components of drei leave something behind by themselves.
  const left = await freed(2 * twice - once + PARTS[name].leaves);
  if (left) wrong.push(`unmounted: ${left}`);
  if (flashes > 0) wrong.push(`${flashes} frames show it unhatched`);
  return [...wrong, ...errors];
}

/** Waits until pictures stay the same: parts load fonts and textures, and bake shadows. */
async function settled(): Promise<void> {
  await eventually(() => (content === null || page.isLoaded ? '' : 'it is loading'));
  await drawFrames(10);
  let before = picture();
  for (let i = 0; i < 20; i++) {
    await drawFrames(5);
    const now = picture();
    if (difference(before, now) === '') return;
    before = now;
  }
}

const page = { names: Object.keys(PARTS), wrongWith, isLoaded: false, isReady: false };
Object.assign(window, { dreiEach: page });

declare global {
  interface Window {
    dreiEach: typeof page;
  }
}

class Boundary extends Component<{ children: ReactNode }> {
  override state = { failed: false };
  static getDerivedStateFromError = () => ({ failed: true });
  override componentDidCatch(error: Error): void {
    errors.push(`${error.message} ${error.stack?.split('\n')[1]}`);
  }
  override render() {
    return this.state.failed ? null : this.props.children;
  }
}

/** Looks at what is about to be drawn. */
function Watch({ hatched }: { hatched: boolean }) {
  useFrame(({ scene, camera }) => {
    frames++;
    if (!hatched) return;
    scene.traverseVisible((object: Object3D) => {
      if (object.name !== 'model' || !('isMesh' in object) || !object.layers.test(camera.layers)) return;
      if (!isHatched(object as Mesh)) flashes++;
    });
  });
  return null;
}

function App() {
  const now = useSyncExternalStore(
    (tell) => {
      listeners.add(tell);
      return () => listeners.delete(tell);
    },
    () => content,
  );
  const part = now && (
    <Shown
      name={now.name}
      changed={now.changed}
      onLoaded={() => {
        page.isLoaded = true;
      }}
    />
  );
  return (
    <Canvas
      flat
      dpr={1}
      shadows="percentage"
      camera={{ position: [0, 0.5, 4], fov: 45 }}
      gl={{ preserveDrawingBuffer: true, antialias: false }}
      onCreated={(created) => {
        created.gl.setClearColor('#00ff00');
        state = created;
        page.isReady = true;
      }}
    >
      <directionalLight position={[2, 3, 4]} intensity={Math.PI} />
      <Boundary key={`${now?.name} ${now?.hatched}`}>
        {now?.hatched ? (
          <Hatched
            preset="pen"
            tonalArtMap={{ size: 64, tones: 4 }}
            onHatched={() => {
              hatchings++;
            }}
            onError={(error) => errors.push(String(error))}
          >
            {part}
          </Hatched>
        ) : (
          part
        )}
      </Boundary>
      <Watch key={`watched ${now?.name} ${now?.hatched}`} hatched={now?.hatched ?? false} />
    </Canvas>
  );
}

createRoot(document.getElementById('root')!).render(<App />);
