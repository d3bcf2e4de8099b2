import type { DracoPart } from './decodeDraco.js';
import type { AccessorValues, GltfWriter } from './GltfValues.js';
import type { GltfMesh, GltfPrimitive } from './gltfDocument.js';

/** The maximum number of morph targets: WebGL 2 guarantees array textures of 256 layers, and three.js uses one layer per target. */
const MAX_SHAPES = 256;
const MAX_SHAPE_BYTES = 256 * 1024 * 1024;
/** three.js stores a morph target as four floats per vertex for the position, and four for the normal. */
const SHAPE_VERTEX_BYTES = 32;
const TRIANGLE_LIST = 4;

/** The attributes that are drawn, with the allowed numbers of components. */
const SIZES: Record<string, readonly number[]> = {
  POSITION: [3],
  NORMAL: [3],
  TEXCOORD_0: [2],
  TEXCOORD_1: [2],
  TEXCOORD_2: [2],
  TEXCOORD_3: [2],
  COLOR_0: [3, 4],
  JOINTS_0: [4],
  WEIGHTS_0: [4],
};
const OTHERS = Object.keys(SIZES).filter((name) => name !== 'POSITION' && name !== 'JOINTS_0');

interface Attribute {
  values: Float32Array | Uint16Array;
  size: number;
}

/** A primitive after reading. */
interface Part {
  attributes: Map<string, Attribute>;
  indices: Uint32Array | undefined;
  vertexCount: number;
  targets: Record<string, number>[];
  material: number | undefined;
}

/** The source of a primitive's values: accessors, or Draco. */
interface PartSource {
  read(attribute: string): { values: Float32Array; size: number } | undefined;
  indices(): Uint32Array | undefined;
}

/** Decodes a Draco-compressed primitive. Its attributes have their glTF names, with normalized values. @throws ModelError */
export type DracoSource = (
  packed: NonNullable<NonNullable<GltfPrimitive['extensions']>['KHR_draco_mesh_compression']>,
  primitive: GltfPrimitive,
) => Promise<DracoPart>;

/** Counts of what was left out of the geometry. */
interface LeftOut {
  /** Triangles with a corner that is missing or NaN. */
  triangles: number;
  /** Attributes and morph targets whose sizes do not fit the vertices. */
  attributes: number;
  /** Morph targets beyond the maximum number. */
  shapes: number;
  /** Primitives of points or lines. */
  lines: number;
}

/** A mesh in the written document. */
export interface PlainGltfMesh {
  json: { name?: string | undefined; primitives: object[]; weights?: number[]; extras?: { targetNames: string[] } };
  /** Counts over all its primitives. */
  vertices: number;
  triangles: number;
  shapes: number;
  isSkinned: boolean;
}

/** Unpacks and checks the meshes of a document. */
export class GltfGeometry {
  readonly leftOut: LeftOut = { triangles: 0, attributes: 0, shapes: 0, lines: 0 };
  private readonly repaired = new Map<Float32Array, Repaired>();
  private readonly zeros = new Map<number, Float32Array>();

  constructor(
    private readonly values: AccessorValues,
    private readonly writer: GltfWriter,
    private readonly draco: DracoSource,
  ) {}

  /**
   * Writes a mesh.
   *
   * @param joints number of joints of its skeleton; 0 without one
   * @returns undefined if no triangles are left
   * @throws ModelError if data is missing
   */
  async writeMesh(mesh: GltfMesh, joints: number): Promise<PlainGltfMesh | undefined> {
    const parts: Part[] = [];
    for (const primitive of mesh.primitives) {
      if (!drawsTriangles(primitive.mode ?? TRIANGLE_LIST)) this.leftOut.lines++;
      else {
        const part = await this.readPart(primitive, joints);
        if (part) parts.push(part);
      }
    }
    if (parts.length === 0) return undefined;
    const shapes = this.limitShapes(parts);
    const isSkinned = joints > 0 && parts.every(({ attributes }) => attributes.has('JOINTS_0'));
    const { weights, extras } = mesh;
    const names = extras?.targetNames;
    return {
      json: {
        name: mesh.name,
        primitives: parts.map((part) => this.writePart(part, shapes, isSkinned)),
        ...(weights && shapes > 0 && { weights: fitWeights(weights, shapes) }),
        ...(names && shapes > 0 && names.length >= shapes && { extras: { targetNames: names.slice(0, shapes) } }),
      },
      vertices: sum(parts, ({ vertexCount }) => vertexCount),
      triangles: sum(parts, ({ indices, vertexCount }) => (indices?.length ?? vertexCount) / 3),
      shapes,
      isSkinned,
    };
  }

  private async readPart(primitive: GltfPrimitive, joints: number): Promise<Part | undefined> {
    const { mode = TRIANGLE_LIST, targets = [], material } = primitive;
    const source = await this.sourceOf(primitive);
    const found = source.read('POSITION');
    if (found?.size !== 3 || found.values.length === 0) {
      if (found) this.leftOut.attributes++;
      return undefined;
    }
    const vertexCount = found.values.length / 3;
    const { positions, isUsable } = this.repair(found.values);
    const { indices, broken } = toTriangles(mode, source.indices(), vertexCount, isUsable);
    this.leftOut.triangles += broken;
    if (indices?.length === 0) return undefined;
    const attributes = new Map<string, Attribute>([['POSITION', { values: positions, size: 3 }]]);
    for (const name of OTHERS) {
      if (!joints && /JOINTS|WEIGHTS/.test(name)) continue;
      const attribute = source.read(name);
      if (!attribute) continue;
      const fits = SIZES[name].includes(attribute.size) && attribute.values.length === attribute.size * vertexCount;
      if (fits) attributes.set(name, attribute);
      else this.leftOut.attributes++;
    }
    const influences =
      joints > 0 && this.readJoints(primitive, source, attributes.get('WEIGHTS_0'), vertexCount, joints);
    if (influences) for (const [name, attribute] of influences) attributes.set(name, attribute);
    else attributes.delete('WEIGHTS_0');
    return { attributes, indices, vertexCount, targets, material };
  }

  /** Sets the weights of joints that the skeleton lacks to 0, since reading such joints would fail. */
  private readJoints(
    { attributes }: GltfPrimitive,
    source: PartSource,
    weights: Attribute | undefined,
    vertexCount: number,
    joints: number,
  ): [string, Attribute][] | undefined {
    if (attributes.JOINTS_0 === undefined || !weights || weights.size !== 4) return undefined;
    const found = source.read('JOINTS_0');
    if (found?.size !== 4 || found.values.length !== 4 * vertexCount) return undefined;
    const places = Uint16Array.from(found.values);
    const shares = weights.values.slice() as Float32Array;
    for (let i = 0; i < places.length; i++) {
      if (found.values[i] < joints && Number.isFinite(shares[i])) continue;
      if (shares[i] !== 0) this.leftOut.attributes++;
      places[i] = shares[i] = 0;
    }
    return [
      ['JOINTS_0', { values: places, size: 4 }],
      ['WEIGHTS_0', { values: shares, size: 4 }],
    ];
  }

  /** Moves vertices with NaN coordinates to a valid vertex, because even unused vertices count for the bounds. */
  private repair(values: Float32Array): Repaired {
    let repaired = this.repaired.get(values);
    if (!repaired) {
      repaired = repairPositions(values);
      this.repaired.set(values, repaired);
    }
    return repaired;
  }

  /** The number of morph targets that every primitive of a mesh gets. */
  private limitShapes(parts: readonly Part[]): number {
    const wanted = Math.max(...parts.map(({ targets }) => targets.length));
    const vertices = Math.max(...parts.map(({ vertexCount }) => vertexCount));
    const shapes = Math.min(wanted, MAX_SHAPES, Math.floor(MAX_SHAPE_BYTES / (SHAPE_VERTEX_BYTES * vertices)));
    this.leftOut.shapes += wanted - shapes;
    return shapes;
  }

  private writePart(
    { attributes, indices, vertexCount, targets, material }: Part,
    shapes: number,
    isSkinned: boolean,
  ): object {
    const written: Record<string, number> = {};
    for (const [name, { values, size }] of attributes) {
      if (isSkinned || !/JOINTS|WEIGHTS/.test(name)) written[name] = this.writer.add(values, size);
    }
    const shown = targets.slice(0, shapes);
    const names = ['POSITION', 'NORMAL'].filter(
      (name) => attributes.has(name) && shown.some((target) => target[name] !== undefined),
    );
    // Every morph target needs the same attributes: three.js replaces a missing one by that of the base mesh.
    const shape = (i: number): object =>
      Object.fromEntries(
        (shapes > 0 && names.length === 0 ? ['POSITION'] : names).map((name) => [
          name,
          this.writer.add(this.readShape(shown[i]?.[name], vertexCount), 3),
        ]),
      );
    return {
      attributes: written,
      ...(indices && { indices: this.writer.add(indices, 1) }),
      ...(material !== undefined && { material }),
      ...(shapes > 0 && { targets: Array.from({ length: shapes }, (_, i) => shape(i)) }),
    };
  }

  private readShape(accessor: number | undefined, vertexCount: number): Float32Array {
    if (accessor !== undefined) {
      const fits = this.values.sizeOf(accessor) === 3 && this.values.countOf(accessor) === vertexCount;
      const values = fits ? this.values.floatsOf(accessor) : undefined;
      if (values?.every(Number.isFinite)) return values;
      this.leftOut.attributes++;
    }
    let zeros = this.zeros.get(vertexCount);
    if (!zeros) {
      zeros = new Float32Array(3 * vertexCount);
      this.zeros.set(vertexCount, zeros);
    }
    return zeros;
  }

  private async sourceOf(primitive: GltfPrimitive): Promise<PartSource> {
    const packed = primitive.extensions?.KHR_draco_mesh_compression;
    const unpacked = packed && (await this.draco(packed, primitive));
    return {
      read: (name) => {
        const { values } = this;
        const accessor = primitive.attributes[name];
        if (accessor === undefined) return undefined;
        const fromDraco = unpacked?.attributes.get(name);
        return fromDraco ?? { values: values.floatsOf(accessor), size: values.sizeOf(accessor) };
      },
      indices: () => {
        if (unpacked) return unpacked.indices;
        return primitive.indices === undefined ? undefined : this.values.integersOf(primitive.indices);
      },
    };
  }
}

interface Repaired {
  positions: Float32Array;
  /** 1 for every vertex with finite coordinates; undefined if all are finite. */
  isUsable: Uint8Array | undefined;
}

function repairPositions(values: Float32Array): Repaired {
  if (values.every(Number.isFinite)) return { positions: values, isUsable: undefined };
  const positions = values.slice();
  const isUsable = new Uint8Array(values.length / 3);
  let good = -1;
  for (let vertex = 0; vertex < isUsable.length; vertex++) {
    if (!Number.isFinite(values[3 * vertex] + values[3 * vertex + 1] + values[3 * vertex + 2])) continue;
    isUsable[vertex] = 1;
    if (good === -1) good = vertex;
  }
  if (good !== -1) {
    const place = positions.slice(3 * good, 3 * good + 3);
    for (let vertex = 0; vertex < isUsable.length; vertex++) if (!isUsable[vertex]) positions.set(place, 3 * vertex);
  }
  return { positions, isUsable };
}

/** The first `count` weights, padded with zeros. */
export const fitWeights = (weights: readonly number[], shapes: number): number[] =>
  Array.from({ length: shapes }, (_, i) => weights[i] ?? 0);

const sum = <Item>(items: readonly Item[], value: (item: Item) => number): number =>
  items.reduce((total, item) => total + value(item), 0);

const TRIANGLES = 4;
const STRIP = 5;
const FAN = 6;

/** Whether a primitive mode draws triangles. */
const drawsTriangles = (mode: number): boolean => mode === TRIANGLES || mode === STRIP || mode === FAN;

/**
 * Converts a triangle list, strip or fan to a list.
 *
 * @param indices of the file, or undefined for vertices in order
 * @param isUsable whether a vertex may be used; undefined if all may
 * @returns the indices, or undefined if every three vertices in order make a triangle; and the number of triangles left out because a
 *   vertex is missing or unusable
 */
function toTriangles(
  mode: number,
  indices: Uint32Array | undefined,
  vertexCount: number,
  isUsable: Uint8Array | undefined,
): { indices: Uint32Array | undefined; broken: number } {
  if (mode === TRIANGLES && !indices && !isUsable && vertexCount % 3 === 0) return { indices: undefined, broken: 0 };
  const corners = indices?.length ?? vertexCount;
  const triangles = Math.max(0, mode === TRIANGLES ? Math.floor(corners / 3) : corners - 2);
  const list = new Uint32Array(3 * triangles);
  const vertexAt = (corner: number): number => (indices ? indices[corner] : corner);
  const isGood = (vertex: number): boolean => vertex < vertexCount && (!isUsable || isUsable[vertex] === 1);
  let length = 0;
  let broken = 0;
  for (let t = 0; t < triangles; t++) {
    const [i, j, k] = cornersOf(mode, t);
    const a = vertexAt(i);
    const b = vertexAt(j);
    const c = vertexAt(k);
    // Strips are joined by degenerate triangles.
    if (mode !== TRIANGLES && (a === b || b === c || c === a)) continue;
    if (!(isGood(a) && isGood(b) && isGood(c))) {
      broken++;
      continue;
    }
    list[length++] = a;
    list[length++] = b;
    list[length++] = c;
  }
  return { indices: length === list.length ? list : list.slice(0, length), broken };
}

function cornersOf(mode: number, t: number): [number, number, number] {
  if (mode === TRIANGLES) return [3 * t, 3 * t + 1, 3 * t + 2];
  if (mode === FAN) return [t + 1, t + 2, 0];
  return [t, t + 1 + (t % 2), t + 2 - (t % 2)];
}
