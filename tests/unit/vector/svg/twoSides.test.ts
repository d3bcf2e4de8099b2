import {
  BoxGeometry,
  type BufferGeometry,
  DoubleSide,
  Mesh,
  MeshStandardMaterial,
  PlaneGeometry,
  SphereGeometry,
} from 'three';
import { expect, test } from 'vitest';
import type { HatchingOutlineParameters } from '../../../../src/material/outlines/HatchingOutlineMaterial.js';
import { applyHatching } from '../../../../src/scene/applyHatching.js';
import { bakeOcclusion } from '../../../../src/scene/bakeOcclusion.js';
import { drawSVG } from '../../../../src/vector/svg/drawSVG.js';
import { cameraAt, sceneOf } from '../hatchedScene.js';
import { coverageOf, pathsOf } from '../paths.js';

/** Surfaces that are drawn from both sides: which way their faces point makes no difference. Lengths in millimetres. */

const SIDE = 60;
/** The sheet is compared in so many fields a side. */
const FIELDS = 10;

/** Turns a geometry inside out. */
function reversed(geometry: BufferGeometry): BufferGeometry {
  const { index, attributes } = geometry;
  for (let i = 0; i < index!.count; i += 3) {
    const [b, c] = [index!.getX(i + 1), index!.getX(i + 2)];
    index!.setX(i + 1, c);
    index!.setX(i + 2, b);
  }
  const { array } = attributes.normal;
  for (let i = 0; i < array.length; i++) array[i] *= -1;
  return geometry;
}

/** A box without its lid. */
function openBox(): BufferGeometry {
  const box = new BoxGeometry(1, 0.7, 0.9, 6, 6, 6);
  const { start, count } = box.groups[2];
  box.setIndex(Array.from(box.index!.array).filter((_, i) => i < start || i >= start + count));
  box.clearGroups();
  return box;
}

/** A sheet bent like a roof. */
function roof(): BufferGeometry {
  const sheet = new PlaneGeometry(1.2, 1, 12, 12).rotateX(-0.5 * Math.PI);
  const { position } = sheet.attributes;
  for (let i = 0; i < position.count; i++) position.setY(i, 0.3 - Math.abs(position.getX(i)));
  sheet.computeVertexNormals();
  return sheet;
}

const bowl = (): BufferGeometry => new SphereGeometry(0.7, 32, 16, 0, 2 * Math.PI, 0.5 * Math.PI, 0.5 * Math.PI);

/** The ink in each field of a drawing. weights: of outlines, which are drawn alone; null for a drawing without them. */
async function inkOf(
  geometry: BufferGeometry,
  isMirrored: boolean,
  weights: HatchingOutlineParameters['weights'] | null,
): Promise<number[]> {
  const mesh = new Mesh(geometry, new MeshStandardMaterial({ side: DoubleSide }));
  mesh.castShadow = mesh.receiveShadow = true;
  if (isMirrored) mesh.scale.x = -1;
  const scene = sceneOf(mesh);
  scene.children[0].castShadow = true;
  await applyHatching(scene, {
    material: { technique: 'engraving', direction: 'slant', composition: { exposure: 1 } },
    outlines: weights !== null && { weights, outlineWidth: 4, lostEdges: 0, wobble: 0 },
  });
  if (weights === null) await bakeOcclusion(scene, { directions: 64 });
  const { svg } = await drawSVG(scene, cameraAt(0.5, 0.9, 1), { sheet: [SIDE, SIDE], margin: 0 });
  const paths = pathsOf(svg, weights === null ? '' : /outlines/i);
  const size = SIDE / FIELDS;
  return Array.from({ length: FIELDS ** 2 }, (_, i) =>
    coverageOf(paths, [size * (i % FIELDS), size * Math.floor(i / FIELDS), size, size], 40),
  );
}

const SHAPES = { 'a bowl': bowl, 'a box without a lid': openBox, 'a roof': roof };

for (const [name, make] of Object.entries(SHAPES)) {
  for (const isMirrored of [false, true]) {
    const kind = `${isMirrored ? 'mirrored, ' : ''}${name}`;
    test(`${kind}: lines, shadows and hollows are the same when it is turned inside out`, {
      tags: isMirrored || make !== roof ? ['all'] : [],
    }, async () => {
      const [one, other] = [await inkOf(make(), isMirrored, null), await inkOf(reversed(make()), isMirrored, null)];
      expect(Math.max(...one)).toBeGreaterThan(0.3);
      for (const [i, ink] of one.entries()) expect(Math.abs(ink - other[i]), `field ${i}`).toBeLessThan(0.02);
    });
  }
}

const CREASES = { contours: 0, creases: 1, borders: 1, lit: 1, shade: 1 };
const ALL = { creases: 0.6, suggestiveContours: 0.6 };

for (const [name, make, weights] of [
  ['creases of a box without a lid', openBox, CREASES],
  ['outlines of a bowl', bowl, ALL],
  ['outlines of a box without a lid', openBox, ALL],
  ['outlines of a roof', roof, ALL],
] as const) {
  test(`${name} are the same when it is turned inside out`, {
    tags: make === roof || weights === CREASES ? ['all'] : [],
  }, async () => {
    const [one, other] = [await inkOf(make(), false, weights), await inkOf(reversed(make()), false, weights)];
    expect(Math.max(...one)).toBeGreaterThan(0.02);
    for (const [i, ink] of one.entries()) expect(Math.abs(ink - other[i]), `field ${i}`).toBeLessThan(0.01);
  });
}
