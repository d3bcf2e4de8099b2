import type { BufferAttribute, BufferGeometry, InterleavedBufferAttribute } from 'three';
import { hatchNormal } from '../../mesh/bake/attributeLayouts.js';
import { occlusionOf } from '../../mesh/occlusion/occlusionSides.js';

/** Points spread evenly over the surface of a geometry, in object space and at rest. Any first few of them are spread evenly too. */
export interface SurfaceSamples {
  readonly count: number;
  readonly area: number;
  /** Whether all of the surface faces one direction. */
  readonly isFlat: boolean;
  readonly positions: Float32Array;
  /** The unit normals of the triangles. */
  readonly normals: Float32Array;
  /** The areas of the triangles. */
  readonly triangleAreas: Float32Array;
  /** The baked ambient occlusion of the front, then of the back, of each sample; 0 without a bake. */
  readonly occlusion: Float32Array;
  /** The vertex colours, three numbers per sample, and the first texture coordinates, two, if the geometry has them. */
  readonly colors: Float32Array | undefined;
  readonly places: Float32Array | undefined;
  /** For each sample the index of its material among those of the mesh, if the geometry has groups; `NO_GROUP` between groups. */
  readonly groups: Uint16Array | undefined;
}

/** Stands for the material of triangles of no group, which meshes of several materials do not draw. */
export const NO_GROUP = 0xffff;

/** The cosine of the greatest angle between two normals of a flat surface. */
const FLAT = Math.cos(Math.PI / 180);

interface Kept {
  readonly facts: readonly number[];
  readonly samples: SurfaceSamples;
}

const known = new WeakMap<BufferGeometry, Kept>();

type Attribute = BufferAttribute | InterleavedBufferAttribute;

/** The version of an attribute, which counts its changes; −1 without an attribute. */
export const versionOf = (attribute: Attribute | null | undefined): number =>
  attribute ? ('version' in attribute ? attribute.version : attribute.data.version) : -1;

/**
 * The samples of a geometry. They are taken once, and again when it has changed; the same geometry always has the same samples.
 *
 * @param wanted the number of samples; powers of two are spread most evenly
 * @param mostTriangles the greatest number of triangles that are read; in larger geometries each stands for its neighbours
 */
export function surfaceSamples(geometry: BufferGeometry, wanted: number, mostTriangles: number): SurfaceSamples {
  const { attributes, drawRange, index, groups } = geometry;
  const facts = [
    ...[wanted, mostTriangles, drawRange.start, drawRange.count, groups.length],
    ...[attributes.position, index, attributes[hatchNormal.name], attributes.color, attributes.uv].map(versionOf),
  ];
  const before = known.get(geometry);
  if (before?.facts.every((fact, i) => fact === facts[i])) return before.samples;
  const samples = takeSamples(geometry, wanted, mostTriangles);
  known.set(geometry, { facts, samples });
  return samples;
}

/** Reads corners of triangles. */
class Corners {
  readonly triangles: number;
  private readonly start: number;
  private readonly position: Attribute;
  private readonly baked: Attribute | undefined;
  private readonly xyz = new Float64Array(9);

  constructor(private readonly geometry: BufferGeometry) {
    const { drawRange, index, attributes } = geometry;
    this.position = attributes.position;
    const baked = attributes[hatchNormal.name];
    this.baked = baked?.itemSize === hatchNormal.itemSize ? baked : undefined;
    const available = index ? index.count : this.position.count;
    this.start = Math.max(0, drawRange.start);
    const end = Math.min(available, drawRange.start + drawRange.count);
    this.triangles = Math.max(0, Math.floor((end - this.start) / 3));
  }

  /** The nine coordinates of a triangle, which the next call overwrites. */
  read(triangle: number): Float64Array {
    const { xyz, position } = this;
    for (let corner = 0; corner < 3; corner++) {
      const vertex = this.vertex(triangle, corner);
      xyz[3 * corner] = position.getX(vertex);
      xyz[3 * corner + 1] = position.getY(vertex);
      xyz[3 * corner + 2] = position.getZ(vertex);
    }
    return xyz;
  }

  /** The component of `hatchNormal` that holds occlusion. */
  occlusion(vertex: number): number {
    return this.baked?.getW(vertex) ?? 0;
  }

  /** The index of the material of a triangle. */
  group(triangle: number): number {
    const corner = this.start + 3 * triangle;
    const group = this.geometry.groups.find(({ start, count }) => corner >= start && corner < start + count);
    return group ? (group.materialIndex ?? 0) : NO_GROUP;
  }

  vertex(triangle: number, corner: number): number {
    const entry = this.start + 3 * triangle + corner;
    return this.geometry.index ? this.geometry.index.getX(entry) : entry;
  }
}

const normal = new Float64Array(3);

/** Writes the normal of a triangle, as long as twice its area. @returns that length; 0 if a coordinate is not finite */
function writeNormal(xyz: Float64Array): number {
  const [ax, ay, az] = xyz;
  const [ux, uy, uz] = [xyz[3] - ax, xyz[4] - ay, xyz[5] - az];
  const [vx, vy, vz] = [xyz[6] - ax, xyz[7] - ay, xyz[8] - az];
  normal[0] = uy * vz - uz * vy;
  normal[1] = uz * vx - ux * vz;
  normal[2] = ux * vy - uy * vx;
  const length = Math.sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
  return length < Infinity ? length : 0;
}

function takeSamples(geometry: BufferGeometry, wanted: number, mostTriangles: number): SurfaceSamples {
  const corners = new Corners(geometry);
  const step = Math.max(1, Math.ceil(corners.triangles / mostTriangles));
  const sums = new Float64Array(Math.ceil(corners.triangles / step));
  let sum = 0;
  for (let i = 0; i < sums.length; i++) {
    sum += writeNormal(corners.read(i * step));
    sums[i] = sum;
  }
  const count = sum > 0 ? wanted : 0;
  const positions = new Float32Array(3 * count);
  const normals = new Float32Array(3 * count);
  const triangleAreas = new Float32Array(count);
  const occlusion = new Float32Array(2 * count);
  const { color, uv } = geometry.attributes;
  const colors = color ? new Float32Array(3 * count) : undefined;
  const places = uv ? new Float32Array(2 * count) : undefined;
  const groups = geometry.groups.length > 0 ? new Uint16Array(count) : undefined;
  let isFlat = true;
  for (let i = 0; i < count; i++) {
    // Halton points: one coordinate chooses the triangle, two the place in it.
    const triangle = step * firstAbove(sums, (radicalInverse(i, 2) + 0.5 / count) * sum);
    const root = Math.sqrt(radicalInverse(i + 1, 3));
    const across = radicalInverse(i + 1, 5);
    const shares = [1 - root, root * (1 - across), root * across];
    if (groups) groups[i] = corners.group(triangle);
    const xyz = corners.read(triangle);
    const length = writeNormal(xyz);
    triangleAreas[i] = length / 2;
    for (let axis = 0; axis < 3; axis++) {
      positions[3 * i + axis] = shares[0] * xyz[axis] + shares[1] * xyz[3 + axis] + shares[2] * xyz[6 + axis];
      normals[3 * i + axis] = normal[axis] / length;
    }
    for (let corner = 0; corner < 3; corner++) {
      const share = shares[corner];
      const vertex = corners.vertex(triangle, corner);
      const baked = corners.occlusion(vertex);
      occlusion[2 * i] += share * occlusionOf(baked, false);
      occlusion[2 * i + 1] += share * occlusionOf(baked, true);
      if (colors) {
        colors[3 * i] += share * color.getX(vertex);
        colors[3 * i + 1] += share * color.getY(vertex);
        colors[3 * i + 2] += share * color.getZ(vertex);
      }
      if (places) {
        places[2 * i] += share * uv.getX(vertex);
        places[2 * i + 1] += share * uv.getY(vertex);
      }
    }
    isFlat &&= normals[0] * normals[3 * i] + normals[1] * normals[3 * i + 1] + normals[2] * normals[3 * i + 2] > FLAT;
  }
  return {
    count,
    area: (step * sum) / 2,

    isFlat,
    positions,
    normals,
    triangleAreas,
    occlusion,
    colors,
    places,
    groups,
  };
}

/** The index of the first rising sum above a value. */
function firstAbove(sums: Float64Array, value: number): number {
  let [low, high] = [0, sums.length - 1];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (sums[middle] > value) high = middle;
    else low = middle + 1;
  }
  return low;
}

/** The radical inverse of a number (van der Corput): its digits mirrored at the point, in [0, 1). */
function radicalInverse(value: number, base: number): number {
  let [rest, digit, sum] = [value, 1 / base, 0];
  while (rest > 0) {
    sum += (rest % base) * digit;
    rest = Math.floor(rest / base);
    digit /= base;
  }
  return sum;
}
