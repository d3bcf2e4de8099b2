import {
  BufferAttribute,
  type BufferGeometry,
  Float16BufferAttribute,
  InterleavedBuffer,
  InterleavedBufferAttribute,
} from 'three';
import {
  CORNER_STRIDE,
  cornerLayout,
  formLayout,
  GRADIENTS_STRIDE,
  hatchNormal,
} from '../../mesh/bake/attributeLayouts.js';
import type { BakeCornersResult } from '../../mesh/bake/bakeCorners.js';
import type { BakeIndexedResult } from '../../mesh/bake/bakeIndexed.js';
import type { BakePullResult } from '../../mesh/bake/bakePull.js';
import type { PackedForm } from '../../mesh/bake/packAttributes.js';
import { appendVertices, type VertexWords, type Words } from '../../mesh/bake/vertexWords.js';
import { PulledVertices } from './PulledVertices.js';
import { finishGeometry, type NotBaked, setNormals } from './preparedGeometry.js';
import { setPulledVertices } from './pulledVerticesOf.js';
import type { KeptAttribute, VertexAttribute } from './vertexAttributes.js';

/** A kept attribute with a copy of its values before the bake. */
interface CopiedAttribute extends KeptAttribute, VertexWords {}

/** Fills the geometry with the index, all attributes (including those of added vertices), the bounds and the statistics. */
export function applyIndexed(
  geometry: BufferGeometry,
  attributes: readonly CopiedAttribute[],
  result: BakeIndexedResult & NotBaked,
): void {
  geometry.setIndex(new BufferAttribute(result.indices, 1));
  for (const attribute of attributes) {
    setKeptAttribute(geometry, attribute, appendVertices(attribute, result.addedVertices));
  }
  geometry.setAttribute(hatchNormal.name, new BufferAttribute(result.hatchNormals, hatchNormal.itemSize, true));
  setFields(geometry, result);
  finishGeometry(geometry, 'indexed', result);
}

/** Fills the geometry with the baked corners, the kept attributes, the bounds and the statistics. */
export function applyCorners(
  geometry: BufferGeometry,
  kept: readonly KeptAttribute[],
  result: BakeCornersResult & NotBaked,
): void {
  geometry.setAttribute('position', new BufferAttribute(result.positions, 3));
  const buffer = new InterleavedBuffer(result.corners, CORNER_STRIDE);
  let offset = 0;
  for (const { name, itemSize } of cornerLayout) {
    geometry.setAttribute(name, new InterleavedBufferAttribute(buffer, itemSize, offset));
    offset += itemSize;
  }
  geometry.setAttribute(hatchNormal.name, new BufferAttribute(result.hatchNormals, hatchNormal.itemSize, true));
  for (const [i, attribute] of kept.entries()) setKeptAttribute(geometry, attribute, result.attributes[i]);
  setFields(geometry, result);
  finishGeometry(geometry, 'corner', result);
}

/** Fills the geometry with the baked corners, the textures, the kept attributes, the bounds and the statistics. */
export function applyPull(
  geometry: BufferGeometry,
  kept: readonly KeptAttribute[],
  result: BakePullResult & NotBaked,
): void {
  geometry.setAttribute('position', new BufferAttribute(result.positions, 3));
  geometry.setAttribute(hatchNormal.name, new BufferAttribute(result.hatchNormals, hatchNormal.itemSize, true));
  for (const [i, attribute] of kept.entries()) setKeptAttribute(geometry, attribute, result.attributes[i]);
  setFields(geometry, result);
  const { triangleVertices, vertexPositions } = result;
  finishGeometry(geometry, 'pull', result, triangleVertices.byteLength + vertexPositions.byteLength);
  setPulledVertices(geometry, new PulledVertices(result));
}

/** Sets the attributes of the form field and the normals, if they were baked. */
function setFields(geometry: BufferGeometry, { form, normals }: Pick<BakeCornersResult, 'form' | 'normals'>): void {
  if (form) setForm(geometry, form);
  if (normals) setNormals(geometry, normals);
}

function setForm(geometry: BufferGeometry, form: PackedForm): void {
  const { value, slope, crossing } = formLayout;
  geometry.setAttribute(value.name, new BufferAttribute(form.values, value.itemSize));
  const gradients = new InterleavedBuffer(form.gradients, GRADIENTS_STRIDE);
  const gradient = ({ itemSize }: { itemSize: number }, offset: number) =>
    new InterleavedBufferAttribute(gradients, itemSize, offset, true);
  geometry.setAttribute(slope.name, gradient(slope, 0));
  geometry.setAttribute(crossing.name, gradient(crossing, slope.itemSize));
}

/** Adds an attribute in its former place: among the attributes, or at the end of the morph targets of its name. */
function setKeptAttribute(
  geometry: BufferGeometry,
  { name, isMorphTarget, attribute }: KeptAttribute,
  words: Words,
): void {
  const copy = attributeFromWords(attribute, words);
  if (!isMorphTarget) geometry.setAttribute(name, copy);
  else {
    const morphs = geometry.morphAttributes as Record<string, BufferAttribute[]>;
    morphs[name] = [...(morphs[name] ?? []), copy];
  }
}

/** Creates an attribute from words, with the type, normalisation and GPU type of `source`. */
export function attributeFromWords(source: VertexAttribute, words: Words): BufferAttribute {
  const { itemSize, normalized } = source;
  const ArrayType = source.array.constructor as new (buffer: ArrayBuffer) => Float32Array;
  const array = new ArrayType(words.buffer);
  // three.js recognises half floats by the attribute's class, whose constructor uses a buffer without copying it.
  const attribute =
    'isFloat16BufferAttribute' in source
      ? new Float16BufferAttribute(words.buffer as unknown as ArrayLike<number>, itemSize, normalized)
      : new BufferAttribute(array, itemSize, normalized);
  attribute.name = source.name;
  if ('gpuType' in source) attribute.gpuType = source.gpuType;
  return attribute;
}
