import {
  BoxGeometry,
  type BufferGeometry,
  CylinderGeometry,
  Matrix4,
  PlaneGeometry,
  Quaternion,
  SphereGeometry,
  TorusGeometry,
  Vector3,
} from 'three';
import { addTrack, GltfBuilder, type Json } from '../modelFiles/GltfBuilder.js';

/** A part of a file: a surface, which may be drawn from both sides, in a place, or in several. */
interface Part {
  geometry: BufferGeometry;
  material?: Json;
  matrix?: Matrix4;
  instances?: Matrix4[];
  children?: Part[];
}

const MIRROR = new Matrix4().makeScale(-1, 1, 1);
const at = (x: number, y = 0, z = 0): Matrix4 => new Matrix4().makeTranslation(x, y, z);
const DOUBLE = { doubleSided: true };
const glass = (alpha: number): Json => ({
  alphaMode: 'BLEND',
  pbrMetallicRoughness: { baseColorFactor: [1, 1, 1, alpha] },
});

/** The geometry with its triangles and normals turned to the other side. */
function inward<Geometry extends BufferGeometry>(geometry: Geometry): Geometry {
  const index = geometry.index!;
  for (let corner = 0; corner < index.count; corner += 3) {
    const b = index.getX(corner + 1);
    index.setX(corner + 1, index.getX(corner + 2));
    index.setX(corner + 2, b);
  }
  const { normal } = geometry.attributes;
  for (let i = 0; i < normal.count; i++) normal.setXYZ(i, -normal.getX(i), -normal.getY(i), -normal.getZ(i));
  return geometry;
}

/** A box without some of its sides: right, left, top, bottom, front and back are 0 to 5. */
function boxWithout(...sides: number[]): BufferGeometry {
  const box = new BoxGeometry(3, 2, 3);
  return box.setIndex([...box.index!.array].filter((_, corner) => !sides.includes(Math.floor(corner / 6))));
}

const crate = (x: number, z: number): Part => ({ geometry: new BoxGeometry(0.6, 0.6, 0.6), matrix: at(x, -0.7, z) });
const bowl = (): BufferGeometry => new SphereGeometry(1, 24, 12, 0, 2 * Math.PI, 1.2, 2);
const sheet = (): BufferGeometry => new PlaneGeometry(2, 2, 3, 3);
const leaves = Array.from({ length: 12 }, (_, i) =>
  new Matrix4()
    .makeRotationY(0.7 * i)
    .multiply(new Matrix4().makeRotationX(0.4 * i))
    .multiply(at(0, 0, 1)),
);

const SCENES: Readonly<Record<string, Part[]>> = {
  room: [{ geometry: inward(new BoxGeometry(3, 2, 3)) }, crate(0.5, 0.3), crate(-0.8, -0.6)],
  'room of both sides': [{ geometry: inward(boxWithout(4)), material: DOUBLE }, crate(0.5, 0.3)],
  'room without a front': [{ geometry: inward(boxWithout(4)) }, crate(0.5, 0.3)],
  'house without a roof': [{ geometry: boxWithout(2) }, crate(0.2, 0)],
  'house of both sides': [{ geometry: boxWithout(2), material: DOUBLE }, crate(0.2, 0)],
  'inside out': [{ geometry: inward(new TorusGeometry(1, 0.4, 16, 32)) }],
  'inside out, both sides': [{ geometry: inward(new TorusGeometry(1, 0.4, 16, 32)), material: DOUBLE }],
  bowls: [{ geometry: bowl() }, { geometry: bowl(), material: DOUBLE, matrix: at(2.5) }],
  'mixed sides': [
    { geometry: sheet() },
    { geometry: sheet(), material: DOUBLE, matrix: at(0, 0, -1).multiply(new Matrix4().makeRotationY(2.6)) },
    { geometry: inward(new CylinderGeometry(0.5, 0.5, 1, 16, 1, true)), matrix: at(1.6) },
  ],
  'sheets back to back': [{ geometry: sheet() }, { geometry: inward(sheet()) }],
  mirrored: [
    { geometry: boxWithout(0, 4), matrix: MIRROR },
    { geometry: bowl(), matrix: at(3) },
  ],
  'mirrored twice': [
    { geometry: boxWithout(0), matrix: MIRROR, children: [{ geometry: bowl(), matrix: at(3).multiply(MIRROR) }] },
  ],
  'mirrored in a mirrored one': [
    {
      geometry: bowl(),
      matrix: new Matrix4().makeScale(1, -1, 1),
      children: [{ geometry: boxWithout(2), matrix: new Matrix4().makeScale(1, 1, -0.5).setPosition(3, 0, 0) }],
    },
  ],
  'mirrored, both sides': [{ geometry: boxWithout(0), matrix: MIRROR, material: DOUBLE }, crate(2, 2)],
  instances: [{ geometry: bowl(), instances: [at(-2), at(0, 1), at(2)] }],
  'mirrored instances': [{ geometry: bowl(), instances: [at(-2), at(0, 1).multiply(MIRROR), at(2).multiply(MIRROR)] }],
  'mirrored instances in a mirrored node': [
    { geometry: boxWithout(2), matrix: MIRROR, instances: [at(-4), at(0).multiply(MIRROR), at(4)] },
  ],
  'mirrored instances, both sides': [
    { geometry: bowl(), material: DOUBLE, instances: [at(-2), at(1).multiply(MIRROR)] },
  ],
  leaves: [{ geometry: new PlaneGeometry(0.6, 1), instances: leaves }],
  'leaves of both sides': [{ geometry: new PlaneGeometry(0.6, 1), material: DOUBLE, instances: leaves }],
  'glass before a room': [
    { geometry: inward(boxWithout(4)) },
    { geometry: sheet(), material: glass(0.3), matrix: at(0, 0, 1.6) },
    crate(0.4, 0),
  ],
  'opaque blending': [{ geometry: bowl(), material: { ...glass(1), doubleSided: true } }, crate(2, 0)],
  'cut out by alpha': [
    { geometry: sheet(), material: { alphaMode: 'MASK', pbrMetallicRoughness: { baseColorFactor: [1, 1, 1, 0.2] } } },
    { geometry: bowl(), material: { alphaMode: 'MASK', doubleSided: true }, matrix: at(2) },
  ],
};

/** Files that test which sides are drawn, each at rest, which is drawn as one mesh, and in motion, which stays a scene. */
export function sidedFiles(): { name: string; bytes: Uint8Array }[] {
  return Object.entries(SCENES).flatMap(([name, parts]) =>
    [false, true].map((moves) => ({ name: `${name}${moves ? ', moving' : ''}.glb`, bytes: fileOf(parts, moves) })),
  );
}

function fileOf(parts: readonly Part[], moves: boolean): Uint8Array {
  const builder = new GltfBuilder();
  const { json } = builder;
  Object.assign(json, { nodes: [], meshes: [], materials: [], scenes: [{ nodes: [] }] });
  json.scenes[0].nodes = parts.map((part) => addPart(builder, part));
  if (moves) {
    const still = json.nodes.push({ name: 'still' }) - 1;
    json.scenes[0].nodes.push(still);
    const times = builder.accessor(Float32Array.of(0, 1), 'SCALAR');
    addTrack(builder, 'translation', times, builder.accessor(new Float32Array(6), 'VEC3'));
    json.animations[0].channels[0].target.node = still;
  }
  return builder.glb();
}

function addPart(builder: GltfBuilder, { geometry, material, matrix, instances, children = [] }: Part): number {
  const { json } = builder;
  const { position, normal } = geometry.attributes;
  const attributes = {
    POSITION: builder.accessor(new Float32Array(position.array), 'VEC3'),
    NORMAL: builder.accessor(new Float32Array(normal.array), 'VEC3'),
  };
  const indices = builder.accessor(Uint16Array.from(geometry.index!.array), 'SCALAR');
  const index = material && json.materials.push(material) - 1;
  const mesh = json.meshes.push({ primitives: [{ attributes, indices, material: index }] }) - 1;
  const node: Json = { mesh, matrix: matrix?.toArray() };
  const at = json.nodes.push(node) - 1;
  if (instances) {
    const list: Json = { TRANSLATION: [], ROTATION: [], SCALE: [] };
    for (const one of instances) {
      const [place, turn, size] = [new Vector3(), new Quaternion(), new Vector3()];
      one.decompose(place, turn, size);
      list.TRANSLATION.push(...place);
      list.ROTATION.push(...turn);
      list.SCALE.push(...size);
    }
    const accessors = Object.entries(list).map(([name, values]) => [
      name,
      builder.accessor(Float32Array.from(values as number[]), name === 'ROTATION' ? 'VEC4' : 'VEC3'),
    ]);
    node.extensions = { EXT_mesh_gpu_instancing: { attributes: Object.fromEntries(accessors) } };
    json.extensionsUsed = ['EXT_mesh_gpu_instancing'];
  }
  if (children.length > 0) node.children = children.map((child) => addPart(builder, child));
  return at;
}
