import { BoxGeometry, type DirectionalLight, PlaneGeometry, SphereGeometry } from 'three';
import { expect, test } from 'vitest';
import { runToEnd } from '../../../src/mesh/phases.js';
import { Bvh } from '../../../src/vector/Bvh.js';
import { placePicture } from '../../../src/vector/drawLines.js';
import { LineDrawer } from '../../../src/vector/LineDrawer.js';
import type { SurfacePlace } from '../../../src/vector/LineSurface.js';
import { EvenSurface, type SeenScene } from '../../../src/vector/streamlines/EvenSurface.js';
import { ownersOf } from '../../../src/vector/streamlines/evenLines.js';
import { LineFields } from '../../../src/vector/streamlines/LineFields.js';
import { Sheet } from '../../../src/vector/streamlines/Sheet.js';
import { planOf } from '../../../src/vector/svg/DrawSVGOptions.js';
import { readScene } from '../../../src/vector/svg/readScene.js';
import { cameraAt, hatchedMesh, sceneOf } from './hatchedScene.js';

/** A surface each cell of which is read alone, with all its rays. */
class TracedSurface extends EvenSurface {
  override get isPlain(): boolean {
    return false;
  }

  override tonesAt(place: SurfacePlace, triangle: number) {
    return super.tonesAt(place, triangle, 'traced');
  }
}

/** A ball above a ground with a thin bar, whose shadow is narrower than a block. */
async function shadowedScene() {
  const ball = await hatchedMesh(new SphereGeometry(0.35, 48, 32).translate(0, 0.1, 0));
  const bar = await hatchedMesh(new BoxGeometry(1.4, 0.015, 0.015).translate(0, 0.5, 0.3));
  const ground = await hatchedMesh(new PlaneGeometry(2.4, 2.4).rotateX(-Math.PI / 2).translate(0, -0.4, 0));
  const scene = sceneOf(ball, bar, ground);
  for (const mesh of [ball, bar, ground]) mesh.castShadow = mesh.receiveShadow = true;
  const sun = scene.children[0] as DirectionalLight;
  sun.castShadow = true;
  sun.shadow.mapSize.set(4096, 4096);
  scene.updateMatrixWorld();
  return scene;
}

test('cells between which no shadow begins are read together: their tones are those of each alone, by a fraction of the rays', async () => {
  const scene = await shadowedScene();
  const { drawn } = runToEnd(readScene(scene, cameraAt(0.2, 0.6, 1), true));
  const plan = planOf({ kind: 'pen', sheet: [70, 70], margin: 0 });
  const { projection, placement } = placePicture(drawn, plan);
  const owners = ownersOf(drawn, drawn.surfaces);
  const sheet = runToEnd(Sheet.of(drawn, owners, projection, { scale: placement.scale, pen: 0.3 }));
  const read = (Surface: typeof EvenSurface) => {
    const bvh = runToEnd(Bvh.build(drawn.corners, drawn.sides, drawn.cutouts));
    const { translucency } = new LineDrawer(drawn, null, projection, bvh);
    const seen: SeenScene = { scene: drawn, projection, bvh, translucency };
    const surfaces = drawn.surfaces.map((surface) => new Surface(surface, seen, sheet.facing));
    const before = bvh.rays;
    return { fields: runToEnd(LineFields.of(sheet, surfaces, owners)), rays: bvh.rays - before };
  };
  const [together, alone] = [read(EvenSurface), read(TracedSurface)];
  const { columns, rows } = alone.fields;
  const differences: number[] = [];
  for (let cell = 0; cell < columns * rows; cell++) {
    const tone = alone.fields.densityOf(0, cell);
    differences.push(Math.abs(together.fields.densityOf(0, cell) - tone));
  }
  differences.sort((a, b) => a - b);
  expect(alone.fields.hasLines(0)).toBe(true);
  expect(differences[Math.floor(0.99 * differences.length)]).toBeLessThan(0.01);
  expect(differences.at(-1)).toBeLessThan(0.03);
  expect(together.rays).toBeLessThan(0.4 * alone.rays);
});
