/** Scenes of the tests of outlines: white paper, black outlines, and pictures as darkness per pixel. */
import './toolkit.js';
import * as THREE from 'three';
import { STLExporter } from 'three/addons/exporters/STLExporter.js';
import { mergeVertices } from 'three/addons/utils/BufferGeometryUtils.js';
import {
  HatchingOutlineMaterial,
  type HatchingOutlineParameters,
  HatchingOutlines,
  type PrepareHatchingGeometryOptions,
  prepareHatchingGeometry,
} from 'three-hatching';
import { outlineDataOf } from '../../src/material/geometry/OutlineData.js';
import { HATCHING_OUTLINE_DEFAULTS } from '../../src/material/outlines/outlineProperties.js';
import { loadModel } from '../../tools/metrics/loadModel.js';
import { loneStrip, strips } from './strips.js';
import { visibleLines, wrongLength } from './visibleLines.js';

type Options = HatchingOutlineParameters & { layout?: PrepareHatchingGeometryOptions['layout']; isClear?: boolean };

/** Weights that do not depend on light or on what lies behind, so that widths are those asked for; and creases that are easily found. */
const EVEN = {
  weights: { lit: 1, shade: 1, innerContours: 1, creases: 0.6, materialBorders: 0.6 },
  lostEdges: 0,
  accents: 0,
} as const;

/** A white mesh with black outlines; `isClear`: the outlines alone, with nothing that hides them. */
async function outlinedMesh(source: THREE.BufferGeometry, options: Options = {}) {
  const { layout = 'indexed', isClear = false, ...parameters } = options;
  const geometry = await prepareHatchingGeometry(source, { layout, outlines: true });
  const blending = isClear ? THREE.CustomBlending : THREE.NormalBlending;
  const untouched = { blending, blendSrc: THREE.ZeroFactor, blendDst: THREE.OneFactor };
  const paper = new THREE.MeshBasicMaterial({ side: THREE.DoubleSide, ...untouched, depthWrite: !isClear });
  const mesh = new THREE.Mesh(geometry, paper);
  mesh.add(new HatchingOutlines(mesh, { ...EVEN, ...parameters, weights: { ...EVEN.weights, ...parameters.weights } }));
  return mesh;
}

/** The same of instances. */
async function outlinedInstances(
  source: THREE.BufferGeometry,
  places: readonly THREE.Matrix4[],
  options: Options = {},
): Promise<THREE.InstancedMesh> {
  const { geometry, material, children } = await outlinedMesh(source, options);
  const instances = new THREE.InstancedMesh(geometry, material, places.length);
  places.forEach((place, i) => {
    instances.setMatrixAt(i, place);
  });
  const [outlines] = children as HatchingOutlines[];
  outlines.mesh = instances;
  instances.add(outlines);
  return instances;
}

const outlinesOf = (mesh: THREE.Object3D): HatchingOutlines =>
  mesh.children.find((child): child is HatchingOutlines => child instanceof HatchingOutlines)!;

function paperScene(...things: THREE.Object3D[]): THREE.Scene {
  const scene = new THREE.Scene();
  scene.background = new THREE.Color(0xffffff);
  scene.add(...things);
  return scene;
}

function lookFrom(x: number, y: number, z: number, fov = 40): THREE.PerspectiveCamera {
  const camera = new THREE.PerspectiveCamera(fov, 1, 0.1, 50);
  camera.position.set(x, y, z);
  camera.lookAt(0, 0, 0);
  camera.updateMatrixWorld();
  return camera;
}

const renderers = new Map<string, THREE.WebGLRenderer>();

/** The renderer of a size, pixels per side. Renderers are kept, since contexts are few. */
function rendererOf(size: number, parameters: THREE.WebGLRendererParameters = {}): THREE.WebGLRenderer {
  const key = JSON.stringify([size, parameters]);
  let renderer = renderers.get(key);
  if (!renderer) {
    renderer = new THREE.WebGLRenderer({ preserveDrawingBuffer: true, ...parameters });
    renderer.outputColorSpace = THREE.LinearSRGBColorSpace;
    renderer.setSize(size, size, false);
    renderers.set(key, renderer);
  }
  return renderer;
}

/** Darkness in [0, 1] of each pixel, top row first: what is left of the red of white paper. */
function inkOf(renderer: THREE.WebGLRenderer): Float32Array {
  const { width, height } = renderer.domElement;
  const gl = renderer.getContext();
  const pixels = new Uint8Array(4 * width * height);
  gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  const ink = new Float32Array(width * height);
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) ink[(height - 1 - y) * width + x] = 1 - pixels[4 * (y * width + x)] / 255;
  }
  return ink;
}

function draw(scene: THREE.Scene, camera: THREE.Camera, renderer = rendererOf(400)): Float32Array {
  renderer.render(scene, camera);
  return inkOf(renderer);
}

/** The pixel of a world position, from the top left corner of a picture of the given size. */
function pixelOf(point: THREE.Vector3, camera: THREE.Camera, size: number): { x: number; y: number } {
  const { x, y } = point.clone().project(camera);
  return { x: (0.5 + 0.5 * x) * size, y: (0.5 - 0.5 * y) * size };
}

/** The most ink within `reach` pixels of a place. */
function inkNear(ink: Float32Array, size: number, { x, y }: { x: number; y: number }, reach: number): number {
  let most = 0;
  for (let j = Math.floor(y - reach); j <= y + reach; j++) {
    for (let i = Math.floor(x - reach); i <= x + reach; i++) {
      if (i >= 0 && j >= 0 && i < size && j < size) most = Math.max(most, ink[j * size + i]);
    }
  }
  return most;
}

const total = (ink: Float32Array): number => ink.reduce((sum, one) => sum + one, 0);

const mostDifferent = (a: Float32Array, b: Float32Array): number =>
  a.reduce((most, value, i) => Math.max(most, Math.abs(value - b[i])), 0);

/** The share of the ink in `b` that has no ink within `reach` pixels in `a`. */
function strayInk(a: Float32Array, b: Float32Array, size: number, reach: number): number {
  let stray = 0;
  let all = 0;
  for (let y = 0; y < size; y++) {
    for (let x = 0; x < size; x++) {
      if (b[y * size + x] < 0.3) continue;
      all++;
      if (inkNear(a, size, { x, y }, reach) < 0.3) stray++;
    }
  }
  return stray / all;
}

const lining = {
  HATCHING_OUTLINE_DEFAULTS,
  THREE,
  STLExporter,
  mergeVertices,
  HatchingOutlines,
  HatchingOutlineMaterial,
  loadModel,
  outlineDataOf,
  EVEN,
  outlinedMesh,
  outlinedInstances,
  outlinesOf,
  paperScene,
  lookFrom,
  rendererOf,
  inkOf,
  draw,
  pixelOf,
  inkNear,
  total,
  mostDifferent,
  strayInk,
  visibleLines,
  wrongLength,
  strips,
  loneStrip,
};

declare global {
  interface Window {
    lining: typeof lining;
  }
}
window.lining = lining;
