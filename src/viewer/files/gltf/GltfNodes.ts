import { checkReadTriangles } from '../mesh/PlainMesh.js';
import { fitWeights, type GltfGeometry, type PlainGltfMesh } from './GltfGeometry.js';
import type { AccessorValues, GltfWriter } from './GltfValues.js';
import type { GltfDocument, GltfNode } from './gltfDocument.js';

/** A written skeleton; undefined if it is damaged. */
export type PlainSkin = { joints: number[]; inverseBindMatrices?: number } | undefined;

type NumberedMesh = PlainGltfMesh & { index: number };

/** Writes the nodes of a document, with the meshes of visible ones. */
export class GltfNodes {
  readonly nodes: object[] = [];
  readonly meshes: object[] = [];
  /** The number of morph targets of each node's mesh, by node index. */
  readonly shapes: number[] = [];
  /** Totals of what is drawn. Instances count each. */
  readonly sums = { triangles: 0, vertices: 0, draws: 0 };
  /** Whether any mesh is skinned. */
  isSkinned = false;
  readonly leftOut = { skeletons: 0, instances: 0 };
  private readonly variants = new Map<string, Promise<NumberedMesh | undefined>>();

  constructor(
    private readonly document: GltfDocument,
    private readonly values: AccessorValues,
    private readonly geometry: GltfGeometry,
    private readonly skins: readonly PlainSkin[],
    private readonly writer: GltfWriter,
  ) {}

  /** Writes the next node. @throws ModelError if data of its mesh is missing, or there are too many triangles */
  async write(node: GltfNode, isVisible: boolean): Promise<void> {
    const { name, children, matrix, translation, rotation, scale } = node;
    const plain: Record<string, unknown> = { name, matrix, translation, rotation, scale };
    if (children?.length) plain.children = children;
    const index = this.nodes.push(plain) - 1;
    if (node.mesh === undefined || !isVisible) return;
    const places = instanceAccessors(node, this.values);
    const skin = node.skin === undefined || places.length > 0 ? undefined : this.skins[node.skin];
    const mesh = await this.meshOf(node.mesh, skin?.joints.length ?? 0);
    if (!mesh) return;
    const instances = this.instancesOf(places, mesh);
    if (instances?.count === 0) return;
    plain.mesh = mesh.index;
    this.shapes[index] = mesh.shapes;
    if (mesh.shapes > 0 && node.weights) plain.weights = fitWeights(node.weights, mesh.shapes);
    if (mesh.isSkinned) plain.skin = node.skin;
    else if (node.skin !== undefined) this.leftOut.skeletons++;
    this.isSkinned ||= mesh.isSkinned;
    if (instances) plain.extensions = { [INSTANCING]: { attributes: this.writeInstances(instances) } };
    const count = instances?.count ?? 1;
    this.sums.triangles += mesh.triangles * count;
    this.sums.vertices += mesh.vertices * count;
    this.sums.draws += mesh.json.primitives.length;
  }

  /** Writes a mesh once per number of joints, since skinned meshes have more attributes. */
  private meshOf(mesh: number, joints: number): Promise<NumberedMesh | undefined> {
    const key = `${mesh} ${joints}`;
    let variant = this.variants.get(key);
    if (!variant) {
      variant = this.geometry
        .writeMesh(this.document.meshes[mesh], joints)
        .then((plain) => plain && { ...plain, index: this.meshes.push(plain.json) - 1 });
      this.variants.set(key, variant);
    }
    return variant;
  }

  /** The instances of a mesh; undefined if it has none. Their triangles are counted before they are read. */
  private instancesOf(places: InstanceAccessors, { triangles }: PlainGltfMesh): Instances | undefined {
    const count = places.length > 0 ? instanceCount(places, this.values) : 1;
    checkReadTriangles(Math.max(1, this.sums.triangles + triangles * count));
    if (places.length === 0) return undefined;
    const instances = readInstances(places, count, this.values);
    this.leftOut.instances += instances.leftOut;
    return instances;
  }

  private writeInstances({ attributes }: Instances): Record<string, number> {
    return Object.fromEntries(attributes.map(([key, array]) => [key, this.writer.add(array, INSTANCE_SIZES[key])]));
  }
}

/** The extension for instanced meshes. */
export const INSTANCING = 'EXT_mesh_gpu_instancing';
/** The number of components of each instance attribute. */
const INSTANCE_SIZES: Readonly<Record<string, number>> = { TRANSLATION: 3, ROTATION: 4, SCALE: 3, _COLOR_0: 3 };

/** The accessors of a node's instance attributes; empty without instances. */
type InstanceAccessors = readonly [name: string, accessor: number][];

/** The instances of a node. */
interface Instances {
  count: number;
  attributes: [name: string, values: Float32Array][];
  /** The number of instances left out. */
  leftOut: number;
}

/** The accessors of a node's instance attributes. */
function instanceAccessors({ extensions }: GltfNode, values: AccessorValues): InstanceAccessors {
  return Object.entries(extensions?.[INSTANCING]?.attributes ?? {}).filter(
    ([name, accessor]) => INSTANCE_SIZES[name] === values.sizeOf(accessor),
  );
}

/** The number of instances by a node's accessors. */
const instanceCount = (accessors: InstanceAccessors, values: AccessorValues): number =>
  Math.min(...accessors.map(([, accessor]) => values.countOf(accessor)));

/** Reads the first instances, without those with NaN values. @param total how many are read */
function readInstances(accessors: InstanceAccessors, total: number, values: AccessorValues): Instances {
  const read = accessors.map(([name, accessor]) => ({
    name,
    size: INSTANCE_SIZES[name],
    array: values.floatsOf(accessor),
  }));
  const isBad = new Uint8Array(total);
  for (const { size, array } of read) {
    for (let i = 0; i < size * total; i++) if (!Number.isFinite(array[i])) isBad[Math.floor(i / size)] = 1;
  }
  const kept = [...isBad.keys()].filter((instance) => isBad[instance] === 0);
  const pick = (array: Float32Array, size: number): Float32Array => {
    if (kept.length === total && array.length === size * total) return array;
    const picked = new Float32Array(size * kept.length);
    for (const [to, from] of kept.entries()) picked.set(array.subarray(size * from, size * (from + 1)), size * to);
    return picked;
  };
  return {
    count: kept.length,
    attributes: read.map(({ name, size, array }) => [name, pick(array, size)]),
    leftOut: total - kept.length,
  };
}
