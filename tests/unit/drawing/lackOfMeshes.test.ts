import { BoxGeometry, BufferAttribute, Mesh, SkinnedMesh } from 'three';
import { expect, test } from 'vitest';
import { lackOfMeshes } from '../../../src/drawing/lackOfMeshes.js';

const withColors = (normalized: boolean): Mesh => {
  const geometry = new BoxGeometry();
  geometry.setAttribute('color', new BufferAttribute(new Uint8Array(72), 3, normalized));
  return new Mesh(geometry);
};

test('plain meshes are drawn by nodes, with normalized attributes too', () => {
  expect(lackOfMeshes([new Mesh(new BoxGeometry()), withColors(true)])).toBeUndefined();
});

test('bones and attributes that are rewritten are left to WebGL', () => {
  expect(lackOfMeshes([new Mesh(new BoxGeometry()), new SkinnedMesh(new BoxGeometry())])).toBe('models with bones');
  expect(lackOfMeshes([withColors(false)])).toBe('models with packed vertices');
});
