import {
  BoxGeometry,
  type BufferGeometry,
  Float32BufferAttribute,
  Group,
  Mesh,
  MeshStandardMaterial,
  TorusGeometry,
} from 'three';
import { describe, expect, test } from 'vitest';
import type { HatchingMaterial } from '../../../../src/material/HatchingMaterial.js';
import { bakeFurther } from '../../../../src/viewer/drawing/bakeFurther.js';
import { meshesOf } from '../../../../src/viewer/drawing/meshes.js';
import { modelOfMesh } from '../../../../src/viewer/drawing/modelOfMesh.js';
import { modelOfScene } from '../../../../src/viewer/drawing/modelOfScene.js';
import { lookOf } from '../../../../src/viewer/settings/lookOf.js';
import { defaultSettings } from '../../../../src/viewer/settings/settings.js';

const OPTIONS = { signal: new AbortController().signal, onProgress: () => {} };
const FORM = { crossAngle: Math.PI / 3, auto: false };

/** A torus and a box. */
async function someModel() {
  const material = new MeshStandardMaterial();
  const meshes = [new TorusGeometry(1, 0.4, 24, 48), new BoxGeometry()].map((shape) => new Mesh(shape, material));
  const scene = { root: new Group().add(...meshes), animations: [] };
  return (await modelOfScene(scene, { ...OPTIONS, onGeometry: () => {} })).model;
}

const layoutsOf = (root: Group['parent']) => meshesOf(root!).map(({ geometry }) => geometry.userData.hatching.layout);

/** The occlusion of each corner. */
function occlusionOf({ attributes: { hatchNormal }, index }: BufferGeometry): number[] {
  const corners = index ? [...index.array] : [...Array(hatchNormal.count).keys()];
  return corners.map((vertex) => hatchNormal.array[4 * vertex + 3]);
}

describe('triangle adjacency', () => {
  test('is missing in a scene at first: a technique that needs it is drawn as anchored until it is baked', async () => {
    const model = await someModel();
    const techniques = () => meshesOf(model.root).map(({ material }) => (material as HatchingMaterial).technique);
    const look = lookOf({ ...defaultSettings(), technique: 'adjacencyCrisp' });
    model.apply(look);
    expect([model.lacksAdjacency, ...techniques()]).toEqual([true, 'hatching', 'hatching']);
    await bakeFurther(model.root, { adjacency: true }, OPTIONS, () => {});
    model.apply(look);
    expect([model.lacksAdjacency, ...techniques()]).toEqual([false, 'adjacency', 'adjacency']);
    expect(layoutsOf(model.root)).toEqual(['corner', 'corner']);
    expect((meshesOf(model.root)[0].material as HatchingMaterial).perTriangle.sharpInk).toBe(true);
    model.dispose();
  });

  test('is baked along with the requested form, and keeps earlier occlusion', async () => {
    const model = await someModel();
    const [torus] = meshesOf(model.root);
    const { hatchNormal } = torus.geometry.attributes;
    for (let vertex = 0; vertex < hatchNormal.count; vertex++) hatchNormal.array[4 * vertex + 3] = vertex;
    const before = occlusionOf(torus.geometry);
    await bakeFurther(model.root, { form: FORM, adjacency: true }, OPTIONS, () => {});
    expect(torus.geometry.hasAttribute('formValue')).toBe(true);
    expect(torus.geometry.userData.hatching.layout).toBe('corner');
    expect(occlusionOf(torus.geometry)).toEqual(before);
    model.dispose();
  });

  test('is not asked of a damaged part, which is hidden', async () => {
    const damaged = new BoxGeometry();
    damaged.setAttribute('position', new Float32BufferAttribute([0, 0, 0], 3));
    const meshes = [damaged, new BoxGeometry()].map((shape) => new Mesh(shape, new MeshStandardMaterial()));
    const scene = { root: new Group().add(...meshes), animations: [] };
    const { model, notes } = await modelOfScene(scene, { ...OPTIONS, onGeometry: () => {} });
    expect(notes).toEqual(['1 damaged part left out']);
    await bakeFurther(model.root, { form: FORM, adjacency: true }, OPTIONS, () => {});
    expect(meshes[1].geometry.userData.hatching.layout).toBe('corner');
    expect(model.lacksAdjacency).toBe(false);
    model.dispose();
  });

  test('is not baked where it is: a mesh of few triangles has it, and gets no more than the form', async () => {
    const { attributes, index } = new TorusGeometry(1, 0.4, 24, 48);
    const positions = Float32Array.from(attributes.position.array);
    const mesh = { positions, indices: Uint32Array.from(index!.array), normals: null, colors: null };
    const model = await modelOfMesh(mesh, OPTIONS);
    const [{ geometry }] = meshesOf(model.root);
    expect(model.lacksAdjacency).toBe(false);
    const baked: BufferGeometry[][] = [];
    const further = { form: FORM, adjacency: true };
    await bakeFurther(model.root, further, OPTIONS, (former, made) => baked.push([former, made]));
    expect(baked).toEqual([[geometry, geometry]]);
    expect(geometry.hasAttribute('formValue')).toBe(true);
    model.dispose();
  });
});
