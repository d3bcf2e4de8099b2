import { Box3, Group, type Mesh, MeshBasicMaterial, OrthographicCamera, PlaneGeometry, Vector3 } from 'three';
import { describe, expect, test } from 'vitest';
import type { HatchingMaterialParameters } from '../../../../src/material/checkValues.js';
import { SceneExtent } from '../../../../src/material/fading/SceneExtent.js';
import type { HatchingMaterial } from '../../../../src/material/HatchingMaterial.js';
import { drawSVG } from '../../../../src/vector/svg/drawSVG.js';
import { cameraAt, hatchedMesh, planeOfTone, sceneOf } from '../hatchedScene.js';
import { coverageOf, pathsOf, ringsOf } from '../paths.js';

const TONE = 0.5;
/** The tone in a box of the sheet, which a plane of tone 0.5 fills. */
async function toneIn(
  box: readonly [number, number, number, number],
  material: HatchingMaterialParameters,
  prepare: (mesh: Mesh) => void = () => {},
): Promise<number> {
  const mesh = await planeOfTone(TONE, material);
  prepare(mesh);
  const { svg, leftOut } = await drawSVG(sceneOf(mesh), cameraAt(0, 0, 1), { sheet: [100, 100], margin: 0 });
  expect(leftOut).toEqual([]);
  return coverageOf(pathsOf(svg), box);
}

const MIDDLE = [40, 40, 20, 20] as const;

describe('surfaces', () => {
  test('an object of less importance, or in a group of less, is lighter', { tags: ['all'] }, async () => {
    const important = await toneIn(MIDDLE, {}, (mesh) => {
      mesh.userData.hatching = { importance: 0.4 };
    });
    expect(Math.abs(important - 0.4 * TONE)).toBeLessThan(0.015);
  });

  test('tone falls off around a focus, and towards the rim of the sheet', { tags: ['all'] }, async () => {
    const focus = new Vector3(0, 0, 0);
    expect(Math.abs((await toneIn(MIDDLE, { composition: { focus, focusRadius: 0.4 } })) - TONE)).toBeLessThan(0.015);
    expect(await toneIn([0, 0, 15, 15], { composition: { focus, focusRadius: 0.4 } })).toBeLessThan(1e-9);
    expect(Math.abs((await toneIn(MIDDLE, { composition: { vignette: 1 } })) - TONE)).toBeLessThan(0.015);
    expect(await toneIn([0, 0, 8, 8], { composition: { vignette: 1 } })).toBeLessThan(1e-9);
  });

  test('fade by their depth in the visible scene', { tags: ['all'] }, async () => {
    // A box around the plane, which lies in its middle: half of the depth, with a factor of e^(−3/2).
    const extent = (mesh: Mesh) => new SceneExtent(mesh, new Box3(new Vector3(-1, -1, -1), new Vector3(1, 1, 1)));
    const faded = await toneIn(MIDDLE, { composition: { depthFade: 0.8 } }, (mesh) => {
      (mesh.material as HatchingMaterial).composition.extent = extent(mesh);
    });
    const air = (1 - Math.exp(-1.5)) / (1 - Math.exp(-3));
    expect(Math.abs(faded - TONE * (1 - 0.8 * air))).toBeLessThan(0.015);
    // As deep as it is wide, a scene does not fade by default.
    const automatic = await toneIn(MIDDLE, { composition: { depthFade: 'auto' } }, (mesh) => {
      (mesh.material as HatchingMaterial).composition.extent = extent(mesh);
    });
    expect(Math.abs(automatic - TONE)).toBeLessThan(0.015);
  });
});

test('outlines are thinner with their depth, and heavier in front than without a fade', async () => {
  const sheets = await Promise.all(
    [2, 4, 10].map(async (depth, i) => {
      const sheet = await hatchedMesh(new PlaneGeometry(0.5, 4), {
        material: {
          composition: { depthFade: 0.5 },
          toneCurve: [
            [0, 0],
            [1, 0],
          ],
        },
        outlines: { outlineWidth: 4, weights: { lit: 1, shade: 1, borders: 1 }, lostEdges: 0 },
      });
      sheet.position.set(i - 1, 0, -depth);
      return sheet;
    }),
  );
  const scene = sceneOf(...sheets);
  const root = new Group();
  scene.add(root);
  const extent = new SceneExtent(root, new Box3(new Vector3(-1, -1, -10), new Vector3(1, 1, -2)));
  for (const { material } of sheets) (material as HatchingMaterial).composition.extent = extent;
  const { svg } = await drawSVG(scene, new OrthographicCamera(-1.5, 1.5, 1.5, -1.5, 0.1, 50), { sheet: [90, 90] });
  const air = (1 - Math.exp(-3 / 4)) / (1 - Math.exp(-3));
  const expected = [0, air, 1].map((share) => 4 * (1 - 0.5 * share) * (1 + 0.2 * (1 - share)) * (25.4 / 96));
  for (const [i, width] of expected.entries()) {
    const left = 10 + (70 / 3) * i;
    // Two borders, from top to bottom.
    const covered = coverageOf(pathsOf(svg), [left, 30, 70 / 3, 30]) * (70 / 3);
    expect(Math.abs(covered - 2 * width)).toBeLessThan(0.02);
  }
});

test('objects of importance 0 are blank, and hide what is behind them', async () => {
  const blank = await hatchedMesh(new PlaneGeometry(1, 1), { outlines: false });
  blank.userData.hatching = { importance: 0 };
  const behind = await planeOfTone(TONE);
  behind.position.z = -0.5;
  const { svg } = await drawSVG(sceneOf(blank, behind), cameraAt(0, 0, 1), { sheet: [100, 100] });
  expect(coverageOf(pathsOf(svg), [40, 40, 20, 20])).toBeLessThan(1e-9);
  expect(coverageOf(pathsOf(svg), [12, 12, 10, 70])).toBeGreaterThan(0.4);
});

test('a mesh without a hatching material has no fading', async () => {
  const mesh = await hatchedMesh(new PlaneGeometry(1, 1), { outlines: { weights: { borders: 1 }, lostEdges: 0 } });
  (mesh as Mesh).material = new MeshBasicMaterial();
  mesh.userData.hatching = { importance: 0 };
  const { svg } = await drawSVG(sceneOf(mesh), cameraAt(0, 0, 1));
  expect(pathsOf(svg).flatMap(ringsOf).length).toBeGreaterThan(0);
});
