/** Measures how much of a model is paper, half tone and dark in every preset. */
import { type PerspectiveCamera, Scene, Vector3, type WebGLRenderer, WebGLRenderTarget } from 'three';
import { flatteringLight, type HatchingMaterial, type PresetName, presets } from 'three-hatching';
import { BUILT_IN_MODELS, type BuiltInModel } from '../../src/playground/models/models.js';
import { loadModelFiles } from '../../src/playground/reading/loadModelFiles.js';
import { buildModel } from '../../src/viewer/drawing/buildModel.js';
import type { HatchedModel } from '../../src/viewer/drawing/HatchedModel.js';
import { meshesOf } from '../../src/viewer/drawing/meshes.js';
import { createCamera, DEFAULT_VIEW } from '../../src/viewer/sceneSetup/LensCamera.js';
import { LightRig } from '../../src/viewer/sceneSetup/LightRig.js';
import { lookOf } from '../../src/viewer/settings/lookOf.js';
import { presetLook } from '../../src/viewer/settings/presets.js';
import { defaultSettings } from '../../src/viewer/settings/settings.js';

/** Shares of what is seen of a model. The three make 1. */
export interface ValueShares {
  paper: number;
  half: number;
  dark: number;
}

/** The shares of every preset, with fitted exposure and with the light as it is. */
export type ModelValues = Record<PresetName, { auto: ValueShares; fixed: ValueShares }>;

/** A model of the page, or files. */
export type ValueSource = BuiltInModel | readonly FileText[];

/** A file as the command reads it. */
interface FileText {
  name: string;
  base64: string;
}

const SIZE = 160;
/** The distance of the camera from the model's centre at which its bounding sphere is wholly visible. */
const DISTANCE = 4.6;
/** Lighter, beside the lightest tone of a look, is blank paper with a stroke here and there; darker is more ink than paper. */
const HALF_TONES = { from: 0.09, to: 0.5 } as const;
/** Simple enough to be all in one tone. */
const LEFT_OUT: readonly BuiltInModel[] = ['cube', 'dragon1', 'dragon2'];

/** The models of the page that are measured. */
export const measuredModels = (): BuiltInModel[] =>
  (Object.keys(BUILT_IN_MODELS) as BuiltInModel[]).filter((name) => !LEFT_OUT.includes(name));

/**
 * Draws the tones of a model as the page shows it when it is opened, in a light that suits the view, without shadows and without occlusion.
 */
export async function measureValues(renderer: WebGLRenderer, source: ValueSource): Promise<ModelValues> {
  const { model, view } = await loadSource(source);
  const scene = new Scene();
  scene.add(model.root);
  const camera = createCamera();
  camera.position.copy(new Vector3(...view).setLength(DISTANCE));
  camera.lookAt(0, 0, 0);
  scene.updateMatrixWorld();
  const lights = new LightRig(scene);
  const { direction } = flatteringLight(model.root, camera);
  const target = new WebGLRenderTarget(SIZE, SIZE);
  const found: Partial<ModelValues> = {};
  for (const name of Object.keys(presets) as PresetName[]) {
    const settings = { ...defaultSettings(), ...presetLook(name), debugView: 'tone' } as const;
    const shares = (['auto', 'fixed'] as const).map((exposure) => {
      const look = lookOf({ ...settings, exposure });
      lights.apply(look.lights);
      model.apply(look);
      lights.place(camera);
      for (const light of scene.children) if ('isDirectionalLight' in light) light.position.copy(direction);
      return drawShares(renderer, scene, camera, target, materialsOf(model), lightestOf(name));
    });
    found[name] = { auto: shares[0], fixed: shares[1] };
  }
  target.dispose();
  model.dispose();
  return found as ModelValues;
}

/** The lightest tone of a look: the tooth of paper takes a little in the lights, too. */
function lightestOf(name: PresetName): number {
  const { toneCurve = 'linear' } = presets[name].material;
  return typeof toneCurve === 'string' ? 0 : Math.min(...toneCurve.map(([, printed]) => printed));
}

const materialsOf = ({ root }: HatchedModel): HatchingMaterial[] =>
  meshesOf(root).flatMap(({ material }) => material as HatchingMaterial | HatchingMaterial[]);

export async function loadSource(
  source: ValueSource,
): Promise<{ model: HatchedModel; view: readonly [number, number, number] }> {
  const options = { signal: new AbortController().signal, onStage: () => {} };
  const builtIn = typeof source === 'string' ? BUILT_IN_MODELS[source] : undefined;
  const read = builtIn
    ? await builtIn.load(options)
    : await loadModelFiles(
        (source as readonly FileText[]).map(({ name, base64 }) => ({
          name,
          content: new Blob([Uint8Array.from(atob(base64), (character) => character.charCodeAt(0))]),
        })),
        options,
      );
  const { model } = await buildModel(read, () => {}, options.signal);
  return { model, view: builtIn?.view ?? DEFAULT_VIEW };
}

function drawShares(
  renderer: WebGLRenderer,
  scene: Scene,
  camera: PerspectiveCamera,
  target: WebGLRenderTarget,
  materials: readonly HatchingMaterial[],
  lightest: number,
): ValueShares {
  // The ground would show through transparent parts.
  for (const material of materials) material.paperOpacity = 1;
  const pixels = new Uint8Array(4 * SIZE * SIZE);
  renderer.setRenderTarget(target);
  renderer.setClearColor(0x000000, 0);
  renderer.clear();
  renderer.render(scene, camera);
  renderer.readRenderTargetPixels(target, 0, 0, SIZE, SIZE, pixels);
  renderer.setRenderTarget(null);
  const counts = { paper: 0, half: 0, dark: 0 };
  for (let i = 0; i < pixels.length; i += 4) {
    if (pixels[i + 3] < 255) continue;
    const tone = 1 - pixels[i] / 255;
    counts[tone < lightest + HALF_TONES.from ? 'paper' : tone > HALF_TONES.to ? 'dark' : 'half']++;
  }
  const all = counts.paper + counts.half + counts.dark;
  return { paper: counts.paper / all, half: counts.half / all, dark: counts.dark / all };
}
