import { BoxGeometry, DirectionalLight, Group, Mesh, MeshStandardMaterial, Scene, Vector3 } from 'three';
import { describe, expect, test, vi } from 'vitest';
import { HATCHING_PROPERTIES, type HatchingPropertyName } from '../../../src/look/hatchingProperties.js';
import { givenValue } from '../../../src/look/queries.js';
import { HatchingMaterial } from '../../../src/material/HatchingMaterial.js';
import { exampleHand } from '../../../src/strokes/hands/index.js';
import { applyHatching } from '../../../src/webgpu/applyHatching.js';
import { HatchingNodeMaterial } from '../../../src/webgpu/HatchingNodeMaterial.js';
import { HatchingOutlines } from '../../../src/webgpu/outlines/HatchingOutlines.js';

const names = Object.keys(HATCHING_PROPERTIES) as HatchingPropertyName[];

describe('HatchingNodeMaterial', () => {
  test.each([undefined, 'engraving', 'woodcut', 'pencil'] as const)(
    'has the properties of the material in GLSL: %s',
    (preset) => {
      const glsl = new HatchingMaterial(preset && { preset });
      const nodes = new HatchingNodeMaterial(preset && { preset });
      for (const name of names) expect(givenValue(nodes, name), name).toEqual(givenValue(glsl, name));
      for (const name of ['side', 'transparent', 'lights', 'fog', 'toneMapped'] as const)
        expect(nodes[name], name).toBe(glsl[name]);
    },
  );

  test('throws for the same values, before anything is set', () => {
    const nodes = new HatchingNodeMaterial({ lineSpacing: 7 });
    expect(() => nodes.setValues({ irregularity: 0.5, lineSpacing: -1 })).toThrow(RangeError);
    expect(nodes.irregularity).toBe(new HatchingMaterial().irregularity);
    expect(nodes.lineSpacing).toBe(7);
    expect(() => new HatchingNodeMaterial({ technique: 'etched' as 'engraving' })).toThrow(/etched/);
  });

  test('is copied with all its values, which stay independent', () => {
    const source = new HatchingNodeMaterial({
      preset: 'woodcut',
      ink: 0x123456,
      composition: { focus: new Vector3(1, 2, 3) },
      opacity: 0.5,
    });
    const copy = source.clone();
    for (const name of names) expect(givenValue(copy, name), name).toEqual(givenValue(source, name));
    expect(copy.opacity).toBe(0.5);
    expect(copy.uniforms).not.toBe(source.uniforms);
    copy.ink.set(0xffffff);
    copy.direction = 'z';
    expect(source.ink.getHex()).toBe(0x123456);
    expect(source.direction).not.toBe('z');
  });

  test('selects a program by choices, never by numbers', () => {
    const key = (look: ConstructorParameters<typeof HatchingNodeMaterial>[0]): string =>
      new HatchingNodeMaterial({ technique: 'engraving', ...look }).customProgramCacheKey();
    expect(key({ lineSpacing: 9, ink: 0xff0000, irregularity: 0 })).toBe(key({}));
    const keys = [
      key({}),
      key({ direction: 'x' }),
      key({ technique: 'pen' }),
      key({ toneModel: 'toon' }),
      key({ strokeAnchor: 'deformed' }),
    ];
    expect(new Set(keys).size).toBe(keys.length);
  });

  test('keeps its program from hand to hand, and takes another for the first and for none', async () => {
    const material = new HatchingNodeMaterial({ technique: 'pen', hand: exampleHand('brush') });
    const plain = new HatchingNodeMaterial({ technique: 'pen' }).customProgramCacheKey();
    await material.ready;
    const [key, version] = [material.customProgramCacheKey(), material.version];
    expect(key).not.toBe(plain);
    material.hand = exampleHand('woodcut');
    expect([material.customProgramCacheKey(), material.version]).toEqual([key, version]);
    material.hand = null;
    expect(material.customProgramCacheKey()).toBe(plain);
    expect(material.version).toBeGreaterThan(version);
  });

  test('refuses a hand with a fault once the code of hands is loaded, and keeps the last one', async () => {
    const hand = exampleHand('brush');
    const material = new HatchingNodeMaterial({ technique: 'pen', hand });
    await material.ready;
    const faulty = { ...hand, numbers: { ...hand.numbers, width: Number.NaN } };
    expect(() => Object.assign(material, { hand: faulty })).toThrow(/numbers\.width is NaN/);
    expect(material.hand).toBe(hand);
  });

  test('warns once that it has no debug views', () => {
    const warn = vi.spyOn(console, 'warn').mockImplementation(() => {});
    for (const debugView of ['none', 'tone', 'frames'] as const) new HatchingNodeMaterial({ debugView });
    expect(warn.mock.calls.flat().filter((text) => /there are no nodes of debugView/.test(text))).toHaveLength(1);
    warn.mockRestore();
  });

  test('reports an error under WebGLRenderer', () => {
    const error = vi.spyOn(console, 'warn').mockImplementation(() => {});
    const material = new HatchingNodeMaterial();
    material.onBeforeRender({ isWebGLRenderer: true } as never);
    material.onBeforeRender({ isWebGLRenderer: true } as never);
    expect(error.mock.calls.flat().filter((text) => /WebGLRenderer draws no node materials/.test(text))).toHaveLength(
      1,
    );
    error.mockRestore();
  });
});

describe('applyHatching for WebGPURenderer', () => {
  const scene = (): { root: Group; mesh: Mesh } => {
    const mesh = new Mesh(
      new BoxGeometry(),
      new MeshStandardMaterial({ color: 0x336699, opacity: 0.5, transparent: true }),
    );
    const root = new Group().add(mesh);
    new Scene().add(root, new DirectionalLight());
    return { root, mesh };
  };

  test('gives meshes materials of nodes and outlines, and restores them', async () => {
    const { root, mesh } = scene();
    const { geometry, material } = mesh;
    const hatched = await applyHatching(root, 'engraving');
    expect(mesh.material).toBeInstanceOf(HatchingNodeMaterial);
    expect(hatched.materials).toEqual([mesh.material]);
    expect(hatched.materials[0].color.getHex()).toBe(0x336699);
    expect(hatched.materials[0].opacity).toBe(0.5);
    expect(hatched.outlines).toHaveLength(1);
    expect(hatched.outlines[0]).toBeInstanceOf(HatchingOutlines);
    expect(mesh.children).toContain(hatched.outlines[0]);
    expect(mesh.geometry.hasAttribute('hatchNormal')).toBe(true);
    hatched.dispose();
    expect(mesh.material).toBe(material);
    expect(mesh.geometry).toBe(geometry);
    expect(mesh.children).toEqual([]);
  });

  test('says what to do instead of giving it the renderer', async () => {
    const { root, mesh } = scene();
    const options = { renderer: { isWebGPURenderer: true }, camera: {} } as never;
    await expect(applyHatching(root, options)).rejects.toThrow(/await renderer\.compileAsync\(scene, camera\)/);
    expect(mesh.material).toBeInstanceOf(MeshStandardMaterial);
  });
});
