/** Measures the values of a scene of many parts: paper, solid dark, how its parts are told apart, and where it is darkest. */
import {
  Color,
  type Material,
  type Mesh,
  MeshBasicMaterial,
  type PerspectiveCamera,
  Scene,
  Vector3,
  type WebGLRenderer,
  WebGLRenderTarget,
} from 'three';
import { flatteringLight, type HatchingMaterial } from 'three-hatching';
import type { HatchedModel } from '../../src/viewer/drawing/HatchedModel.js';
import { meshesOf } from '../../src/viewer/drawing/meshes.js';
import { createCamera } from '../../src/viewer/sceneSetup/LensCamera.js';
import { LightRig } from '../../src/viewer/sceneSetup/LightRig.js';
import { lookOf } from '../../src/viewer/settings/lookOf.js';
import { presetLook } from '../../src/viewer/settings/presets.js';
import { defaultSettings } from '../../src/viewer/settings/settings.js';
import { loadSource, type ValueSource } from './valueShares.js';

export interface SceneValues {
  /** Shares of what is seen. */
  paper: number;
  solid: number;
  /** The share of paper if all colours were white, in the same light. */
  ifWhite: number;
  /** The least difference in tone across a border of two parts, and the share of borders with a step of 0.12 or an outline. */
  leastStep: number;
  told: number;
  /** Where the darkest mass lies, as shares of the sheet from its lower left, and whether that is on the subject. */
  darkest: [across: number, up: number];
  isOnSubject: boolean;
  /** The drawing, as a data URL. */
  picture: string;
}

const SIZE = 480;
const DISTANCE = 4.6;
const VIEW = [0.8, 0.55, 1] as const;
/** Lighter is blank paper with a stroke here and there; darker is ink with specks of paper. */
const PAPER = 0.15;
const SOLID = 0.85;
/** Pixels between a border and the tones beside it, and the shortest border that counts. */
const BESIDE = 4;
const SHORTEST = 16;
const STEP = 0.12;
/** The width of a mass, and the ink that an outline adds. */
const MASS = 32;
const LINE = 0.25;

/** @param planned how far values are planned */
export async function measureScene(
  renderer: WebGLRenderer,
  source: ValueSource,
  planned: number,
): Promise<SceneValues> {
  const { model } = await loadSource(source);
  const scene = new Scene();
  scene.add(model.root);
  const camera = createCamera();
  camera.position.copy(new Vector3(...VIEW).setLength(DISTANCE));
  camera.lookAt(0, 0, 0);
  scene.updateMatrixWorld();
  const lights = new LightRig(scene);
  const { direction } = flatteringLight(model.root, camera);
  const draw = (debugView: 'tone' | 'none', outlines: 'on' | 'off'): Picture => {
    const settings = { ...defaultSettings(), ...presetLook('pen'), debugView, outlines } as const;
    const look = lookOf(settings);
    lights.apply(look.lights);
    model.apply(look);
    lights.place(camera);
    for (const light of scene.children) if ('isDirectionalLight' in light) light.position.copy(direction);
    for (const material of materialsOf(model)) material.composition.plannedValues = planned;
    return shoot(renderer, scene, camera, outlines === 'on' ? new Color('#f7f3e8') : null);
  };
  const tones = draw('tone', 'off');
  for (const material of materialsOf(model)) material.colorHatching = 0;
  const white = shoot(renderer, scene, camera, null);
  const plain = draw('none', 'off');
  const drawn = draw('none', 'on');
  const parts = drawColors(renderer, scene, camera, model);
  const found = {
    ...sharesOf(tones),
    ifWhite: sharesOf(white).paper,
    ...bordersOf(parts, tones, plain, drawn),
    ...darkestOf(tones),
    picture: drawn.url,
  };
  model.dispose();
  return found;
}

interface Picture {
  pixels: Uint8Array;
  url: string;
}

const materialsOf = ({ root }: HatchedModel): HatchingMaterial[] =>
  meshesOf(root).flatMap(({ material }) => material as HatchingMaterial | HatchingMaterial[]);

function shoot(renderer: WebGLRenderer, scene: Scene, camera: PerspectiveCamera, paper: Color | null): Picture {
  const target = new WebGLRenderTarget(SIZE, SIZE);
  const pixels = new Uint8Array(4 * SIZE * SIZE);
  renderer.setRenderTarget(target);
  renderer.setClearColor(0x000000, 0);
  renderer.clear();
  renderer.render(scene, camera);
  renderer.readRenderTargetPixels(target, 0, 0, SIZE, SIZE, pixels);
  renderer.setRenderTarget(null);
  target.dispose();
  return { pixels, url: paper ? urlOf(renderer, scene, camera, paper) : '' };
}

function urlOf(renderer: WebGLRenderer, scene: Scene, camera: PerspectiveCamera, paper: Color): string {
  renderer.setSize(SIZE, SIZE, false);
  renderer.setClearColor(paper, 1);
  renderer.clear();
  renderer.render(scene, camera);
  return renderer.domElement.toDataURL();
}

/** A picture of the colours alone, by which parts are told. */
function drawColors(renderer: WebGLRenderer, scene: Scene, camera: PerspectiveCamera, { root }: HatchedModel): Picture {
  const meshes = meshesOf(root) as Mesh[];
  const before = meshes.map(({ material }) => material);
  const hidden = meshes.flatMap(({ children }) => children).filter(({ visible }) => visible);
  const flat = (material: Material): Material => {
    const { color, map, vertexColors, side } = material as HatchingMaterial;
    return new MeshBasicMaterial({ color: color.clone(), map, vertexColors, side, toneMapped: false });
  };
  for (const one of hidden) one.visible = false;
  for (const mesh of meshes)
    mesh.material = Array.isArray(mesh.material) ? mesh.material.map(flat) : flat(mesh.material);
  const picture = shoot(renderer, scene, camera, null);
  for (const [i, mesh] of meshes.entries()) mesh.material = before[i];
  for (const one of hidden) one.visible = true;
  return picture;
}

const toneAt = ({ pixels }: Picture, i: number): number => 1 - pixels[4 * i] / 255;
const isSeen = ({ pixels }: Picture, i: number): boolean => pixels[4 * i + 3] === 255;
/** The colour at a place, in 24 steps as light goes; 0 beside the subject. */
const partAt = ({ pixels }: Picture, i: number): number => {
  if (pixels[4 * i + 3] < 255) return 0;
  const [r, g, b] = [0, 1, 2].map((k) => Math.round(24 * Math.sqrt(pixels[4 * i + k] / 255)));
  return 1 + (r * 32 + g) * 32 + b;
};

function sharesOf(tones: Picture): { paper: number; solid: number } {
  const counts = { seen: 0, paper: 0, solid: 0 };
  for (let i = 0; i < SIZE * SIZE; i++) {
    if (!isSeen(tones, i)) continue;
    counts.seen++;
    if (toneAt(tones, i) < PAPER) counts.paper++;
    else if (toneAt(tones, i) > SOLID) counts.solid++;
  }
  return { paper: counts.paper / counts.seen, solid: counts.solid / counts.seen };
}

/** How the parts on both sides of a border differ. */
interface Border {
  length: number;
  step: number;
  lined: number;
}

function bordersOf(
  parts: Picture,
  tones: Picture,
  plain: Picture,
  drawn: Picture,
): { leastStep: number; told: number } {
  const borders = new Map<string, Border>();
  const hasLine = (i: number): boolean => {
    for (const k of [-2 * SIZE, -SIZE, -2, -1, 0, 1, 2, SIZE, 2 * SIZE])
      if (toneAt(drawn, i + k) - toneAt(plain, i + k) > LINE) return true;
    return false;
  };
  for (let y = BESIDE; y < SIZE - BESIDE - 1; y++)
    for (let x = BESIDE; x < SIZE - BESIDE - 1; x++)
      for (const along of [1, SIZE]) {
        const i = y * SIZE + x;
        const [a, b] = [partAt(parts, i), partAt(parts, i + along)];
        if (a === b || a === 0 || b === 0) continue;
        const [before, after] = [i - BESIDE * along, i + (BESIDE + 1) * along];
        if (partAt(parts, before) !== a || partAt(parts, after) !== b) continue;
        const key = a < b ? `${a} ${b}` : `${b} ${a}`;
        const border = borders.get(key) ?? { length: 0, step: 0, lined: 0 };
        borders.set(key, border);
        border.length++;
        border.step += Math.abs(toneAt(tones, before) - toneAt(tones, after));
        border.lined += Number(hasLine(i));
      }
  const long = [...borders.values()].filter(({ length }) => length >= SHORTEST);
  const all = long.reduce((sum, { length }) => sum + length, 0);
  const told = long.filter(({ length, step, lined }) => step / length >= STEP || lined / length >= 0.5);
  return {
    leastStep: Math.min(1, ...long.map(({ step, length }) => step / length)),
    told: all === 0 ? 1 : told.reduce((sum, { length }) => sum + length, 0) / all,
  };
}

function darkestOf(tones: Picture): { darkest: [number, number]; isOnSubject: boolean } {
  let [most, at, seen] = [-1, [0, 0] as [number, number], 0];
  for (let y = 0; y + MASS <= SIZE; y += MASS / 4)
    for (let x = 0; x + MASS <= SIZE; x += MASS / 4) {
      let [sum, count] = [0, 0];
      for (let v = 0; v < MASS; v++)
        for (let u = 0; u < MASS; u++) {
          const i = (y + v) * SIZE + x + u;
          if (!isSeen(tones, i)) continue;
          sum += toneAt(tones, i);
          count++;
        }
      if (sum <= most) continue;
      most = sum;
      at = [(x + MASS / 2) / SIZE, (y + MASS / 2) / SIZE];
      seen = count;
    }
  return { darkest: at, isOnSubject: seen > (MASS * MASS) / 2 };
}
