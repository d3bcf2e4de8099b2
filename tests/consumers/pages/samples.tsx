import { Canvas } from '@react-three/fiber';
import type { ComponentType, ReactNode } from 'react';
import { createRoot, type Root } from 'react-dom/client';
import {
  DataTexture,
  DirectionalLight,
  Group,
  Mesh,
  MeshLambertMaterial,
  MeshStandardMaterial,
  type Object3D,
  PerspectiveCamera,
  PlaneGeometry,
  Scene,
  SphereGeometry,
  TorusKnotGeometry,
  WebGLRenderer,
} from 'three';
import {
  applyHatching,
  type HandStroke,
  HatchingMaterial,
  learnHand,
  prepareHatchingGeometry,
  TonalArtMap,
} from 'three-hatching';
import 'three-hatching/element';

declare global {
  interface Window {
    runSample: typeof runSample;
  }
}

/** The exports of a sample: nothing, a component, or elements inside a canvas. */
type SampleModule = Record<string, ComponentType | ReactNode>;

const SIZE = { width: 240, height: 180 };
const modules = import.meta.glob<SampleModule>(['./samples/*.ts', './samples/*.tsx']);

const renderer = new WebGLRenderer({ antialias: true });
renderer.setSize(SIZE.width, SIZE.height);
const map = await TonalArtMap.generate({ size: 64, tones: 4 });
const files = await Promise.all(
  ['light.png', 'middle.png', 'dark.png'].map(async (name) => new File([await (await fetch(name)).blob()], name)),
);
const strokes = Array.from(
  { length: 8 },
  (_, i): HandStroke => ({ points: [0, i, 4, i + 0.2, 9, i], widths: [0.1, 0.4, 0.2] }),
);
const plane = await prepareHatchingGeometry(new PlaneGeometry(4, 4).rotateX(-Math.PI / 2));

/** A sheet with a few strokes of a pen. */
function pictureOfStrokes(): HTMLCanvasElement {
  const canvas = Object.assign(document.createElement('canvas'), { width: 200, height: 140 });
  const context = canvas.getContext('2d')!;
  context.fillStyle = 'white';
  context.fillRect(0, 0, canvas.width, canvas.height);
  context.lineWidth = 4;
  for (let y = 20; y < 130; y += 16) {
    context.moveTo(20, y);
    context.lineTo(180, y - 8);
  }
  context.stroke();
  return canvas;
}

/** A lamp for samples that change it. @param isHatched whether it is hatched already */
async function makeLamp(isHatched: boolean) {
  const part = (y: number): Mesh => {
    const mesh = new Mesh(new SphereGeometry(0.4, 32, 16), new MeshStandardMaterial());
    mesh.position.y = y;
    return mesh;
  };
  const [shade, cord] = [part(0.5), part(-0.5)];
  const lamp = new Group().add(shade, cord);
  const ball = () => new SphereGeometry(0.5, 32, 16);
  const hatched = isHatched ? { hatched: await applyHatching(lamp, 'pen') } : {};
  return { lamp, shade, cord, ...hatched, kind: 'globe', shades: { globe: ball } };
}

/**
 * Names that samples use without defining them: a scene with a mesh, and others, created at first use.
 *
 * @param isLit whether the sample makes a light of its own
 * @param lamp for samples that change a hatched scene
 */
function surround(isLit: boolean, lamp: object): { scene: Scene; camera: PerspectiveCamera } {
  const scene = new Scene();
  const camera = new PerspectiveCamera(30, SIZE.width / SIZE.height, 0.1, 50);
  camera.position.set(0, 0.4, 5);
  camera.lookAt(0, 0, 0);
  const light = new DirectionalLight('white', Math.PI);
  light.position.set(-3, 4, 3);
  const mesh = new Mesh(new TorusKnotGeometry(0.6, 0.22, 96, 16), new MeshLambertMaterial());
  scene.add(mesh, ...(isLit ? [] : [light]));
  renderer.setClearColor('white');
  renderer.shadowMap.enabled = false;
  renderer.setAnimationLoop(null);

  const placed = <Placed extends Object3D>(object: Placed): Placed => {
    scene.add(object);
    return object;
  };
  const ball = (x: number): Group => {
    const one = new Mesh(new SphereGeometry(0.4, 32, 16), new MeshLambertMaterial({ color: 'tomato', name: 'Glass' }));
    one.position.x = x;
    return new Group().add(one);
  };
  const made: Record<string, () => unknown> = {
    ...{ scene: () => scene, camera: () => camera, renderer: () => renderer, light: () => light, mesh: () => mesh },
    ...{ map: () => map, tonalArtMap: () => map, files: () => files },
    ...{ strokes: () => strokes, hand: () => learnHand(strokes), picture: pictureOfStrokes },
    geometry: () => mesh.geometry,
    material: () => new HatchingMaterial({ tonalArtMap: map, technique: 'hatching' }),
    ground: () => {
      const ground = new Mesh(plane, new HatchingMaterial({ tonalArtMap: map, technique: 'hatching' }));
      ground.position.y = -0.9;
      return placed(ground);
    },
    gltf: () => ({ scene: placed(ball(-1)) }),
    first: () => placed(ball(-1)),
    // More triangles than detail requires.
    scan: () => placed(new Group().add(new Mesh(new SphereGeometry(0.8, 400, 300), new MeshLambertMaterial()))),
    second: () => placed(ball(1)),
    gradientMap: () => new DataTexture(new Uint8Array([64, 128, 255, 255]), 1, 1),
    ...{ canvas: () => renderer.domElement, signal: () => new AbortController().signal },
    ...{ draw: () => () => renderer.render(scene, camera), save: () => () => {} },
    ...Object.fromEntries(Object.entries(lamp).map(([name, value]) => [name, () => value])),
  };
  if ('lamp' in lamp) scene.add(lamp.lamp as Group);
  for (const [name, make] of Object.entries(made)) {
    let value: unknown;
    Object.defineProperty(globalThis, name, {
      configurable: true,
      get: () => {
        value ??= make();
        return value;
      },
      set: (next: unknown) => {
        value = next;
      },
    });
  }
  return { scene, camera };
}

let root: Root | undefined;

interface SampleFacts {
  html?: string;
  hasCanvas: boolean;
  isLit: boolean;
  lamp: 'none' | 'plain' | 'hatched';
}

/**
 * Runs a sample and leaves what it draws as the last element of the page.
 *
 * @param options.html the elements of a sample that is no module
 * @param options.hasCanvas whether its component draws into a canvas of its own
 * @param options.isLit whether it makes a light of its own
 * @param options.lamp the lamp that it changes
 */
async function runSample(name: string, { html, hasCanvas, isLit, lamp }: SampleFacts): Promise<void> {
  root?.unmount();
  root = undefined;
  document.body.replaceChildren();
  const { scene, camera } = surround(isLit, lamp === 'none' ? {} : await makeLamp(lamp === 'hatched'));
  if (html !== undefined) document.body.innerHTML = html;
  else {
    const sample = await (modules[`./samples/${name}.ts`] ?? modules[`./samples/${name}.tsx`])();
    const [shown] = Object.values(sample);
    if (shown !== undefined) show(shown, hasCanvas);
  }
  if (document.body.childElementCount > 0) return;
  document.body.append(renderer.domElement);
  // Again and again: maps and lists of contours come later.
  renderer.setAnimationLoop(() => renderer.render(scene, camera));
}

/** Shows a component, in a canvas if it makes none. */
function show(shown: ComponentType | ReactNode, hasCanvas: boolean): void {
  const holder = document.createElement('div');
  document.body.append(holder);
  const Shown = typeof shown === 'function' ? (shown as ComponentType) : () => shown as ReactNode;
  root = createRoot(holder);
  root.render(
    hasCanvas ? (
      <Shown />
    ) : (
      <Canvas flat>
        <directionalLight position={[-3, 4, 3]} intensity={Math.PI} />
        <Shown />
      </Canvas>
    ),
  );
}

window.runSample = runSample;
