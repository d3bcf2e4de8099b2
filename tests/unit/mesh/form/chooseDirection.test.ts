import { existsSync, readFileSync } from 'node:fs';
import { BoxGeometry, CapsuleGeometry, CylinderGeometry, TorusKnotGeometry } from 'three';
import { TeapotGeometry } from 'three/addons/geometries/TeapotGeometry.js';
import { describe, expect, test } from 'vitest';
import { chooseDirection } from '../../../../src/mesh/form/bakeForm.js';
import type { TriangleMesh } from '../../../../src/mesh/TriangleMesh.js';
import { column, gears, landscape, shell, vase } from '../../../../src/playground/models/forms.js';
import { meshFrom, scaled } from '../features/surfaces.js';
import { finish, meshOf } from '../meshes.js';
import { cube, patch, prism, sphere, torus } from '../shapes.js';
import { surfaceOf } from './fronts.js';
import { readObj } from './readObj.js';

const choiceOf = (mesh: TriangleMesh) => finish(chooseDirection(surfaceOf(mesh)));

test.each<[string, () => TriangleMesh]>([
  ['a sphere', () => sphere(10)],
  ['a torus', () => torus(40, 20)],
  ['a capsule', () => meshFrom(new CapsuleGeometry(0.4, 1.4, 16, 48, 24))],
  ['a knot', () => meshFrom(new TorusKnotGeometry(0.7, 0.24, 160, 24, 2, 3))],
  ['a cylinder with lids', () => meshFrom(new CylinderGeometry(0.5, 0.5, 2, 48, 24))],
  ['a teapot', () => meshFrom(new TeapotGeometry(1, 8))],
  ['the shell of the playground', () => meshFrom(shell())],
  ['its vase', () => meshFrom(vase())],
  ['its column', () => meshFrom(column())],
  ['its landscape', () => meshFrom(landscape())],
])('%s has a form', (_, shape) => {
  expect(choiceOf(shape())).toMatchObject({ direction: 'form' });
});

test.each<[string, () => TriangleMesh]>([
  ['a cube', () => cube(8)],
  ['a box of twelve triangles', () => meshFrom(new BoxGeometry(3, 1, 2))],
  ['a hexagonal prism', () => prism(6)],
  ['a plane', () => patch(10, 10, (u, v) => [u, v, 0])],
  ['the gears of the playground', () => meshFrom(gears())],
  ['nothing', () => meshOf([], [])],
])('%s has flat faces', (_, shape) => {
  expect(choiceOf(shape())).toMatchObject({ direction: 'light' });
});

test('the measure is the share of the area that is flat, at any size', () => {
  expect(choiceOf(cube(8)).flatShare).toBe(1);
  expect(choiceOf(sphere(10)).flatShare).toBe(0);
  for (const size of [1e-6, 1, 1e6]) {
    const { flatShare } = choiceOf(scaled(meshFrom(new CylinderGeometry(0.5, 0.5, 2, 48, 24)), size));
    // Two lids of πr² and a side of 2πrh.
    expect(flatShare).toBeCloseTo(0.2, 2);
  }
});

describe('scans have a form', () => {
  const folder = new URL('../../../../../shared/models/', import.meta.url);
  test.each(['spot.obj', 'hand_lowres.obj', 'nefertiti_lowres.obj'])('%s', (name) => {
    const file = new URL(name, folder);
    if (!existsSync(file)) return console.log(`skipped: ../shared/models/${name} is not there`);
    expect(choiceOf(readObj(readFileSync(file, 'utf8')))).toMatchObject({ direction: 'form' });
  });
});
