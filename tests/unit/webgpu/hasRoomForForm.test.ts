import { BufferAttribute, type BufferGeometry, CylinderGeometry, Texture } from 'three';
import { MeshStandardNodeMaterial, type NodeBuilder } from 'three/webgpu';
import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import { prepareHatchingGeometry } from '../../../src/material/geometry/prepareHatchingGeometry.js';

const warn = vi.spyOn(console, 'warn');

/** Imported anew for each test, since it warns once. */
let hasRoomForForm: typeof import('../../../src/webgpu/deviceLimits.js').hasRoomForForm;

beforeEach(async () => {
  vi.resetModules();
  warn.mockImplementation(() => {});
  ({ hasRoomForForm } = await import('../../../src/webgpu/deviceLimits.js'));
});
afterEach(() => warn.mockReset());

const WEBGPU = { device: { limits: { maxVertexBuffers: 8 } } };

/** A tube with bones and a map that follows its form, with the builder of a device. */
async function skin(backend: object = WEBGPU) {
  const geometry: BufferGeometry = await prepareHatchingGeometry(new CylinderGeometry(1, 1, 2, 12, 4), { form: true });
  const { count } = geometry.attributes.position;
  for (const name of ['skinIndex', 'skinWeight', 'color'])
    geometry.setAttribute(name, new BufferAttribute(new Float32Array(4 * count), 4));
  const material = new MeshStandardNodeMaterial();
  material.map = new Texture();
  const builder = { geometry, material, object: { isSkinnedMesh: true }, renderer: { backend } };
  return { builder: builder as unknown as NodeBuilder, geometry, material };
}

test('there is room beside bones and a map', async () => {
  const { builder } = await skin();
  expect(hasRoomForForm(builder, false)).toBe(true);
  expect(warn).not.toHaveBeenCalled();
});

test('there is none beside vertex colors too, which is said once', async () => {
  const { builder, material } = await skin();
  material.vertexColors = true;
  expect([hasRoomForForm(builder, false), hasRoomForForm(builder, false)]).toEqual([false, false]);
  expect(warn.mock.calls).toEqual([[expect.stringMatching(/takes 9 vertex buffers, and the device has 8: .*without/)]]);
});

test('strokes follow the directions of the form alone, which takes a buffer less', async () => {
  const { builder, material } = await skin();
  material.vertexColors = true;
  expect(hasRoomForForm(builder, true)).toBe(true);
});

test('maps by another set of texture coordinates take another buffer', async () => {
  const { builder, geometry, material } = await skin();
  geometry.setAttribute('uv1', geometry.attributes.uv.clone());
  material.alphaMap = new Texture();
  expect(hasRoomForForm(builder, false)).toBe(true);
  material.alphaMap.channel = 1;
  expect(hasRoomForForm(builder, false)).toBe(false);
});

test('devices with more buffers, and WebGL, have room', async () => {
  for (const backend of [{ device: { limits: { maxVertexBuffers: 16 } } }, {}]) {
    const { builder, material } = await skin(backend);
    material.vertexColors = true;
    expect(hasRoomForForm(builder, false)).toBe(true);
  }
});
