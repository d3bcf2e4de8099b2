import {
  Bone,
  BoxGeometry,
  type BufferGeometry,
  CylinderGeometry,
  Float32BufferAttribute,
  type Mesh,
  Skeleton,
  SkinnedMesh,
  SphereGeometry,
  Uint16BufferAttribute,
  Vector3,
} from 'three';
import { describe, expect, test } from 'vitest';
import type { HatchingMaterialParameters } from '../../../../src/material/checkValues.js';
import { HatchingOutlines } from '../../../../src/material/outlines/HatchingOutlines.js';
import { drawSVG } from '../../../../src/vector/svg/drawSVG.js';
import { cameraAt, type HatchedLook, hatchedMesh, sceneOf } from '../hatchedScene.js';
import { pathsOf, ringsOf } from '../paths.js';
import { wronglySeen } from '../wronglySeen.js';

// No dashes of hairlines: they are fixed to places at rest, and differ from those of a baked pose.
const SHEET = { sheet: [100, 100] as const, margin: 0, leastWidth: 0 };
const camera = () => cameraAt(0.6, 0.4, 2);
const draw = (...meshes: Mesh[]) => drawSVG(sceneOf(...meshes), camera(), SHEET);

/** Skin weights of two bones: the second takes over from the height `from` to `to`. */
function bind(geometry: BufferGeometry, from: number, to: number): BufferGeometry {
  const { position } = geometry.attributes;
  const weights: number[] = [];
  for (let v = 0; v < position.count; v++) {
    const second = Math.min(1, Math.max(0, (position.getY(v) - from) / (to - from)));
    weights.push(1 - second, second, 0, 0);
  }
  geometry.setAttribute(
    'skinIndex',
    new Uint16BufferAttribute(
      weights.map((_, i) => Number(i % 4 === 1)),
      4,
    ),
  );
  return geometry.setAttribute('skinWeight', new Float32BufferAttribute(weights, 4));
}

/** A mesh with two bones, one at the origin and one above it. */
async function skinned(source: BufferGeometry, look: HatchedLook = {}) {
  const plain = await hatchedMesh(source, { ...look, outlines: look.outlines ?? {} });
  const mesh = new SkinnedMesh(plain.geometry, plain.material);
  const [lower, upper] = [new Bone(), new Bone()];
  lower.add(upper);
  mesh.add(lower);
  mesh.bind(new Skeleton([lower, upper]));
  if (look.outlines !== false) mesh.add(new HatchingOutlines(mesh, look.outlines));
  return { mesh, lower, upper };
}

const column = () => bind(new CylinderGeometry(0.35, 0.35, 1.6, 48, 24), -0.3, 0.3);

/** A copy of a geometry in the pose of a mesh. */
function baked(mesh: Mesh, source: BufferGeometry): BufferGeometry {
  const geometry = source.clone().deleteAttribute('skinIndex').deleteAttribute('skinWeight');
  const place = new Vector3();
  mesh.updateMatrixWorld(true);
  for (let v = 0; v < geometry.attributes.position.count; v++) {
    mesh.getVertexPosition(v, place);
    geometry.attributes.position.setXYZ(v, place.x, place.y, place.z);
  }
  geometry.computeVertexNormals();
  return geometry;
}

/** The share of points of one drawing that are farther than a distance from all points of another. */
function awayFrom(one: string, other: string, layer: string, distance: number): number {
  const pointsOf = (svg: string): number[][] =>
    pathsOf(svg, layer).flatMap((data) =>
      ringsOf(data).flatMap((ring) => ring.flatMap((x, i) => (i % 2 === 0 ? [[x, ring[i + 1]]] : []))),
    );
  const [points, others] = [pointsOf(one), pointsOf(other)];
  const cells = new Set(others.map(([x, y]) => `${Math.round(x / distance)},${Math.round(y / distance)}`));
  const isNear = ([x, y]: number[]): boolean =>
    [-1, 0, 1].some((i) =>
      [-1, 0, 1].some((k) => cells.has(`${Math.round(x / distance) + i},${Math.round(y / distance) + k}`)),
    );
  return points.filter((point) => !isNear(point)).length / points.length;
}

/** Expects two total lengths to be nearly equal. */
function expectAlike(one: number, other: number, share: number): void {
  expect(Math.abs(one - other)).toBeLessThan(share * other);
}

describe('skins', () => {
  const still: HatchingMaterialParameters = { direction: 'x', composition: { exposure: 1 }, colorHatching: 0 };

  test('a skin whose bones all turn is the mesh turned, lines and outlines', async () => {
    const { mesh, lower } = await skinned(column(), { material: still });
    lower.rotation.set(0.3, 0.2, -0.5);
    lower.position.set(0.1, 0, 0.2);
    const plain = await hatchedMesh(column(), { material: still });
    plain.rotation.copy(lower.rotation);
    plain.position.copy(lower.position);
    const [one, other] = [await draw(mesh), await draw(plain)];
    expect(one.leftOut).toEqual([]);
    expect(pathsOf(one.svg, 'lines').length).toBeGreaterThan(30);
    expectAlike(one.drawn, other.drawn, 0.002);
    expect(awayFrom(one.svg, other.svg, 'lines', 0.1)).toBeLessThan(0.005);
    expect(awayFrom(other.svg, one.svg, 'outlines', 0.1)).toBeLessThan(0.01);
  });

  test('the lines of the light know the pose of the first bone', async () => {
    const material: HatchingMaterialParameters = { ...still, direction: 'light' };
    const { mesh, lower } = await skinned(column(), { material, outlines: false });
    lower.rotation.set(0, 0, 0.7);
    const plain = await hatchedMesh(column(), { material, outlines: false });
    plain.rotation.z = 0.7;
    const [one, other] = [await draw(mesh), await draw(plain)];
    expect(awayFrom(one.svg, other.svg, 'lines', 0.1)).toBeLessThan(0.005);
  });

  test('a bent column has the outlines of its pose', { tags: ['all'] }, async () => {
    const { mesh, upper } = await skinned(column(), { material: still });
    upper.rotation.z = 0.8;
    const plain = await hatchedMesh(baked(mesh, column()), { material: still });
    const [one, other] = [await draw(mesh), await draw(plain)];
    expect(awayFrom(one.svg, other.svg, 'outlines', 0.5)).toBeLessThan(0.02);
    // Its normals are recomputed, and differ at the seam.
    expect(awayFrom(other.svg, one.svg, 'outlines', 0.5)).toBeLessThan(0.05);
    const straight = await draw(await hatchedMesh(column(), { material: still }));
    expect(awayFrom(straight.svg, one.svg, 'outlines', 0.5)).toBeGreaterThan(0.1);
  });

  test('lines that are cut as the skin is posed are those of the baked pose, and its lines at rest have their tone', async () => {
    const material: HatchingMaterialParameters = {
      ...still,
      direction: 'y',
      strokeAnchor: 'deformed',
      irregularity: 0,
      crossFrom: 1,
    };
    const { mesh, upper } = await skinned(column(), { material, outlines: false });
    upper.rotation.z = 0.8;
    const plain = await hatchedMesh(baked(mesh, column()), { material, outlines: false });
    plain.geometry.boundingSphere = mesh.geometry.boundingSphere!.clone();
    const [one, other] = [await draw(mesh), await draw(plain)];
    expect(awayFrom(one.svg, other.svg, 'lines', 0.3)).toBeLessThan(0.03);
    const inkOf = (svg: string): number => pathsOf(svg).reduce((sum, data) => sum + inkIn(ringsOf(data)), 0);
    expectAlike(inkOf(one.svg), inkOf(other.svg), 0.02);
    // Lines at rest stretch and crowd with the skin, but keep the tone.
    mesh.material.setValues({ strokeAnchor: 'rest' });
    const atRest = await draw(mesh);
    expect(awayFrom(atRest.svg, one.svg, 'lines', 0.3)).toBeGreaterThan(0.1);
    expectAlike(inkOf(atRest.svg), inkOf(one.svg), 0.05);
  });

  test('what is hidden in a pose is hidden where a triangle lies before it', async () => {
    const { mesh, upper } = await skinned(column(), { material: still, outlines: false });
    upper.rotation.set(1.5, 0, 0.9);
    const { share, pieces } = wronglySeen(sceneOf(mesh), camera(), 4000);
    expect(pieces).toBeGreaterThan(1000);
    expect(share).toBeLessThanOrEqual(0.0005);
  });
});

/** The signed area of rings, so that holes are subtracted. */
function inkIn(rings: number[][]): number {
  let area = 0;
  for (const ring of rings) {
    for (let i = 0; i < ring.length; i += 2) {
      const k = (i + 2) % ring.length;
      area += 0.5 * (ring[i] * ring[k + 1] - ring[k] * ring[i + 1]);
    }
  }
  return Math.abs(area);
}

describe('morph targets', () => {
  /** A geometry with another shape of itself as a morph target. */
  function morphing(source: BufferGeometry, other: BufferGeometry): BufferGeometry {
    source.morphAttributes.position = [other.attributes.position];
    source.morphAttributes.normal = [other.attributes.normal];
    return source;
  }

  test('a ball that is half way to one twice as high is hidden, shaded and outlined as such', async () => {
    const ball = () => new SphereGeometry(0.5, 48, 32);
    const material: HatchingMaterialParameters = {
      direction: 'z',
      composition: { exposure: 1 },
      irregularity: 0,
      strokeAnchor: 'deformed',
    };
    const mesh = await hatchedMesh(morphing(ball(), ball().scale(1, 2, 1)), { material });
    mesh.updateMorphTargets();
    mesh.morphTargetInfluences![0] = 0.5;
    const plain = await hatchedMesh(ball().scale(1, 1.5, 1), { material });
    plain.geometry.boundingSphere = mesh.geometry.boundingSphere!.clone();
    const [one, other] = [await draw(mesh), await draw(plain)];
    expect(one.leftOut).toEqual([]);
    expect(awayFrom(one.svg, other.svg, 'outlines', 0.5)).toBeLessThan(0.04);
    expect(awayFrom(other.svg, one.svg, 'outlines', 0.5)).toBeLessThan(0.04);
    expect(awayFrom(one.svg, other.svg, 'lines', 0.4)).toBeLessThan(0.05);
  });

  test('a target that moves all of a body moves its lines with it, through a skin as well', {
    tags: ['all'],
  }, async () => {
    const material: HatchingMaterialParameters = { direction: 'y', composition: { exposure: 1 } };
    const box = () => new BoxGeometry(0.8, 0.8, 0.8, 6, 6, 6);
    const source = bind(morphing(box(), box().translate(0.3, 0, 0)), 5, 6);
    const { mesh, lower } = await skinned(source, { material });
    mesh.updateMorphTargets();
    mesh.morphTargetInfluences![0] = 1;
    lower.rotation.y = 0.4;
    const plain = await hatchedMesh(box(), { material });
    plain.translateX(0.3 * Math.cos(0.4)).translateZ(-0.3 * Math.sin(0.4));
    plain.rotation.y = 0.4;
    // Morph targets affect the bounding sphere, whose centre is the origin of the field.
    plain.geometry.boundingSphere = mesh.geometry.boundingSphere!.clone();
    const [one, other] = [await draw(mesh), await draw(plain)];
    expect(awayFrom(one.svg, other.svg, 'lines', 0.1)).toBeLessThan(0.005);
    expect(awayFrom(other.svg, one.svg, 'outlines', 0.1)).toBeLessThan(0.01);
  });
});
