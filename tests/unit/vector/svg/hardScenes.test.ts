import {
  BackSide,
  BoxGeometry,
  BufferAttribute,
  BufferGeometry,
  DoubleSide,
  Group,
  type Mesh,
  PerspectiveCamera,
  PlaneGeometry,
  SphereGeometry,
  TorusGeometry,
} from 'three';
import { afterEach, describe, expect, test, vi } from 'vitest';
import { prepareHatchingGeometry } from '../../../../src/material/geometry/prepareHatchingGeometry.js';
import { applyHatching } from '../../../../src/scene/applyHatching.js';
import { drawSVG } from '../../../../src/vector/svg/drawSVG.js';
import { cameraAt, hatchedMesh, planeOfTone, sceneOf } from '../hatchedScene.js';
import { pathsOf, ringsOf } from '../paths.js';

afterEach(() => vi.restoreAllMocks());

const SMALL = { sheet: [80, 80] as const, margin: 0 };

const draw = (...meshes: Mesh[]) => drawSVG(sceneOf(...meshes), cameraAt(0, 0, 1), SMALL);

/** All coordinates of a drawing, sorted, so that their order does not matter. */
const placesOf = (svg: string): number[] => pathsOf(svg).flatMap((data) => ringsOf(data).flat());

describe('scenes that are hard to draw', () => {
  test('a camera inside of the model, which sees its back', { tags: ['all'] }, async () => {
    const mesh = await hatchedMesh(new SphereGeometry(1, 32, 24), { material: { side: DoubleSide } });
    const camera = new PerspectiveCamera(60, 1, 0.1, 10);
    const { svg } = await drawSVG(sceneOf(mesh), camera, SMALL);
    expect(pathsOf(svg).length).toBeGreaterThan(10);
    expect(svg).not.toMatch(/NaN|Infinity/);
  });

  test('a ground that reaches behind the camera', async () => {
    const mesh = await planeOfTone(0.4);
    mesh.rotation.x = -Math.PI / 2;
    mesh.scale.setScalar(20);
    const camera = new PerspectiveCamera(50, 1, 0.1, 100);
    camera.position.set(0, 1, 2);
    camera.lookAt(0, 0, -3);
    const { svg, drawn } = await drawSVG(sceneOf(mesh), camera, SMALL);
    expect(svg).not.toMatch(/NaN|Infinity/);
    // The near edge is on the picture too.
    expect(Math.max(...placesOf(svg).filter((_, i) => i % 2 === 1))).toBeGreaterThan(78);
    expect(drawn).toBeGreaterThan(500);
  });

  test.each([
    ['triangles without area', 0, 4],
    ['positions that are no numbers, which nothing can be drawn of', Number.NaN, 0],
  ])('%s', async (_, odd, least) => {
    const geometry = new BufferGeometry();
    const positions = [0, 0, 0, 0, 0, 0, 1, 0, 0, -0.5, -0.5, 0, 0.5, -0.5, 0, 0, 0.5, 0, odd, 0, 0];
    geometry.setAttribute('position', new BufferAttribute(Float32Array.from(positions), 3));
    geometry.setAttribute(
      'normal',
      new BufferAttribute(
        new Float32Array(21).map((_, i) => Number(i % 3 === 2)),
        3,
      ),
    );
    geometry.setIndex([0, 1, 2, 3, 4, 5, 0, 1, 6]);
    // three.js reports that such positions have no bounding sphere.
    vi.spyOn(console, 'error').mockImplementation(() => {});
    const mesh = await planeOfTone(0.5);
    mesh.geometry = geometry;
    const { svg, paths } = await draw(mesh);
    expect(paths).toBeGreaterThanOrEqual(least);
    expect(svg).not.toMatch(/NaN|Infinity/);
  });
});

describe('what is drawn of a mesh', () => {
  test('a mirrored mesh, whose front stays its front', { tags: ['all'] }, async () => {
    const make = () => planeOfTone(0.5, { direction: 'y' });
    const [one, other] = [await make(), await make()];
    other.scale.x = -1;
    expect((await draw(one)).paths).toBeGreaterThan(20);
    expect((await draw(other)).drawn).toBeCloseTo((await draw(one)).drawn, 0);
  });

  test('the side that its material draws', async () => {
    const mesh = await planeOfTone(0.5);
    mesh.rotation.y = Math.PI;
    expect((await draw(mesh)).paths).toBe(0);
    mesh.material.side = DoubleSide;
    const both = await draw(mesh);
    mesh.material.side = BackSide;
    const back = await draw(mesh);
    expect(back.paths).toBeGreaterThan(20);
    expect(back.svg).toBe(both.svg);
  });

  test('the groups of several materials, each with its own', async () => {
    const geometry = await prepareHatchingGeometry(new BoxGeometry());
    const mesh = await planeOfTone(0.5);
    const blank = mesh.material.clone();
    blank.visible = false;
    const two = Object.assign(mesh, { geometry, material: [blank, blank, blank, blank, mesh.material, blank] });
    expect((await draw(two)).paths).toBeGreaterThan(10);
    Object.assign(two, { material: [blank, blank, blank, blank, blank, blank] });
    expect((await draw(two)).paths).toBe(0);
  });

  test('nothing that is invisible, or in other layers', async () => {
    const mesh = await hatchedMesh(new PlaneGeometry());
    const group = new Group().add(mesh);
    const scene = sceneOf();
    scene.add(group);
    group.visible = false;
    expect((await drawSVG(scene, cameraAt(0, 0, 1), SMALL)).paths).toBe(0);
    group.visible = true;
    mesh.traverse(({ layers }) => layers.set(3));
    expect((await drawSVG(scene, cameraAt(0, 0, 1), SMALL)).paths).toBe(0);
  });

  test('a geometry with adjacency, in the layouts of corners and of textures', { tags: ['all'] }, async () => {
    const [one, other] = await Promise.all([planeOfTone(0.5), planeOfTone(0.5)]);
    other.geometry = await prepareHatchingGeometry(new PlaneGeometry(3, 3, 8, 8), { layout: 'corner' });
    expect((await draw(other)).drawn).toBeCloseTo((await draw(one)).drawn, 0);
    other.geometry = await prepareHatchingGeometry(new PlaneGeometry(3, 3, 8, 8), { layout: 'pull' });
    const pulled = await draw(other);
    expect(pulled.drawn).toBeCloseTo((await draw(one)).drawn, 0);
    expect(pulled.leftOut).toEqual([]);
  });

  test('lines of the form run on across the seams of their field', async () => {
    const scene = sceneOf();
    const model = new Group();
    scene.add(model);
    const plain = await hatchedMesh(new TorusGeometry(0.7, 0.3, 32, 64), { outlines: false });
    model.add(plain);
    plain.geometry = await prepareHatchingGeometry(new TorusGeometry(0.7, 0.3, 32, 64), { form: true });
    plain.material.setValues({
      direction: 'form',
      irregularity: 0,
      crossFrom: 1,
      toneCurve: [
        [0, 0.4],
        [1, 0.4],
      ],
    });
    const { paths, drawn } = await drawSVG(scene, cameraAt(0, 0, 1), { ...SMALL, kind: 'pen' });
    expect(paths).toBeGreaterThan(20);
    // If they were cut at each seam, lines would be a few millimetres long.
    expect(drawn / paths).toBeGreaterThan(5);
  });
});

test('a scene hatched by applyHatching is drawn as it is', async () => {
  const mesh = await hatchedMesh(new SphereGeometry(0.8, 32, 24), { outlines: false });
  const scene = sceneOf(mesh);
  await applyHatching(scene, 'engraving');
  const { svg, leftOut } = await drawSVG(scene, cameraAt(0, 0, 1), SMALL);
  expect(leftOut).toEqual([]);
  expect(pathsOf(svg, 'lines').length).toBeGreaterThan(20);
});
