import {
  BoxGeometry,
  type BufferGeometry,
  CapsuleGeometry,
  LatheGeometry,
  Mesh,
  TorusKnotGeometry,
  Vector2,
} from 'three';
import { OBJExporter } from 'three/addons/exporters/OBJExporter.js';
import { valueScenes } from '../modelFiles/valueScenes.js';
import { loadModel } from './loadModel.js';

/** A model as the content of a file. */
interface PlotModel {
  file: string;
  content: () => Promise<Uint8Array>;
}

const objOf = (make: () => BufferGeometry | Promise<BufferGeometry>): PlotModel => ({
  file: 'model.obj',
  content: async () => new TextEncoder().encode(new OBJExporter().parse(new Mesh(await make()))),
});

const vase = (): BufferGeometry => {
  const radii = [0.01, 0.34, 0.36, 0.28, 0.44, 0.62, 0.66, 0.54, 0.34, 0.22, 0.21, 0.27, 0.38];
  return new LatheGeometry(
    radii.map((radius, i) => new Vector2(radius, 0.17 * i)),
    96,
  );
};

/** Models that are made here, of one part and of several. */
export function plotModels(): Record<string, PlotModel> {
  const models: Record<string, PlotModel> = {
    bunny: objOf(() => loadModel('bunny')),
    knot: objOf(() => new TorusKnotGeometry(0.6, 0.22, 160, 32)),
    vase: objOf(vase),
    box: objOf(() => new BoxGeometry(1.6, 1, 1.2)),
    pill: objOf(() => new CapsuleGeometry(0.5, 1, 12, 48).rotateZ(1)),
  };
  for (const [name, bytes] of Object.entries(valueScenes()))
    models[name] = { file: `${name}.glb`, content: async () => bytes };
  return models;
}
