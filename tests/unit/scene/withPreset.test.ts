import { Group, Mesh, MeshBasicMaterial, SphereGeometry } from 'three';
import { expect, test } from 'vitest';
import type { HatchingMaterial } from '../../../src/material/HatchingMaterial.js';
import type { ApplyHatchingOptions } from '../../../src/scene/ApplyHatchingOptions.js';
import { applyHatching } from '../../../src/scene/applyHatching.js';
import { type HatchingPreset, presets, withPreset } from '../../../src/scene/presets.js';

test('options override a preset, parameter by parameter', () => {
  expect(withPreset('pencil')).toEqual(presets.pencil);
  const { material, outlines, tonalArtMap, layout } = withPreset('pencil', {
    layout: 'pull',
    material: { ink: 'navy' },
    outlines: { wobble: 0 },
    tonalArtMap: { style: 'ruled', size: 64 },
  });
  expect(material).toEqual({ ...presets.pencil.material, ink: 'navy' });
  expect(outlines).toEqual({ ...presets.pencil.outlines, wobble: 0 });
  expect([tonalArtMap, layout]).toEqual([{ style: 'ruled', size: 64 }, 'pull']);
});

test('weights of outlines override those of a preset one by one', () => {
  const { weights } = presets.technical.outlines;
  const weightsWith = (outlines: ApplyHatchingOptions['outlines']) =>
    (withPreset('technical', { outlines }).outlines as HatchingPreset['outlines']).weights;
  expect(weightsWith({ weights: { creases: 0 } })).toEqual({ ...weights, creases: 0 });
  expect(weightsWith({ wobble: 1 })).toEqual(weights);
  expect(weightsWith({ weights: null! })).toBe(null);
  expect(withPreset('pen', { outlines: { weights: { lit: 1 } } }).outlines).toEqual({
    ...presets.pen.outlines,
    weights: { lit: 1 },
  });
});

test('outlines can be left out or kept, a map removed, and a function adds to the material', () => {
  expect(withPreset('pen', { outlines: false }).outlines).toBe(false);
  expect(withPreset('pen', { outlines: true }).outlines).toEqual(presets.pen.outlines);
  expect(withPreset('pencil', { tonalArtMap: null }).tonalArtMap).toBe(null);
  // The preset needs no map, and sets none for other techniques.
  expect(withPreset('engraving').tonalArtMap).toBe(undefined);
  const { material } = withPreset('chalk', { material: ({ name }) => ({ name: `${name} in chalk` }) });
  const source = new MeshBasicMaterial({ name: 'wood' });
  expect((material as (source: object, mesh: object) => object)(source, new Mesh())).toEqual({
    ...presets.chalk.material,
    name: 'wood in chalk',
  });
});

test("a style or a map among the material's parameters overrides the map of the preset", () => {
  const { material, tonalArtMap } = withPreset('pencil', { material: { tonalArtMap: 'dashes' } });
  expect([(material as { tonalArtMap: string }).tonalArtMap, tonalArtMap]).toEqual(['dashes', undefined]);
});

test('a preset of your own is used unchanged', () => {
  const mine = { material: { ink: 'red' }, outlines: { outlineWidth: 3 }, tonalArtMap: { style: 'ruled' } } as const;
  expect(withPreset(mine)).toEqual(mine);
});

test.each([['scribble'], ['toString'], [7], [null]])('%s is no preset', async (name) => {
  const root = new Group().add(new Mesh(new SphereGeometry(1, 8, 6), new MeshBasicMaterial()));
  await expect(applyHatching(root, { preset: name as 'pen' })).rejects.toThrow(
    new RangeError(
      `applyHatching: there is no preset "${name}". Use one of ${Object.keys(presets).join(', ')}, or pass a preset of your own.`,
    ),
  );
});

test('applyHatching takes a name instead of options, or among them', async () => {
  for (const options of ['technical', { preset: 'technical' }, { preset: presets.technical }] as const) {
    const mesh = new Mesh(new SphereGeometry(1, 8, 6), new MeshBasicMaterial());
    const hatched = await applyHatching(mesh, options);
    const material = mesh.material as unknown as HatchingMaterial;
    expect([material.technique, material.direction, material.lineSpacing]).toEqual(['engraving', 'y', 5]);
    expect(hatched.outlines.map((outlines) => outlines.material.outlineWidth)).toEqual([1.6]);
    hatched.dispose();
  }
});
