import { Color } from 'three';
import { afterEach, expect, test, vi } from 'vitest';
import type { HatchingMaterial } from '../../../../src/material/HatchingMaterial.js';
import { buildModel } from '../../../../src/viewer/drawing/buildModel.js';
import type { HatchedModel } from '../../../../src/viewer/drawing/HatchedModel.js';
import { type GltfParts, parseGltf } from '../../../../src/viewer/files/gltf/parseGltf.js';
import { readGltf } from '../../../../src/viewer/files/gltf/readGltf.js';
import { readModel } from '../../../../src/viewer/files/readModel.js';
import { lookOf } from '../../../../src/viewer/settings/lookOf.js';
import { defaultSettings } from '../../../../src/viewer/settings/settings.js';
import { tetrahedron } from '../../../../tools/modelFiles/GltfBuilder.js';

const MESHES = 120;
/** Milliseconds that a slice may take, of which the clock below says that each look at it takes one. */
const SLICE = 8;

afterEach(() => {
  vi.restoreAllMocks();
});

/** A file of meshes that glow, each with a material of its own. */
function manyGlowing(count: number): Uint8Array<ArrayBuffer> {
  const builder = tetrahedron();
  const { json } = builder;
  const [primitive] = json.meshes[0].primitives;
  const each = <Item>(make: (i: number) => Item): Item[] => Array.from({ length: count }, (_, i) => make(i));
  json.materials = each((i) => ({ emissiveFactor: [(i + 1) / count, 0, 0] }));
  json.meshes = each((material) => ({ primitives: [{ ...primitive, material }] }));
  json.nodes = each((mesh) => ({ mesh, translation: [3 * mesh, 0, 0] }));
  json.scenes = [{ nodes: each((i) => i) }];
  return builder.glb() as Uint8Array<ArrayBuffer>;
}

/** Time passes when somebody asks for it. */
function slowClock(): void {
  let now = 0;
  vi.spyOn(performance, 'now').mockImplementation(() => now++);
}

async function partsOf(count: number): Promise<GltfParts> {
  const { content } = await readGltf(manyGlowing(count), 'glowing.glb', true, async () => undefined);
  return content as GltfParts;
}

async function glowingModel(count: number): Promise<{ model: HatchedModel; materials: HatchingMaterial[] }> {
  const read = await readModel([{ name: 'glowing.glb', content: new Blob([manyGlowing(count)]) }], () => {});
  const { model } = await buildModel(read, () => {}, new AbortController().signal);
  const materials: HatchingMaterial[] = [];
  model.root.traverse((object) => {
    if ('isMesh' in object) materials.push((object as unknown as { material: HatchingMaterial }).material);
  });
  return { model, materials };
}

test('a scene of many meshes is put together in slices, and cancelled between them', async () => {
  const parts = await partsOf(MESHES);
  slowClock();
  let turns = 0;
  let isDone = false;
  const turn = () => {
    turns++;
    if (!isDone) setImmediate(turn);
  };
  setImmediate(turn);
  const { root } = await parseGltf(parts);
  isDone = true;
  expect(root.children.map(({ position }) => position.x)).toEqual(Array.from({ length: MESHES }, (_, i) => 3 * i));
  expect(turns).toBeGreaterThanOrEqual(MESHES / SLICE / 2);

  const stop = new AbortController();
  setImmediate(() => stop.abort(new Error('enough')));
  await expect(parseGltf(parts, stop.signal)).rejects.toThrow('enough');
});

test('settings are applied material by material, and only where another drawing is shown', async () => {
  const { model, materials } = await glowingModel(5);
  expect(materials).toHaveLength(5);
  const settings = { ...defaultSettings(), ink: '#204060' };
  const look = lookOf(settings);
  const set = vi.spyOn(Color.prototype, 'set');
  const written = (): boolean => {
    const { length } = set.mock.calls;
    set.mockClear();
    return length > 0;
  };
  const stopped = model.applying(look);
  stopped.next();
  stopped.next();
  stopped.return();
  const inks = () => materials.map(({ ink }) => ink.getHexString());
  expect(inks().filter((ink) => ink === '204060')).toHaveLength(2);
  // What was begun is not taken for done.
  expect([...model.applying(look)]).toHaveLength(5);
  expect(new Set(inks())).toEqual(new Set(['204060']));
  expect(written()).toBe(true);
  model.apply(lookOf({ ...settings, model: 'file', upAxis: 'z', lightAzimuth: 12 }));
  expect(written()).toBe(false);
  const curve = materials[0].toneCurve;
  model.show('colour');
  expect(materials[0].toneCurve).not.toEqual(curve);
  model.show('whole');
  expect(materials[0].toneCurve).toEqual(curve);
  written();
  model.apply(lookOf({ ...settings, ink: '#000000' }));
  expect(written()).toBe(true);
  expect(new Set(inks())).toEqual(new Set(['000000']));
  model.dispose();
});
