import { Group, Mesh } from 'three';
import { HatchingMaterial } from 'three-hatching';
import { expect, test, vi } from 'vitest';
import { finerModel } from '../../../../src/playground/export/finerModel.js';
import { loadModelFiles } from '../../../../src/playground/reading/loadModelFiles.js';
import type { ReadModel } from '../../../../src/viewer/files/readModel.js';
import { defaultSettings } from '../../../../src/viewer/settings/settings.js';
import { scannedTorus } from '../../../../tools/bench/detail/scannedTorus.mjs';

vi.mock('../../../../src/playground/reading/loadModelFiles.js', () => ({ loadModelFiles: vi.fn() }));

/** A model of 7,200 triangles that is read again for some settings. */
async function finer(settings: object) {
  const mesh = { ...scannedTorus(60), normals: null, colors: null };
  vi.mocked(loadModelFiles).mockResolvedValue({ kind: 'mesh', mesh } as unknown as ReadModel);
  const viewport = { model: { root: new Group().add(new Mesh(undefined, new HatchingMaterial())) } };
  const stages = new Set<string>();
  const model = await finerModel(
    [],
    viewport as never,
    { ...defaultSettings(), ...settings },
    (name) => stages.add(name),
    new AbortController().signal,
  );
  const { array } = model.geometry.getAttribute('hatchNormal');
  const hollows = new Set(array.filter((_, i) => i % 4 === 3));
  return { ...model, hollows: hollows.size, stages: [...stages] };
}

test('a model that is read again has lines along the form and dark hollows, if the settings ask for them', {
  tags: ['all'],
}, async () => {
  const baked = await finer({ technique: 'engraving', direction: 'form', occlusion: 100 });
  expect(baked.triangles).toBe(7200);
  expect(baked.geometry.hasAttribute('formValue')).toBe(true);
  expect(baked.hollows).toBeGreaterThan(10);
  expect(baked.stages).toContain('darkening hollows');
  expect(vi.mocked(loadModelFiles).mock.lastCall![1].most).toBe(4_000_000);
});

test('bakes nothing that the settings do not need', async () => {
  const baked = await finer({ technique: 'hatching', direction: 'light', occlusion: 0 });
  expect(baked.geometry.hasAttribute('formValue')).toBe(false);
  expect(baked.hollows).toBe(1);
  expect(baked.stages).toEqual(['joining 7,200 triangles']);
});
