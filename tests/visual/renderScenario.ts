/** The page of the screenshot tests. It renders one scenario after another and returns its pixels. */
import {
  DirectionalLight,
  type Light,
  Mesh,
  PerspectiveCamera,
  PointLight,
  Scene,
  SpotLight,
  WebGLRenderer,
} from 'three';
import { HatchingMaterial, HatchingOutlines, prepareHatchingGeometry, TonalArtMap } from 'three-hatching';
import { followsForm } from 'three-hatching/facts';
import { plainLook } from '../../tools/plainLook.js';
import { loadScenarioModel } from './scenarioModels.js';
import type { Scenario, ScenarioLight } from './scenarios.js';
import { widenStrokes } from './widenStrokes.js';

export interface RenderedPixels {
  width: number;
  height: number;
  /** RGBA of all pixels, top row first, as base64: arrays of numbers are slow to hand over. */
  base64: string;
}

/** What a test may change on purpose, to see the gate close. */
export interface Deviation {
  /** Factor on the width of every stroke, which stays where it is. */
  strokeWidth?: number;
}

declare global {
  interface Window {
    renderScenario(scenario: Scenario, deviation?: Deviation): Promise<RenderedPixels>;
  }
}

const renderer = new WebGLRenderer({ antialias: true, preserveDrawingBuffer: true });
renderer.setPixelRatio(1);
renderer.setClearColor(0xffffff);
document.body.append(renderer.domElement);

window.renderScenario = async (scenario, deviation = {}) => {
  const tonalArtMap =
    deviation.strokeWidth === undefined
      ? await TonalArtMap.generate(scenario.tonalArtMap)
      : TonalArtMap.fromHatchImages(widenStrokes(scenario.tonalArtMap, deviation.strokeWidth));
  const geometry = await prepareHatchingGeometry(await loadScenarioModel(scenario.model), {
    adjacency: true,
    outlines: scenario.outlines !== undefined,
    form: followsForm(scenario.material),
  });
  tonalArtMap.texture.anisotropy = scenario.anisotropy ?? 1;
  const material = new HatchingMaterial(plainLook({ tonalArtMap, ...scenario.material }));
  await material.ready;
  const mesh = new Mesh(geometry, material);
  mesh.rotation.fromArray([...(scenario.modelRotation ?? [0, 0, 0])]);

  const outlines = scenario.outlines && new HatchingOutlines(mesh, scenario.outlines);
  if (outlines) mesh.add(outlines);

  const scene = new Scene();
  scene.add(mesh, ...scenario.lights.map(makeLight));
  const [width, height] = scenario.size;
  const camera = new PerspectiveCamera(scenario.camera.fov, width / height, 0.1, 100);
  camera.position.fromArray([...scenario.camera.position]);
  camera.lookAt(0, 0, 0);

  renderer.setSize(width, height, false);
  renderer.render(scene, camera);
  const pixels = readPixels(width, height);
  for (const thing of [geometry, material, tonalArtMap, outlines]) thing?.dispose();
  return { width, height, base64: toBase64(pixels) };
};

function makeLight({ type, position, intensity }: ScenarioLight): Light {
  const light = {
    directional: () => new DirectionalLight(0xffffff, intensity),
    point: () => new PointLight(0xffffff, intensity),
    spot: () => new SpotLight(0xffffff, intensity),
  }[type]();
  light.position.fromArray([...position]);
  return light;
}

/** RGBA of the canvas, top row first. */
function readPixels(width: number, height: number): Uint8Array {
  const gl = renderer.getContext();
  const upsideDown = new Uint8Array(width * height * 4);
  gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, upsideDown);
  const pixels = new Uint8Array(upsideDown.length);
  for (let row = 0; row < height; row++) {
    pixels.set(upsideDown.subarray(row * width * 4, (row + 1) * width * 4), (height - 1 - row) * width * 4);
  }
  return pixels;
}

function toBase64(bytes: Uint8Array): string {
  const CHUNK = 0x8000;
  let text = '';
  for (let i = 0; i < bytes.length; i += CHUNK) text += String.fromCharCode(...bytes.subarray(i, i + CHUNK));
  return btoa(text);
}
