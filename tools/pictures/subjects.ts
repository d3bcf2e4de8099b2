import {
  AnimationMixer,
  BufferAttribute,
  BufferGeometry,
  DoubleSide,
  FrontSide,
  Group,
  Mesh,
  MeshBasicMaterial,
  type Object3D,
  SphereGeometry,
} from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { OBJLoader } from 'three/addons/loaders/OBJLoader.js';
import { mergeVertices } from 'three/addons/utils/BufferGeometryUtils.js';
import { gearWheel } from '../../src/playground/models/gearWheel.js';
import { loadHand } from '../../src/playground/models/loadHand.js';
import { BUILT_IN_MODELS, type BuiltInModel } from '../../src/playground/models/models.js';
import type { PlainMesh } from '../../src/viewer/files/mesh/PlainMesh.js';

/** A subject of pictures. `files` are read from a folder of models and passed in this order. */
const subjects = {
  dragon: { load: () => builtIn('dragon2') },
  /** Something to cast a shadow on it. */
  dragonAndBall: {
    load: async () => {
      const ball = new Mesh(new SphereGeometry(0.28, 96, 48), paper());
      ball.position.set(-0.72, -0.41, 0.45);
      return new Group().add(await builtIn('dragon2'), ball);
    },
  },
  bunny: { load: () => builtIn('bunny') },
  ball: { load: async () => new Mesh(new SphereGeometry(1, 128, 64), paper()) },
  suzanne: { load: () => builtIn('suzanne') },
  teapot: { load: () => builtIn('teapot') },
  hand: { load: async () => meshOf(await loadHand(), true) },
  /** Two models with colours of their own. */
  house: { load: () => builtInScene('house') },
  drapery: { load: () => builtInScene('drapery') },
  gear: { load: async () => new Group().add(...gearWheel().map((geometry) => new Mesh(geometry, paper()))) },
  nefertiti: { load: async (content: ArrayBuffer) => objMesh(new TextDecoder().decode(content)) },
  /** The fox in the middle of a step of its clip "Walk". */
  fox: { load: (content: ArrayBuffer) => posed(content, 'Walk', 0.55) },
  man: { load: (content: ArrayBuffer) => posed(content, undefined, 0.3) },
} satisfies Record<string, { load(content: ArrayBuffer): Promise<Object3D> }>;

export type SubjectName = keyof typeof subjects;

/** Loads a subject, not hatched yet. `content` is that of its file, for those that lie in one. */
export const loadSubject = (name: SubjectName, content: ArrayBuffer): Promise<Object3D> => subjects[name].load(content);

const paper = (isOpen = false) => new MeshBasicMaterial({ side: isOpen ? DoubleSide : FrontSide });

function meshOf({ positions, normals, indices }: PlainMesh, isOpen = false): Mesh {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(positions, 3));
  if (normals) geometry.setAttribute('normal', new BufferAttribute(normals, 3));
  if (indices) geometry.setIndex(new BufferAttribute(indices, 1));
  return new Mesh(geometry, paper(isOpen));
}

async function builtInScene(name: BuiltInModel): Promise<Object3D> {
  const read = await BUILT_IN_MODELS[name].load({ signal: new AbortController().signal, onStage: () => {} });
  if (read.kind !== 'scene') throw new Error(`pictures: ${name} is not a scene.`);
  return read.scene.root;
}

async function builtIn(name: BuiltInModel): Promise<Object3D> {
  const read = await BUILT_IN_MODELS[name].load({ signal: new AbortController().signal, onStage: () => {} });
  if (read.kind !== 'mesh') throw new Error(`pictures: ${name} is not a mesh.`);
  return meshOf(read.mesh);
}

function objMesh(text: string): Object3D {
  let found: BufferGeometry | undefined;
  new OBJLoader().parse(text).traverse((object) => {
    if (object instanceof Mesh) found ??= object.geometry as BufferGeometry;
  });
  if (!found) throw new Error('pictures: the file contains no mesh.');
  for (const attribute of ['uv', 'normal']) found.deleteAttribute(attribute);
  const geometry = mergeVertices(found, 1e-4);
  geometry.computeVertexNormals();
  return new Mesh(geometry, paper());
}

async function posed(content: ArrayBuffer, clipName: string | undefined, time: number): Promise<Object3D> {
  const { scene, animations } = await new GLTFLoader().parseAsync(content, '');
  scene.traverse((object) => {
    if (object instanceof Mesh) object.material = paper();
  });
  const clip = animations.find(({ name }) => name === clipName) ?? animations[0];
  const mixer = new AnimationMixer(scene);
  mixer.clipAction(clip).play();
  mixer.setTime(time);
  return scene;
}
