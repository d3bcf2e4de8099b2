import { type Mesh, SphereGeometry, Vector3 } from 'three';
import { mergeGeometries } from 'three/addons/utils/BufferGeometryUtils.js';
import { describe, expect, test } from 'vitest';
import { drawSVG } from '../../../../src/vector/svg/drawSVG.js';
import { cameraAt, hatchedMesh, sceneOf } from '../hatchedScene.js';
import { coverageOf, pathsOf } from '../paths.js';

/** Lines along which the surfaces of parts cut each other, in vector drawings. */

const BLANK = {
  toneCurve: [
    [0, 0],
    [1, 0],
  ] as [number, number][],
  hollowStrength: 0,
};
const OUTLINES = {
  outlineWidth: 2,
  lostEdges: 0,
  accents: 0,
  weights: { lit: 1, shade: 1, intersections: 1 },
} as const;
const AWAY = 0.3;
const RADIUS = 0.5;
const SIDE = 100;

const ball = (x: number) => new SphereGeometry(RADIUS, 128, 64).rotateZ(0.3).translate(x, 0, 0);
const hatched = (geometry: SphereGeometry | ReturnType<typeof mergeGeometries>, outlines = {}) =>
  hatchedMesh(geometry, { outlines: { ...OUTLINES, intersections: true, ...outlines }, material: BLANK });

/** Places on the circle in which the balls cut each other, in the drawing: those that are seen, and those that are hidden. */
function circlePlaces(camera: ReturnType<typeof cameraAt>) {
  camera.updateMatrixWorld();
  const across = Math.sqrt(RADIUS ** 2 - AWAY ** 2);
  const places = Array.from({ length: 120 }, (_, i) => {
    const angle = (i / 120) * 2 * Math.PI;
    const place = new Vector3(0, across * Math.cos(angle), across * Math.sin(angle));
    const sight = camera.position.clone().sub(place).normalize();
    const facing = [-AWAY, AWAY].map((x) => place.clone().setX(-x).normalize().dot(sight));
    const { x, y } = place.clone().project(camera);
    return { at: [(0.5 + 0.5 * x) * SIDE, (0.5 - 0.5 * y) * SIDE] as const, facing: Math.min(...facing) };
  });
  return {
    seen: places.filter(({ facing }) => facing > 0.1),
    hidden: places.filter(({ facing }) => facing < -0.1),
  };
}

async function draw(...meshes: Mesh[]) {
  const camera = cameraAt(1.2, 1.3, 2.4);
  const { svg } = await drawSVG(sceneOf(...meshes), camera, { sheet: [SIDE, SIDE], margin: 0 });
  const inkAt = (layer: string, [x, y]: readonly [number, number]) =>
    coverageOf(pathsOf(svg, layer), [x - 0.3, y - 0.3, 0.6, 0.6], 12);
  const { seen, hidden } = circlePlaces(camera);
  const inkIn = (layer: string, places: typeof seen) =>
    places.filter(({ at }) => inkAt(layer, at) > 0.3).length / places.length;
  const meanInk = seen.reduce((sum, { at }) => sum + inkAt('outlines', at), 0) / seen.length;
  return { seen: inkIn('outlines', seen), hidden: inkIn('outlines', hidden), behind: inkIn('hidden', hidden), meanInk };
}

describe('two balls', () => {
  test('have a line where they meet, hidden by themselves where they lie before it', async () => {
    const drawn = await draw(await hatched(ball(-AWAY)), await hatched(ball(AWAY)));
    expect(drawn.seen).toBe(1);
    expect(drawn.behind).toBe(0);
    // The contour of a ball passes before one or two of the places.
    expect(drawn.hidden).toBeLessThan(0.1);
  });

  test('of which one is of glass have a line as firm as two solid ones, whichever comes first', async () => {
    const glass = { ...BLANK, transparent: true, opacity: 0.25 };
    const of = (x: number, material = {}) =>
      hatchedMesh(ball(x), { outlines: { ...OUTLINES, intersections: true }, material: { ...BLANK, ...material } });
    const solid = (await draw(await of(-AWAY), await of(AWAY))).meanInk;
    const before = (await draw(await of(-AWAY, glass), await of(AWAY))).meanInk;
    const after = (await draw(await of(-AWAY), await of(AWAY, glass))).meanInk;
    const both = (await draw(await of(-AWAY, glass), await of(AWAY, glass))).meanInk;
    expect(solid).toBeGreaterThan(0.5);
    for (const one of [before, after]) expect(Math.abs(one / solid - 1)).toBeLessThan(0.1);
    expect(both).toBeLessThan(0.5 * solid);
  });

  test('have none unless both ask for it, and none of weight 0', async () => {
    const one = await hatched(ball(-AWAY));
    expect((await draw(one, await hatched(ball(AWAY), { intersections: false }))).seen).toBe(0);
    const none = { weights: { ...OUTLINES.weights, intersections: 0 } };
    expect((await draw(await hatched(ball(-AWAY), none), await hatched(ball(AWAY), none))).seen).toBe(0);
  });

  test('have it as shells of one mesh, and wherever their meshes are placed', async () => {
    expect((await draw(await hatched(mergeGeometries([ball(-AWAY), ball(AWAY)])))).seen).toBe(1);
    const [a, b] = [await hatched(ball(0)), await hatched(ball(0))];
    a.scale.set(-1, 1, 1);
    a.position.set(-AWAY, 0, 0);
    b.rotation.set(1, 2, 3);
    b.position.set(AWAY, 0, 0);
    expect((await draw(a, b)).seen).toBe(1);
  });

  test('have it in the layer of hidden outlines where it is hidden', async () => {
    const drawn = await draw(
      await hatched(ball(-AWAY), { hidden: 'faint' }),
      await hatched(ball(AWAY), { hidden: 'faint' }),
    );
    expect(drawn.seen).toBe(1);
    expect(drawn.hidden).toBeLessThan(0.1);
    expect(drawn.behind).toBeGreaterThan(0.9);
  });
});
