import {
  BoxGeometry,
  BufferAttribute,
  type BufferGeometry,
  Group,
  InstancedBufferAttribute,
  InterleavedBuffer,
  InterleavedBufferAttribute,
  Mesh,
} from 'three';
import { expect, test } from 'vitest';
import { widenIntegers } from '../../../../src/viewer/drawing/modelOfScene.js';

const VERTICES = 24;

function widened(attribute: BufferAttribute | InterleavedBufferAttribute): BufferGeometry['attributes'][string] {
  const geometry = new BoxGeometry();
  geometry.setAttribute('tried', attribute);
  widenIntegers(new Group().add(new Mesh(geometry)));
  return geometry.attributes.tried;
}

test.each([Int8Array, Uint8Array, Int16Array, Uint16Array])('%o becomes floats of the same values', (Type) => {
  const attribute = new BufferAttribute(
    new Type(2 * VERTICES).map((_, i) => 100 - i),
    2,
  );
  attribute.name = 'joints';
  const { array, name, itemSize, normalized, count } = widened(attribute);
  expect(array).toBeInstanceOf(Float32Array);
  expect([...array]).toEqual([...attribute.array]);
  expect({ name, itemSize, normalized, count }).toEqual({
    name: 'joints',
    itemSize: 2,
    normalized: false,
    count: VERTICES,
  });
});

test('interleaved integers become floats without what lies between them', () => {
  const buffer = new InterleavedBuffer(
    new Uint16Array(4 * VERTICES).map((_, i) => i),
    4,
  );
  const attribute = widened(new InterleavedBufferAttribute(buffer, 3, 1));
  expect('data' in attribute).toBe(false);
  expect([...attribute.array.slice(0, 6)]).toEqual([1, 2, 3, 5, 6, 7]);
});

test('attributes that both renderers draw stay unchanged', () => {
  for (const attribute of [
    new BufferAttribute(new Int16Array(3 * VERTICES), 3, true),
    new BufferAttribute(new Float32Array(3 * VERTICES), 3),
    new BufferAttribute(new Uint32Array(3 * VERTICES), 3),
    new InstancedBufferAttribute(new Uint8Array(4), 4),
  ])
    expect(widened(attribute)).toBe(attribute);
});

test('shared attributes stay shared', () => {
  const shared = new BufferAttribute(new Uint8Array(4 * VERTICES), 4);
  const parts = [new BoxGeometry(), new BoxGeometry()];
  for (const part of parts) part.setAttribute('skinIndex', shared);
  widenIntegers(new Group().add(...parts.map((part) => new Mesh(part))));
  expect(parts[0].attributes.skinIndex).not.toBe(shared);
  expect(parts[1].attributes.skinIndex).toBe(parts[0].attributes.skinIndex);
});
