/** The helpers with which tests build their scenes. They are a global, since the code of a test runs inside `evaluate`. */
import './quickBlur.js';
import * as THREE from 'three';
import { RoomEnvironment } from 'three/addons/environments/RoomEnvironment.js';
import { GLTFExporter } from 'three/addons/exporters/GLTFExporter.js';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { mergeGeometries } from 'three/addons/utils/BufferGeometryUtils.js';
import {
  AdaptiveResolution,
  applyHatching,
  bakeOcclusion,
  fitExposure,
  HatchingBackground,
  HatchingMaterial,
  type HatchingMaterialParameters,
  prepareHatchingGeometry,
  presets,
  TonalArtMap,
} from 'three-hatching';
import { scaledSizes } from 'three-hatching/facts';
import { plainLook } from '../../tools/plainLook.js';

/** A material with plain strokes by default; `UsersMaterial` is the material as users make it. */
class PlainMaterial extends HatchingMaterial {
  constructor(parameters: HatchingMaterialParameters = {}) {
    super(plainLook(parameters));
  }
}

// Many scenes are odd on purpose, so warnings about looks are off; tests of these warnings switch them on.
HatchingMaterial.silent = true;

const SIZE = 96;

/** Tones that are flat greys: every texel of image k has the darkness k / 4, so that pixels show only the tone. */
function greyMap(): TonalArtMap {
  return TonalArtMap.fromHatchImages({
    size: 4,
    images: [0, 1, 2, 3, 4].map((k) => [new Uint8Array(16).fill(Math.round(255 * (1 - k / 4)))]),
  });
}

/** Hard vertical stripes: 0 and 255 across u, the same for every tone but the blank one. */
function stripedMap(): TonalArtMap {
  const stripes = Uint8Array.from({ length: 64 * 64 }, (_, i) => (i % 16 < 8 ? 0 : 255));
  return TonalArtMap.fromHatchImages({
    size: 64,
    images: [[new Uint8Array(64 * 64).fill(255)], ...[1, 2, 3].map(() => [stripes])],
  });
}

function makeRenderer(parameters: THREE.WebGLRendererParameters = {}): THREE.WebGLRenderer {
  const renderer = new THREE.WebGLRenderer({ antialias: false, preserveDrawingBuffer: true, ...parameters });
  renderer.outputColorSpace = THREE.LinearSRGBColorSpace;
  renderer.setSize(SIZE, SIZE, false);
  document.body.append(renderer.domElement);
  return renderer;
}

function sun(intensity = Math.PI, position: [number, number, number] = [1, 1.5, 2]): THREE.DirectionalLight {
  const light = new THREE.DirectionalLight(0xffffff, intensity);
  light.position.set(...position);
  return light;
}

function makeCamera(): THREE.PerspectiveCamera {
  const camera = new THREE.PerspectiveCamera(40, 1, 0.1, 50);
  camera.position.set(0, 0, 4);
  return camera;
}

const suns = import.meta.glob('../../node_modules/three/examples/jsm/lights/SunLight.js');

/** The class of lights with cascades of shadow maps; undefined in versions of three.js without it. */
async function loadSunLight(): Promise<typeof THREE.DirectionalLight | undefined> {
  if (!THREE.ShaderChunk.lights_pars_begin.includes('NUM_SUN_LIGHTS')) return undefined;
  const loaded = (await Object.values(suns)[0]?.()) as { SunLight: typeof THREE.DirectionalLight } | undefined;
  return loaded?.SunLight;
}

/** A scene on a green ground with the given things in it. */
function sceneOf(...things: THREE.Object3D[]): THREE.Scene {
  const scene = new THREE.Scene();
  scene.background = new THREE.Color(0x00ff00);
  scene.add(...things);
  return scene;
}

async function hatchedMesh(
  geometry: THREE.BufferGeometry,
  parameters: HatchingMaterialParameters = {},
): Promise<THREE.Mesh<THREE.BufferGeometry, HatchingMaterial>> {
  return new THREE.Mesh(
    await prepareHatchingGeometry(geometry, { adjacency: true }),
    new PlainMaterial({ tonalArtMap: greyMap(), ...parameters }),
  );
}

/** Resolves when all that was drawn has been checked for mistakes. */
async function whenChecked(): Promise<void> {
  await import('../../src/material/firstDraw/checkDraws.js');
  await new Promise((go) => setTimeout(go));
}

/** Renders and returns RGBA, bottom row first. */
function pixelsOf(
  scene: THREE.Scene,
  renderer: THREE.WebGLRenderer = makeRenderer(),
  camera: THREE.Camera = makeCamera(),
): number[] {
  renderer.render(scene, camera);
  const gl = renderer.getContext();
  const pixels = new Uint8Array(SIZE * SIZE * 4);
  gl.readPixels(0, 0, SIZE, SIZE, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  return [...pixels];
}

/**
 * The connected pieces of a square picture, as lists of pixels. Pieces at the border of the picture are left out.
 *
 * @param side the width and height of the picture, in pixels
 * @param isIn whether a pixel belongs to a piece
 */
function wholePieces(side: number, isIn: (pixel: number) => boolean): number[][] {
  const seen = new Uint8Array(side * side);
  const pieces: number[][] = [];
  for (let start = 0; start < seen.length; start++) {
    if (seen[start] || !isIn(start)) continue;
    seen[start] = 1;
    const piece = [start];
    let isCut = false;
    for (const i of piece) {
      const [x, y] = [i % side, Math.floor(i / side)];
      if (x === 0 || y === 0 || x === side - 1 || y === side - 1) {
        isCut = true;
        continue;
      }
      for (const next of [i - 1, i + 1, i - side, i + side]) {
        if (seen[next] || !isIn(next)) continue;
        seen[next] = 1;
        piece.push(next);
      }
    }
    if (!isCut) pieces.push(piece);
  }
  return pieces;
}

const toolkit = {
  THREE,
  GLTFLoader,
  GLTFExporter,
  mergeGeometries,
  RoomEnvironment,
  applyHatching,
  bakeOcclusion,
  HatchingBackground,
  fitExposure,
  HatchingMaterial: PlainMaterial,
  UsersMaterial: HatchingMaterial,
  AdaptiveResolution,
  scaledSizes,
  prepareHatchingGeometry,
  presets,
  TonalArtMap,
  SIZE,
  greyMap,
  stripedMap,
  makeRenderer,
  makeCamera,
  sun,
  loadSunLight,
  sceneOf,
  hatchedMesh,
  pixelsOf,
  whenChecked,
  wholePieces,
};

declare global {
  interface Window {
    toolkit: typeof toolkit;
  }
}
// Tests draw in the same turn in which they make their materials.
await HatchingMaterial.preload();
window.toolkit = toolkit;
