import {
  Bone,
  type BufferGeometry,
  Float32BufferAttribute,
  InstancedMesh,
  Matrix4,
  Mesh,
  Skeleton,
  SkinnedMesh,
  Uint16BufferAttribute,
} from 'three';
import { HatchingMaterial, HatchingOutlines, prepareHatchingGeometry, TonalArtMap } from 'three-hatching';
import { plainLook } from '../../plainLook.js';
import { loadModel } from '../loadModel.js';
import { Stage } from '../Stage.js';
import { timeTurns } from '../timeTurns.js';

/** Degrees that the camera turns by from one frame to the next while the script is timed. */
const STEP = 1;

/** Milliseconds, one per turn or step. */
export interface LineTimes {
  triangles: number;
  /** Number of drawn primitives and of all. */
  listed: number;
  primitives: number;
  /** Whole frames of everything that was drawn. */
  times: Record<string, number[]>;
  /** Time of the lines in each frame on the main thread while the camera turned. */
  script: number[];
}

/**
 * Frames of a hatched model without lines and with them: with the list of candidates, testing every triangle, and, if
 * `isMoving`, as one instance and as a mesh with a skin, which have no list.
 */
export async function measureLines(model: string, turns: number, size: number, isMoving: boolean): Promise<LineTimes> {
  const plain = await loadModel(model);
  const geometry = await prepareHatchingGeometry(plain, { layout: 'indexed', outlines: true });
  const material = new HatchingMaterial(
    plainLook({ tonalArtMap: await TonalArtMap.generate(), technique: 'hatching' }),
  );
  const hatched = new Mesh(geometry, material);
  const lined = withOutlines(new Mesh(geometry, material));
  const tested = withOutlines(new Mesh(geometry, material));
  // At this weight nothing is drawn, but every triangle is tested.
  outlinesOf(tested).material.weights.suggestiveContours = 1e-9;
  const meshes: Record<string, Mesh> = { hatched, 'with lines': lined, 'with lines, no list': tested };
  if (isMoving) {
    meshes.instance = instanceOf(geometry, material);
    meshes['instance with lines'] = withOutlines(instanceOf(geometry, material));
    const skinned = await prepareHatchingGeometry(withSkin(plain), { layout: 'indexed', outlines: true });
    meshes.skinned = onBone(skinned, material.clone());
    meshes['skinned with lines'] = withOutlines(onBone(skinned, material.clone()));
  }

  const stage = new Stage(size);
  await listReady(stage, lined);
  const times = await timeTurns(stage, meshes, turns);
  const listed = outlinesOf(lined).geometry.drawRange.count / 3;
  const primitives = outlinesOf(tested).geometry.drawRange.count / 3;
  const script = await timeScript(stage, lined);
  return { triangles: geometry.index!.count / 3, listed, primitives, times, script };
}

function withOutlines<Kind extends Mesh>(mesh: Kind): Kind {
  mesh.add(new HatchingOutlines(mesh));
  return mesh;
}

const outlinesOf = (mesh: Mesh): HatchingOutlines => mesh.children.find((child) => child instanceof HatchingOutlines)!;

function instanceOf(geometry: BufferGeometry, material: HatchingMaterial): InstancedMesh {
  const mesh = new InstancedMesh(geometry, material, 1);
  mesh.setMatrixAt(0, new Matrix4());
  return mesh;
}

/** Gives every vertex to one bone. */
function withSkin(plain: BufferGeometry): BufferGeometry {
  const { count } = plain.attributes.position;
  const geometry = plain.clone();
  geometry.setAttribute('skinIndex', new Uint16BufferAttribute(new Uint16Array(4 * count), 4));
  geometry.setAttribute(
    'skinWeight',
    new Float32BufferAttribute(
      Float32Array.from({ length: 4 * count }, (_, i) => (i % 4 === 0 ? 1 : 0)),
      4,
    ),
  );
  return geometry;
}

function onBone(geometry: BufferGeometry, material: HatchingMaterial): SkinnedMesh {
  const mesh = new SkinnedMesh(geometry, material);
  const bone = new Bone();
  mesh.add(bone);
  mesh.bind(new Skeleton([bone]));
  // A new pose for every frame, as of a figure that walks.
  mesh.onBeforeRender = () => {
    bone.rotation.y += 1e-5;
  };
  return mesh;
}

/** Draws until the worker has sent the list of candidates. */
async function listReady(stage: Stage, mesh: Mesh): Promise<void> {
  stage.drawFrame(mesh);
  const first = outlinesOf(mesh).geometry.drawRange.count;
  for (let i = 0; i < 100; i++) {
    await new Promise((resolve) => setTimeout(resolve, 20));
    stage.drawFrame(mesh);
    if (outlinesOf(mesh).geometry.drawRange.count < first) return;
  }
}

/** Measures the time of the lines' own function while the camera turns. */
async function timeScript(stage: Stage, mesh: Mesh): Promise<number[]> {
  const lines = outlinesOf(mesh);
  const own = lines.onBeforeRender;
  const times: number[] = [];
  Object.assign(lines, {
    onBeforeRender: (...args: Parameters<typeof own>) => {
      const start = performance.now();
      own.apply(lines, args);
      times.push(performance.now() - start);
    },
  });
  for (let i = 0; i < 60; i++) {
    stage.turnCamera(STEP);
    stage.drawFrame(mesh);
    await new Promise((resolve) => setTimeout(resolve, 0));
  }
  // The first frames compile the program.
  return times.slice(10);
}
