import { Mesh, MeshBasicMaterial, SphereGeometry } from 'three';
import { describe, expect, test, vi } from 'vitest';
import { HatchingOutlineMaterial } from '../../../src/material/outlines/HatchingOutlineMaterial.js';
import {
  OUTLINE_NUMBER_NAMES,
  OUTLINE_NUMBERS,
  WEIGHTED_LINES,
} from '../../../src/material/outlines/outlineProperties.js';
import { HatchingOutlineNodeMaterial } from '../../../src/webgpu/outlines/HatchingOutlineNodeMaterial.js';
import { HatchingOutlines } from '../../../src/webgpu/outlines/HatchingOutlines.js';

const NAME = 'HatchingOutlineNodeMaterial';

describe('HatchingOutlineNodeMaterial', () => {
  test('has the properties of the material in GLSL, with the same defaults, and blends alike', () => {
    const glsl = new HatchingOutlineMaterial();
    const nodes = new HatchingOutlineNodeMaterial();
    for (const name of OUTLINE_NUMBER_NAMES) expect(nodes[name], name).toBe(glsl[name]);
    for (const name of ['hidden', 'transparent', 'depthWrite', 'side', 'opacity', 'lights'] as const) {
      expect(nodes[name], name).toBe(glsl[name]);
    }
    expect(nodes.ink.getHex()).toBe(glsl.ink.getHex());
    expect({ ...nodes.weights }).toEqual({ ...glsl.weights });
  });

  test('writes the same uniforms', () => {
    const look = {
      outlineWidth: 3,
      wobble: 2,
      ink: 0x123456,
      weights: { creases: 0.9, lit: 0.1, shade: 3 },
      hidden: 'dashed',
    } as const;
    const glsl = new HatchingOutlineMaterial(look);
    const nodes = new HatchingOutlineNodeMaterial(look);
    glsl.writeUniforms(false, true, 2);
    nodes.writeLook(2);
    for (const name of [...OUTLINE_NUMBER_NAMES, ...WEIGHTED_LINES, 'ink', 'shadeWeights', 'opacity', 'isDashed']) {
      expect(nodes.uniforms[name].value, name).toEqual(glsl.uniforms[name].value);
    }
    expect(nodes.uniforms.outlineWidth.value).toBe(6);
  });

  test.each(OUTLINE_NUMBER_NAMES)('%s out of its range is an error that names the class', (name) => {
    const bad = 'above' in OUTLINE_NUMBERS[name] ? 0 : -1;
    expect(() => new HatchingOutlineNodeMaterial({ [name]: bad })).toThrow(/HatchingOutlineNodeMaterial/);
  });

  test('other values that make no sense are errors', () => {
    const material = new HatchingOutlineNodeMaterial();
    expect(() => material.setValues({ hidden: 'dotted' as 'dashed' })).toThrow(/hidden is dotted/);
    expect(() => material.setValues({ weights: { lit: -1 } })).toThrow(
      `${NAME}.weights.lit: -1 is not a number in [0, ∞)`,
    );
    expect(() => {
      material.weights.creases = Number.NaN;
    }).toThrow(`${NAME}.weights.creases: NaN is not a number`);
    expect(() => material.setValues({ ink: {} as string })).toThrow(/ink/);
  });

  test('materials of different looks share nodes, so that they share a program', () => {
    const one = new HatchingOutlineNodeMaterial({ outlineWidth: 1 });
    const other = new HatchingOutlineNodeMaterial({ outlineWidth: 5, ink: 'red', weights: { creases: 0 } });
    expect(other.vertexNode).toBe(one.vertexNode);
    expect(other.colorNode).toBe(one.colorNode);
    expect(other.customProgramCacheKey()).toBe(one.customProgramCacheKey());
  });

  test.each(['wobble', 'paperGrain'] as const)(
    '%s takes another program where it begins, and the first where it ends',
    (name) => {
      const material = new HatchingOutlineNodeMaterial();
      const key = material.customProgramCacheKey();
      const { version } = material;
      material[name] = 0.5;
      expect(material.customProgramCacheKey()).not.toBe(key);
      const begun = material.version;
      expect(begun).toBeGreaterThan(version);
      material[name] = 0.8;
      expect(material.version).toBe(begun);
      material[name] = 0;
      expect(material.customProgramCacheKey()).toBe(key);
    },
  );

  test('a clone has the same look, and uniforms of its own', () => {
    const material = new HatchingOutlineNodeMaterial({
      outlineWidth: 4,
      wobble: 1,
      ink: 0xff0000,
      weights: { shade: 3 },
      hidden: 'faint',
      fog: false,
    });
    const clone = material.clone();
    expect(clone).toMatchObject({ outlineWidth: 4, wobble: 1, hidden: 'faint', fog: false });
    expect(clone.ink.getHex()).toBe(0xff0000);
    expect(clone.ink).not.toBe(material.ink);
    expect(clone.weights).not.toBe(material.weights);
    expect({ ...clone.weights }).toEqual({ ...material.weights });
    expect(clone.weights.shade).toBe(3);
    expect(clone.uniforms).not.toBe(material.uniforms);
    expect(clone.vertexNode).toBe(material.vertexNode);
  });

  test('what is hidden is drawn by another program from the same uniforms', () => {
    const material = new HatchingOutlineNodeMaterial({ hidden: 'dashed', opacity: 0.4 });
    const hidden = material.ofHidden();
    expect(hidden.uniforms).toBe(material.uniforms);
    expect(hidden.opacity).toBe(0.4);
    expect(hidden.customProgramCacheKey()).not.toBe(material.customProgramCacheKey());
    expect(material.ofHidden()).toBe(hidden);
    material.paperGrain = 0.5;
    const { version } = hidden;
    material.ofHidden();
    expect(hidden.version).toBeGreaterThan(version);
    const told = vi.fn();
    hidden.addEventListener('dispose', told);
    material.dispose();
    expect(told).toHaveBeenCalledOnce();
  });
});

describe('HatchingOutlines of nodes', () => {
  test('disposes of its own material, and not of one that it was given', () => {
    const mesh = new Mesh(new SphereGeometry(1, 8, 6), new MeshBasicMaterial());
    const given = new HatchingOutlineNodeMaterial();
    const own = new HatchingOutlines(mesh, { outlineWidth: 3 });
    const told = vi.fn();
    for (const material of [given, own.material]) material.addEventListener('dispose', ({ target }) => told(target));
    new HatchingOutlines(mesh, given).dispose();
    expect(told).not.toHaveBeenCalled();
    own.dispose();
    expect(told).toHaveBeenCalledExactlyOnceWith(own.material);
  });

  test('draws the outlines of its parent, and a clone those of its own', () => {
    const mesh = new Mesh(new SphereGeometry(1, 8, 6), new MeshBasicMaterial());
    mesh.add(new HatchingOutlines(mesh));
    const clone = mesh.clone();
    expect((clone.children[0] as HatchingOutlines).mesh).toBe(clone);
  });
});
