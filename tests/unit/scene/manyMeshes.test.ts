import { BoxGeometry, Group, Mesh, MeshLambertMaterial } from 'three';
import { afterEach, expect, test, vi } from 'vitest';
import * as identities from '../../../src/material/geometry/identityOf.js';
import type { HatchingMaterial } from '../../../src/material/HatchingMaterial.js';
import { applyHatching } from '../../../src/scene/applyHatching.js';
import { OutlineMaker } from '../../../src/scene/OutlineMaker.js';

vi.mock('../../../src/material/geometry/identityOf.js', async (original) => {
  const { identityOf } = await original<typeof identities>();
  return { identityOf: vi.fn(identityOf) };
});

const MESHES = 200;
/** The milliseconds that a slice may take, and those that each read of the clock below adds. */
const SLICE = 8;
const LOOK = 1;

afterEach(() => {
  vi.restoreAllMocks();
});

/** Meshes with one geometry and a material each. */
function manyMaterials(): Group {
  const geometry = new BoxGeometry();
  return new Group().add(...Array.from({ length: MESHES }, () => new Mesh(geometry, new MeshLambertMaterial())));
}

/** Time passes only when the clock is read. */
function slowClock(): void {
  let now = 0;
  vi.spyOn(performance, 'now').mockImplementation(() => {
    now += LOOK;
    return now;
  });
}

test('thousands of materials are made in slices, and other events come in between', async () => {
  slowClock();
  let made = 0;
  let longest = 0;
  let before = 0;
  const turn = () => {
    longest = Math.max(longest, made - before);
    before = made;
    if (made < MESHES) setImmediate(turn);
  };
  setImmediate(turn);
  const material = () => {
    made++;
    return {};
  };
  const hatched = await applyHatching(manyMaterials(), { tonalArtMap: null, material });
  expect(made).toBe(MESHES);
  expect(longest).toBeLessThanOrEqual(2 * SLICE);
  hatched.dispose();
});

test('aborted in between it makes no more materials, and frees those it made', async () => {
  slowClock();
  const stop = new AbortController();
  let made = 0;
  const freed = vi.fn();
  const { HatchingMaterial: Made } = await import('../../../src/material/HatchingMaterial.js');
  vi.spyOn(Made.prototype, 'dispose').mockImplementation(function (this: HatchingMaterial) {
    freed(this);
  });
  const material = () => {
    if (made === 0) setImmediate(() => stop.abort(new Error('enough')));
    made++;
    return {};
  };
  await expect(applyHatching(manyMaterials(), { tonalArtMap: null, material, signal: stop.signal })).rejects.toThrow(
    'enough',
  );
  expect(made).toBeGreaterThan(0);
  expect(made).toBeLessThanOrEqual(4 * SLICE);
  expect(freed).toHaveBeenCalledTimes(made);
});

test('hatching anew asks of each mesh a few times who it is, not for every other', async () => {
  const root = manyMaterials();
  const hatched = await applyHatching(root, { tonalArtMap: null });
  vi.mocked(identities.identityOf).mockClear();
  await hatched.setPreset({ tonalArtMap: null });
  expect(vi.mocked(identities.identityOf).mock.calls.length).toBeLessThan(20 * MESHES);
  hatched.dispose();
});

test('frames and outlines are made in slices, and a mesh that is given another material between them stays as it is', async () => {
  slowClock();
  const root = manyMaterials();
  const last = root.children.at(-1) as Mesh;
  const own = new MeshLambertMaterial();
  let turns = 0;
  const makeLines = vi.spyOn(OutlineMaker.prototype, 'addOutlines').mockImplementation(function (
    this: OutlineMaker,
    look,
  ) {
    if (makeLines.mock.calls.length === 1) setImmediate(turn);
    made.push(look.mesh);
  });
  const made: Mesh[] = [];
  const turn = () => {
    turns++;
    last.material = own;
    if (made.length < MESHES) setImmediate(turn);
  };
  const hatched = await applyHatching(root, { tonalArtMap: null, outlines: true });
  expect(made).toHaveLength(MESHES);
  expect(turns).toBeGreaterThan(MESHES / SLICE / 2);
  expect(hatched.skipped.map(({ mesh }) => mesh)).toEqual([last]);
  expect(last.material).toBe(own);
  hatched.dispose();
});
