import {
  BatchedMesh,
  BoxGeometry,
  type BufferGeometry,
  InstancedMesh,
  Matrix4,
  Mesh,
  type Scene,
  SphereGeometry,
  TorusGeometry,
} from 'three';
import { describe, expect, test } from 'vitest';
import { HatchingOutlines } from '../../../../src/material/outlines/HatchingOutlines.js';
import { drawSVG } from '../../../../src/vector/svg/drawSVG.js';
import { cameraAt, hatchedMesh, sceneOf } from '../hatchedScene.js';
import { pathsOf } from '../paths.js';
import { wronglySeen } from '../wronglySeen.js';

const SHEET = { sheet: [100, 100] as const, margin: 0, order: 'drawn' as const };
const draw = (scene: Scene) => drawSVG(scene, cameraAt(0.4, 0.5, 2), SHEET);

/** Instance matrices with scales and rotations; the last mirrors two axes, which is a rotation. */
const PLACES = [
  new Matrix4().makeRotationZ(0.3).setPosition(-0.5, 0.1, 0),
  new Matrix4().makeScale(1, 0.6, 1.3).premultiply(new Matrix4().makeRotationX(0.7)).setPosition(0.1, -0.2, 0.5),
  new Matrix4().makeScale(-0.7, -0.7, 0.7).setPosition(0.4, 0.35, -0.3),
];
const torus = () => new TorusGeometry(0.3, 0.13, 16, 32);
const material = { composition: { exposure: 1 } };

/** The same body as single meshes, one for each matrix. */
async function clones(source: () => BufferGeometry, places: readonly Matrix4[], outlines: boolean): Promise<Mesh[]> {
  const plain = await hatchedMesh(source(), { material, outlines: outlines ? {} : false });
  return places.map((place) => {
    const mesh = new Mesh(plain.geometry, plain.material);
    mesh.matrixAutoUpdate = false;
    mesh.matrix.copy(place);
    mesh.castShadow = mesh.receiveShadow = true;
    if (outlines) mesh.add(new HatchingOutlines(mesh));
    return mesh;
  });
}

const shadowed = (...meshes: Mesh[]): Scene => {
  const scene = sceneOf(...meshes);
  scene.children[0].castShadow = true;
  for (const mesh of meshes) mesh.castShadow = mesh.receiveShadow = true;
  return scene;
};

async function instanced(places: readonly Matrix4[]) {
  const plain = await hatchedMesh(torus(), { material });
  const mesh = new InstancedMesh(plain.geometry, plain.material, places.length);
  for (const [i, place] of places.entries()) mesh.setMatrixAt(i, place);
  mesh.add(new HatchingOutlines(mesh));
  return mesh;
}

describe('instances', () => {
  test('are drawn as single meshes are: lines, outlines and shadows', async () => {
    const one = await draw(shadowed(await instanced(PLACES)));
    const other = await draw(
      shadowed(
        ...(await clones(
          torus,
          PLACES.map((place) => new Matrix4().fromArray(Float32Array.from(place.elements))),
          true,
        )),
      ),
    );
    expect(pathsOf(one.svg, 'lines').length).toBeGreaterThan(60);
    expect(pathsOf(one.svg, 'outlines').length).toBeGreaterThan(5);
    expect(one.leftOut).toEqual([]);
    // Lines are drawn in the order of meshes.
    expect(one.svg).toBe(other.svg);
  });

  test('are drawn up to the count of the mesh, in its own space', async () => {
    const mesh = await instanced(PLACES);
    mesh.count = 1;
    mesh.position.set(0.2, -0.1, 0);
    const [plain] = await clones(torus, [new Matrix4().makeTranslation(0.2, -0.1, 0).multiply(PLACES[0])], true);
    const [one, other] = [await draw(sceneOf(mesh)), await draw(sceneOf(plain))];
    expect(one.paths).toBe(other.paths);
    expect(one.drawn).toBeCloseTo(other.drawn, 1);
  });

  test('have the morph targets of their own', async () => {
    const ball = () => new SphereGeometry(0.4, 24, 16);
    const morphing = ball();
    morphing.morphAttributes.position = [ball().scale(1, 2, 1).attributes.position];
    const plain = await hatchedMesh(morphing, { material });
    plain.updateMorphTargets();
    const mesh = new InstancedMesh(plain.geometry, plain.material, 2);
    const source = new Mesh(plain.geometry);
    for (const [i, influence] of [0, 1].entries()) {
      source.morphTargetInfluences![0] = influence;
      mesh.setMorphAt(i, source);
      mesh.setMatrixAt(i, new Matrix4().makeTranslation(i - 0.5, 0, 0));
    }
    const one = await drawSVG(sceneOf(mesh), cameraAt(0, 0, 2), SHEET);
    source.morphTargetInfluences![0] = 0;
    mesh.setMorphAt(1, source);
    const other = await drawSVG(sceneOf(mesh), cameraAt(0, 0, 2), SHEET);
    expect(other.drawn).toBeLessThan(0.8 * one.drawn);
  });

  test('hide each other, and are hidden where a triangle lies before them', async () => {
    const { share, pieces } = wronglySeen(sceneOf(await instanced(PLACES)), cameraAt(0.4, 0.5, 2), 4000);
    expect(pieces).toBeGreaterThan(1500);
    expect(share).toBeLessThanOrEqual(0.0005);
  });
});

describe('batches', () => {
  test('are drawn as single meshes are, of the geometries that their instances have', async () => {
    const [a, b] = [
      await hatchedMesh(torus(), { material, outlines: false }),
      await hatchedMesh(new BoxGeometry(0.5, 0.5, 0.5, 2, 2, 2), { material, outlines: false }),
    ];
    const batch = new BatchedMesh(8, 4000, 8000, a.material);
    const [first, second] = [batch.addGeometry(a.geometry), batch.addGeometry(b.geometry)];
    const deleted = batch.addInstance(first);
    for (const [i, place] of PLACES.entries()) batch.setMatrixAt(batch.addInstance(i === 1 ? second : first), place);
    const hidden = batch.addInstance(first);
    batch.setVisibleAt(hidden, false);
    batch.deleteInstance(deleted);
    const one = await draw(shadowed(batch));
    const rings = await clones(torus, PLACES, false);
    const boxes = await clones(() => new BoxGeometry(0.5, 0.5, 0.5, 2, 2, 2), PLACES, false);
    // All geometries of a batch share one origin of the field, that of the whole batch.
    batch.geometry.computeBoundingSphere();
    for (const { geometry } of [...rings, ...boxes]) geometry.boundingSphere = batch.geometry.boundingSphere!.clone();
    const other = await draw(shadowed(rings[0], boxes[1], rings[2]));
    expect(pathsOf(one.svg, 'lines').length).toBeGreaterThan(40);
    expect(one.paths).toBe(other.paths);
    expect(one.drawn).toBeCloseTo(other.drawn, 0);
  });
});
