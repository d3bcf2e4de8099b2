import {
  BatchedMesh,
  BoxGeometry,
  DataTexture,
  InstancedMesh,
  type Material,
  Matrix4,
  Mesh,
  SphereGeometry,
  TorusKnotGeometry,
  Vector3,
} from 'three';
import { type HatchingMaterialParameters, prepareHatchingGeometry } from 'three-hatching';
import { bentTube, egg } from '../deforming.js';
import { type KnotStage, knot } from '../knot.js';
import type { Kit, SceneCase } from '../SceneCase.js';

const LINES = {
  technique: 'engraving',
  direction: 'light',
  shadowStrokes: 'tone',
  composition: { exposure: 1 },
} as const;

const lines = (kit: Kit, parameters: HatchingMaterialParameters = {}): Promise<Material> =>
  kit.hatching({ ...LINES, ...parameters });

/** Shows objects in place of the knot. */
function showing(material: Material, ...objects: Mesh[]): KnotStage {
  const stage = knot(material);
  stage.scene.remove(stage.mesh);
  stage.scene.add(...objects);
  return stage;
}

const moved = (x: number, y: number, turn: number, size = 1): Matrix4 =>
  new Matrix4()
    .makeTranslation(x, y, 0)
    .multiply(new Matrix4().makeRotationAxis(new Vector3(1, 2, 0.5).normalize(), turn))
    .multiply(new Matrix4().makeScale(size, 0.7 * size, 1.2 * size));

/** One material on each kind of object of three.js. */
export const cases: readonly SceneCase[] = [
  {
    name: 'two meshes of one material',
    async show(kit) {
      const material = await lines(kit);
      const ball = new Mesh(new SphereGeometry(0.5, 40, 30), material);
      ball.applyMatrix4(moved(-0.6, 0.2, 0.4));
      const box = new Mesh(new BoxGeometry(0.8, 0.8, 0.8), material);
      box.applyMatrix4(moved(0.5, -0.1, 1.1));
      return showing(material, ball, box);
    },
  },
  {
    name: 'instances',
    async show(kit) {
      const material = await lines(kit);
      const mesh = new InstancedMesh(new TorusKnotGeometry(0.25, 0.1, 64, 12), material, 4);
      for (let i = 0; i < 4; i++) mesh.setMatrixAt(i, moved(0.5 * (i % 2 ? 1 : -1), i < 2 ? 0.5 : -0.5, 0.8 * i, 1.3));
      return showing(material, mesh);
    },
  },
  {
    name: 'a batch',
    async show(kit) {
      const material = await lines(kit);
      const mesh = new BatchedMesh(4, 8000, 24000, material);
      const ids = [new TorusKnotGeometry(0.25, 0.1, 64, 12), new BoxGeometry(0.5, 0.5, 0.5)].map((geometry) =>
        mesh.addGeometry(geometry),
      );
      for (let i = 0; i < 4; i++) {
        const instance = mesh.addInstance(ids[i % 2]);
        mesh.setMatrixAt(instance, moved(0.5 * (i % 2 ? 1 : -1), i < 2 ? 0.5 : -0.5, 0.8 * i, 1.2));
      }
      return showing(material, mesh);
    },
  },
  {
    name: 'a skin, strokes as at rest',
    async show(kit) {
      const material = await lines(kit);
      return showing(material, bentTube(material));
    },
  },
  {
    name: 'a skin, strokes as deformed',
    async show(kit) {
      const material = await lines(kit, { strokeAnchor: 'deformed' });
      return showing(material, bentTube(material));
    },
  },
  {
    // The common case with the most vertex buffers: as many as WebGPU guarantees.
    name: 'a skin with a map, lines along its form',
    async show(kit) {
      const map = new DataTexture(Uint8Array.of(255, 200, 150, 255, 90, 120, 255, 255), 2, 1);
      map.needsUpdate = true;
      const material = Object.assign(await lines(kit, { direction: 'form' }), { map });
      const mesh = bentTube(material);
      mesh.geometry = await prepareHatchingGeometry(mesh.geometry, { form: true });
      return showing(material, mesh);
    },
  },
  {
    name: 'a morph target, strokes as at rest',
    async show(kit) {
      const material = await lines(kit);
      return showing(material, egg(material));
    },
  },
  {
    name: 'a morph target, strokes as deformed',
    async show(kit) {
      const material = await lines(kit, { strokeAnchor: 'deformed' });
      return showing(material, egg(material));
    },
  },
  {
    name: 'anchored strokes on instances',
    onWebGPU: 'tone',
    async show(kit) {
      const material = await lines(kit, { technique: 'hatching' });
      const mesh = new InstancedMesh(new TorusKnotGeometry(0.25, 0.1, 64, 12), material, 2);
      for (let i = 0; i < 2; i++) mesh.setMatrixAt(i, moved(i ? 0.5 : -0.5, 0, 0.8 * i, 1.5));
      return showing(material, mesh);
    },
  },
  {
    name: 'anchored strokes on a skin, as deformed',
    onWebGPU: 'tone',
    async show(kit) {
      const material = await lines(kit, { technique: 'hatching', strokeAnchor: 'deformed' });
      return showing(material, bentTube(material));
    },
  },
];
