import {
  BoxGeometry,
  type BufferGeometry,
  type Camera,
  Float32BufferAttribute,
  InstancedMesh,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  type Object3D,
  type Scene,
  type SkinnedMesh,
} from 'three';
import {
  HatchingOutlineMaterial,
  type HatchingOutlineParameters,
  HatchingOutlines,
  prepareHatchingGeometry,
} from 'three-hatching';
import { HatchingOutlineNodeMaterial, HatchingOutlines as NodeOutlines } from 'three-hatching/webgpu';
import { bentTube, egg } from '../deforming.js';
import { knot } from '../knot.js';
import type { Kit, SceneCase, Stage } from '../SceneCase.js';

const LOOK = { outlineWidth: 3, weights: { creases: 0.8 } } as const;

const paper = (): MeshBasicMaterial => new MeshBasicMaterial({ color: 0xfff4dd });

/** Gives all meshes outlines of one material. */
async function outline<Shown extends Mesh[]>(
  { either }: Kit,
  look: HatchingOutlineParameters,
  options: Parameters<typeof prepareHatchingGeometry>[1],
  ...meshes: Shown
): Promise<Shown> {
  const prepared = new Map<BufferGeometry, BufferGeometry>();
  for (const { geometry } of meshes) {
    if (prepared.has(geometry)) continue;
    prepared.set(geometry, await prepareHatchingGeometry(geometry, { ...options, outlines: true }));
  }
  for (const mesh of meshes) mesh.geometry = prepared.get(mesh.geometry)!;
  either<void, void>(
    () => {
      const material = new HatchingOutlineMaterial(look);
      for (const mesh of meshes) mesh.add(new HatchingOutlines(mesh, material));
    },
    () => {
      const material = new HatchingOutlineNodeMaterial(look);
      for (const mesh of meshes) mesh.add(new NodeOutlines(mesh, material));
    },
  );
  return meshes;
}

function staged(...objects: Object3D[]): { scene: Scene; camera: Camera } {
  const { scene, camera, mesh } = knot(paper());
  scene.remove(mesh);
  scene.add(...objects);
  return { scene, camera };
}

const bend = (tube: SkinnedMesh, angle: number): void => {
  tube.skeleton.bones[1].rotation.z = angle;
};

/** A tube that bones bend and a morph target makes thick in the middle. */
function bulgingTube(): SkinnedMesh {
  const tube = bentTube(paper());
  const { position, normal } = tube.geometry.attributes;
  const places = [...position.array];
  for (let i = 0; i < position.count; i++) {
    const wider = 1 + 0.6 * Math.exp(-20 * position.getY(i) ** 2);
    places[3 * i] *= wider;
    places[3 * i + 2] *= wider;
  }
  tube.geometry.morphAttributes = { position: [new Float32BufferAttribute(places, 3)], normal: [normal] };
  tube.updateMorphTargets();
  tube.morphTargetInfluences![0] = 0.8;
  return tube;
}

/** Outlines of meshes with bones and morph targets. */
export const cases: readonly SceneCase[] = [
  {
    name: 'outlines of a skin',
    show: async (kit) => staged(...(await outline(kit, LOOK, {}, bentTube(paper())))),
  },
  {
    name: 'outlines of a skin whose bones move on',
    async show(kit): Promise<Stage> {
      const [tube] = await outline(kit, LOOK, {}, bentTube(paper()));
      return { ...staged(tube), change: () => bend(tube, 0.7) };
    },
  },
  {
    name: 'outlines of a skin that has its neighbours in textures',
    async show(kit) {
      return staged(...(await outline(kit, LOOK, { adjacency: true, layout: 'pull' }, bentTube(paper()))));
    },
  },
  {
    name: 'outlines of a morph target',
    show: async (kit) => staged(...(await outline(kit, LOOK, {}, egg(paper())))),
  },
  {
    name: 'outlines of a skin with a morph target',
    show: async (kit) => staged(...(await outline(kit, LOOK, {}, bulgingTube()))),
  },
  {
    name: 'poses of one geometry, and a box at rest, with outlines of one material',
    async show(kit): Promise<Stage> {
      const first = egg(paper());
      const second = new Mesh(first.geometry, paper());
      const third = new Mesh(first.geometry, paper());
      const box = new Mesh(new BoxGeometry(0.5, 0.5, 0.5), paper());
      for (const [i, mesh] of [first, second, third, box].entries()) {
        mesh.position.set(i % 2 ? 0.5 : -0.5, i < 2 ? 0.5 : -0.5, 0);
        mesh.scale.setScalar(i < 3 ? 0.6 : 1);
        mesh.rotation.set(0.4, 0.5 + i, 0);
      }
      second.morphTargetInfluences![0] = -0.6;
      await outline(kit, LOOK, {}, first, second, third, box);
      return {
        ...staged(first, second, third, box),
        change() {
          third.morphTargetInfluences![0] = 0.7;
          second.morphTargetInfluences![0] = 0;
        },
      };
    },
  },
  {
    name: 'outlines of instances with a morph target',
    async show(kit) {
      const { geometry, morphTargetInfluences } = egg(paper());
      const many = new InstancedMesh(geometry, paper(), 3);
      many.morphTargetInfluences = morphTargetInfluences;
      for (let i = 0; i < 3; i++) {
        const place = new Matrix4().makeRotationZ(0.6 * i).multiply(new Matrix4().makeScale(0.5, 0.5, 0.5));
        many.setMatrixAt(i, place.setPosition(0.7 * i - 0.7, 0.2 * i, 0));
      }
      return staged(...(await outline(kit, LOOK, {}, many)));
    },
  },
  {
    name: 'hidden outlines of a skin, dashed',
    show: async (kit) => staged(...(await outline(kit, { ...LOOK, hidden: 'dashed' }, {}, bentTube(paper())))),
  },
  {
    name: 'suggestive contours of a skin by an unsteady hand',
    show: async (kit) =>
      staged(
        ...(await outline(
          kit,
          { ...LOOK, weights: { ...LOOK.weights, suggestiveContours: 0.8 }, wobble: 2 },
          {},
          bulgingTube(),
        )),
      ),
  },
];
