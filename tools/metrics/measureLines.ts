/** Measures how far drawings that leave as lines are from the canvas: a model in every engraved preset. */
import { type BufferGeometry, LoadingManager, type Object3D } from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { type PresetName, presets } from 'three-hatching';
import { compareLines, type InkDifference } from './linesAgainstCanvas.js';
import { loadModel, type ModelName, parseModel } from './loadModel.js';

/** A file as the command reads it. */
export interface FileText {
  name: string;
  base64: string;
}

/** The farthest that four drawings of a model in a preset are from the canvas, by each figure. */
export interface LineDifference extends Omit<InkDifference, 'leftOut'> {
  /** Light and view of the drawing with the largest mean. */
  worst: string;
  /** Reasons for which drawings leave something out. */
  leftOut: string[];
}

/** The results of every engraved preset. */
export type ModelLines = Record<string, LineDifference>;

const LEFT = { name: 'light from the left', light: [-0.55, 0.75, 0.6] } as const;
const RIGHT = { name: 'light from the right', light: [0.9, 0.7, 0.5] } as const;

/** Four drawings that together have each pair of two lights, two cameras, and shadows or none. */
const WAYS = [
  { ...LEFT, hasShadows: false, isOrthographic: false },
  { ...RIGHT, hasShadows: true, isOrthographic: false },
  { ...LEFT, hasShadows: true, isOrthographic: true },
  { ...RIGHT, hasShadows: false, isOrthographic: true },
] as const;

/** The presets whose lines are curves on the surface. */
const engravedPresets = (): PresetName[] =>
  (Object.keys(presets) as PresetName[]).filter((name) => presets[name].material.technique === 'engraving');

/**
 * Draws a model in every engraved preset, four times each.
 *
 * @param source a model of the metrics, or files: the first is the model
 * @param only the presets that are drawn
 */
export async function measureLines(
  source: ModelName | readonly FileText[],
  only: readonly string[] = engravedPresets(),
): Promise<ModelLines> {
  const found: ModelLines = {};
  for (const preset of engravedPresets().filter((name) => only.includes(name))) {
    const drawn: (InkDifference & { way: string })[] = [];
    for (const { name, ...way } of WAYS) {
      const model = typeof source === 'string' ? await loadModel(source) : await loadFiles(source);
      const words = [name, way.hasShadows && 'shadows', way.isOrthographic && 'orthographic'];
      drawn.push({ ...(await compareLines(model, { preset, ...way })), way: words.filter(Boolean).join(', ') });
    }
    const farthest = (distance: (one: InkDifference) => number) =>
      drawn.reduce((far, one) => (distance(one) > distance(far) ? one : far));
    const { mean, way } = farthest((one) => one.mean);
    found[preset] = {
      ...{ mean, worst: way },
      p99: farthest((one) => one.p99).p99,
      ink: farthest(({ ink }) => Math.abs(ink - 1)).ink,
      leftOut: [...new Set(drawn.flatMap(({ leftOut }) => leftOut))],
    };
  }
  return found;
}

/** A pixel of ochre, in the place of pictures that are not there. */
const OCHRE =
  'data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAIAAACQd1PeAAAADElEQVR4nGM406EEAAOaAXfTWgMKAAAAAElFTkSuQmCC';

/** The model of an OBJ or glTF file, in its first pose. */
async function loadFiles(files: readonly FileText[]): Promise<BufferGeometry | Object3D> {
  const [{ name, base64 }] = files;
  const url = (text: string) => `data:application/octet-stream;base64,${text}`;
  if (name.endsWith('.obj')) return parseModel(await (await fetch(url(base64))).text());
  const manager = new LoadingManager().setURLModifier((asked) => {
    const found = files.find((file) => asked.endsWith(file.name));
    return found ? url(found.base64) : asked.endsWith('.png') ? OCHRE : asked;
  });
  const loaded = new Promise<void>((resolve) => {
    manager.onLoad = resolve;
  });
  const { scene } = await new GLTFLoader(manager).loadAsync(name);
  await loaded;
  scene.updateMatrixWorld(true);
  return scene;
}
