import {
  BoxGeometry,
  type BufferGeometry,
  CylinderGeometry,
  Group,
  LatheGeometry,
  Mesh,
  MeshStandardMaterial,
  type Object3D,
  SplineCurve,
  Uint8BufferAttribute,
  Vector2,
} from 'three';
import { GLTFExporter } from 'three/addons/exporters/GLTFExporter.js';
import { mergeVertices } from 'three/addons/utils/BufferGeometryUtils.js';
import { makeFish } from '../../src/playground/models/makeFish.js';
import { NodeFileReader } from '../../tools/modelFiles/NodeFileReader.js';

/** The models by file name, as GLB. */
export async function makeModels(): Promise<Record<string, Uint8Array>> {
  Object.assign(globalThis, { FileReader: NodeFileReader });
  const { root, animations } = makeFish();
  root.traverse((object) => {
    if ('geometry' in object) shorten(object.geometry as BufferGeometry);
  });
  const exporter = new GLTFExporter();
  const glb = async (scene: Object3D, options = {}): Promise<Uint8Array> =>
    new Uint8Array((await exporter.parseAsync(scene, { binary: true, ...options })) as ArrayBuffer);
  return {
    'fish.glb': await glb(root, { animations: animations.slice(0, 1) }),
    'still-life.glb': await glb(stillLife()),
  };
}

/** Leaves out what the examples do not show, and stores the rest in few bytes. */
function shorten(geometry: BufferGeometry): void {
  geometry.morphAttributes = {};
  geometry.computeVertexNormals();
  geometry.deleteAttribute('uv');
  const { skinIndex, skinWeight } = geometry.attributes;
  if (!skinIndex) return;
  geometry.setAttribute('skinIndex', new Uint8BufferAttribute(skinIndex.array, 4));
  const weights = Array.from(skinWeight.array, (weight) => Math.round(255 * weight));
  geometry.setAttribute('skinWeight', new Uint8BufferAttribute(weights, 4, true));
}

/** A jug, an apple and two pears on a board. */
function stillLife(): Group {
  const jug = turned(
    [
      [0.001, 0],
      [0.34, 0],
      [0.37, 0.05],
      [0.5, 0.3],
      [0.56, 0.6],
      [0.47, 0.92],
      [0.27, 1.16],
      [0.21, 1.34],
      [0.24, 1.5],
      [0.33, 1.58],
      [0.3, 1.585],
      [0.19, 1.4],
      [0.2, 1.2],
    ],
    56,
    56,
  );
  const apple = turned(
    [
      [0.001, 0.05],
      [0.1, 0.01],
      [0.26, 0.09],
      [0.37, 0.3],
      [0.35, 0.5],
      [0.2, 0.62],
      [0.08, 0.59],
      [0.001, 0.54],
    ],
    32,
    40,
  );
  const pear = turned(
    [
      [0.001, 0.02],
      [0.14, 0.01],
      [0.29, 0.13],
      [0.33, 0.3],
      [0.26, 0.5],
      [0.15, 0.68],
      [0.11, 0.8],
      [0.05, 0.88],
      [0.001, 0.87],
    ],
    32,
    40,
  );
  const stem = () => new CylinderGeometry(0.014, 0.022, 0.16, 10);
  const group = new Group();
  const add = (name: string, geometry: BufferGeometry, colour: string) => {
    const mesh = new Mesh(geometry, new MeshStandardMaterial({ name, color: colour }));
    mesh.name = name;
    group.add(mesh);
    return mesh;
  };
  add('board', new BoxGeometry(3.6, 0.12, 1.9, 36, 1, 19).translate(0, -0.06, 0.1), '#ffffff');
  add('jug', jug, '#ffffff').position.set(-0.62, 0, -0.15);
  const fruit = (name: string, profile: BufferGeometry, height: number) => {
    const mesh = add(name, profile, '#ffffff');
    mesh.add(
      new Mesh(
        stem()
          .translate(0.02, height + 0.04, 0)
          .rotateZ(-0.1),
        mesh.material,
      ),
    );
    return mesh;
  };
  fruit('apple', apple, 0.57).position.set(0.16, 0, 0.42);
  fruit('pear', pear, 0.88).position.set(0.78, 0, -0.1);
  // One lies down.
  const lying = fruit('lying pear', pear, 0.88);
  lying.position.set(1.42, 0.29, 0.62);
  lying.rotation.set(0.2, 0.9, 1.5);
  return group;
}

/** A body of revolution whose profile runs smoothly through points. */
function turned(profile: readonly (readonly [radius: number, height: number])[], along: number, around: number) {
  const points = new SplineCurve(profile.map(([x, y]) => new Vector2(x, y)))
    .getPoints(along)
    .map(({ x, y }) => new Vector2(Math.max(x, 0.001), y));
  const geometry = new LatheGeometry(points, around);
  geometry.deleteAttribute('uv');
  geometry.deleteAttribute('normal');
  const joined = mergeVertices(geometry, 1e-4);
  joined.computeVertexNormals();
  return joined.setIndex([...joined.index!.array]);
}
