import { ShaderMaterial, type WebGLRenderer } from 'three';
import { expect, test } from 'vitest';
import { MeshUniforms } from '../../../../src/material/three/MeshUniforms.js';

interface Kept {
  uniformsList: { id: string }[] | null;
}

/** The steps of three's setProgram that concern the uniforms of a material, in its order. */
function threeDraws(material: ShaderMaterial, kept: Kept, isOther: boolean): string[] {
  const uploaded: string[] = [];
  const upload = (): void => {
    kept.uniformsList ??= [{ id: 'ink' }, { id: 'ofMesh' }, { id: 'tone' }];
    uploaded.push(...kept.uniformsList.map(({ id }) => id));
  };
  if (isOther) {
    material.uniformsNeedUpdate = false;
    upload();
  }
  if (material.uniformsNeedUpdate === true) {
    upload();
    material.uniformsNeedUpdate = false;
  }
  return uploaded;
}

function setUp() {
  const kept: Kept = { uniformsList: null };
  const material = new ShaderMaterial();
  const ofMesh = new MeshUniforms(material, ['ofMesh', 'alsoOfMesh']);
  const renderer = { properties: { get: (of: unknown) => (of === material ? kept : {}) } } as unknown as WebGLRenderer;
  return { kept, material, ofMesh, renderer, draw: (isOther = false) => threeDraws(material, kept, isOther) };
}

const ALL = ['ink', 'ofMesh', 'tone'];

test('a mesh without requests uploads nothing, and after a change of material everything once', () => {
  const { draw, ofMesh, renderer } = setUp();
  expect(draw(true)).toEqual(ALL);
  expect(draw()).toEqual([]);
  ofMesh.want(renderer);
  expect(draw(true)).toEqual(ALL);
  expect(draw()).toEqual([]);
});

test("a request uploads the uniforms of the mesh alone, and three's list is complete again afterwards", () => {
  const { draw, ofMesh, renderer, kept } = setUp();
  draw(true);
  const list = kept.uniformsList;
  for (let i = 0; i < 2; i++) {
    ofMesh.want(renderer);
    expect(draw()).toEqual(['ofMesh']);
    expect(kept.uniformsList).toBe(list);
  }
  expect(draw(true)).toEqual(ALL);
});

test('uniformsNeedUpdate uploads all, whatever the mesh requests', () => {
  const { draw, ofMesh, renderer, material } = setUp();
  draw(true);
  material.uniformsNeedUpdate = true;
  expect(ofMesh.isAllWanted).toBe(true);
  ofMesh.want(renderer);
  expect(draw()).toEqual(ALL);
  expect(ofMesh.isAllWanted).toBe(false);
  expect(draw()).toEqual([]);
});

test("a hook that sets uniformsNeedUpdate, or a new program, restores three's list", () => {
  const { draw, ofMesh, renderer, material, kept } = setUp();
  draw(true);
  ofMesh.want(renderer);
  expect(material.uniformsNeedUpdate).toBe(true);
  expect(draw(true)).toEqual(ALL);
  ofMesh.want(renderer);
  expect(material.uniformsNeedUpdate).toBe(true);
  kept.uniformsList = null;
  expect(draw(true)).toEqual(ALL);
});

test('all is uploaded if three has no list for the material, such as behind a proxy', () => {
  const { draw, ofMesh } = setUp();
  draw(true);
  ofMesh.want({ properties: { get: () => ({}) } } as unknown as WebGLRenderer);
  expect(draw()).toEqual(ALL);
});
