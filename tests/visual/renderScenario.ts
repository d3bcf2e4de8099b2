/** The page of the screenshot tests. It renders one scenario after another and returns its pixels. */
import {
  type ColorRepresentation,
  DirectionalLight,
  type Light,
  Mesh,
  type Object3D,
  PerspectiveCamera,
  PointLight,
  Scene,
  SpotLight,
  WebGLRenderer,
} from 'three';
import {
  applyHatching,
  HatchingMaterial,
  HatchingOutlines,
  prepareHatchingGeometry,
  presets,
  TonalArtMap,
} from 'three-hatching';
import { followsForm } from 'three-hatching/facts';
import { plainLook } from '../../tools/plainLook.js';
import { isScene, loadScenarioModel, makeScenarioScene } from './scenarioModels.js';
import type { Scenario, ScenarioLight, ScenarioModel, SceneModel } from './scenarios.js';
import { widenStrokes } from './widenStrokes.js';

export interface RenderedPixels {
  width: number;
  height: number;
  /** RGBA of all pixels, top row first, as base64: arrays of numbers are slow to hand over. */
  base64: string;
}

/** Deliberate changes that the comparison must notice. */
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
document.body.append(renderer.domElement);

window.renderScenario = async (scenario, deviation = {}) => {
  const drawn = await (isScene(scenario.model)
    ? drawnScene(scenario, scenario.model)
    : drawnMesh(scenario, scenario.model, deviation));
  drawn.object.rotation.fromArray([...(scenario.modelRotation ?? [0, 0, 0])]);

  const scene = new Scene();
  scene.add(drawn.object, ...scenario.lights.map(makeLight));
  const [width, height] = scenario.size;
  const { position, fov, target = [0, 0, 0] } = scenario.camera;
  const camera = new PerspectiveCamera(fov, width / height, 0.1, 100);
  camera.position.fromArray([...position]);
  camera.lookAt(...target);

  renderer.setClearColor(drawn.paper);
  renderer.setSize(width, height, false);
  renderer.render(scene, camera);
  const pixels = readPixels(width, height);
  drawn.dispose();
  return { width, height, base64: toBase64(pixels) };
};

/** The scene of a picture and its background colour. */
interface Drawn {
  object: Object3D;
  paper: ColorRepresentation;
  dispose(): void;
}

async function drawnMesh(
  scenario: Scenario,
  model: Exclude<ScenarioModel, SceneModel>,
  { strokeWidth }: Deviation,
): Promise<Drawn> {
  const tonalArtMap =
    strokeWidth === undefined
      ? await TonalArtMap.generate(scenario.tonalArtMap)
      : TonalArtMap.fromHatchImages(widenStrokes(scenario.tonalArtMap, strokeWidth));
  const geometry = await prepareHatchingGeometry(await loadScenarioModel(model), {
    adjacency: true,
    outlines: scenario.outlines !== undefined,
    form: followsForm(scenario.material),
  });
  tonalArtMap.texture.anisotropy = scenario.anisotropy ?? 1;
  const material = new HatchingMaterial(plainLook({ tonalArtMap, ...scenario.material }));
  await material.ready;
  const mesh = new Mesh(geometry, material);
  const outlines = scenario.outlines && new HatchingOutlines(mesh, scenario.outlines);
  if (outlines) mesh.add(outlines);
  return {
    object: mesh,
    paper: 'white',
    dispose: () => {
      for (const thing of [geometry, material, tonalArtMap, outlines]) thing?.dispose();
    },
  };
}

async function drawnScene({ name, preset }: Scenario, model: SceneModel): Promise<Drawn> {
  if (!preset) throw new Error(`renderScenario: ${name} has no preset.`);
  const object = makeScenarioScene(model);
  const hatched = await applyHatching(object, { preset });
  await hatched.formReady;
  return { object, paper: presets[preset].material.paper ?? 'white', dispose: () => hatched.dispose() };
}

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
