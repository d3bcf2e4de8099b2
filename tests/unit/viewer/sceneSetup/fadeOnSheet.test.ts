import {
  BoxGeometry,
  type BufferGeometry,
  Group,
  type Material,
  Mesh,
  MeshBasicMaterial,
  OrthographicCamera,
  PerspectiveCamera,
  TorusKnotGeometry,
  Vector3,
} from 'three';
import { describe, expect, test } from 'vitest';
import { fitCamera } from '../../../../src/viewer/sceneSetup/framing.js';
import {
  castersOf,
  fadeOnSheet,
  type GroundLight,
  type SheetPart,
  shadowOnGround,
} from '../../../../src/viewer/sceneSetup/groundShadow.js';

/** The width that the camera of a shadow sees. */
const WIDTH = 2.1;
/** How fast it dissolves anyway. */
const LEAST_FADE = 0.65;

/** A box from one corner to the opposite one, of twelve triangles. */
function box(low: readonly number[], high: readonly number[], material: Material = new MeshBasicMaterial()): Mesh {
  const size = low.map((value, i) => high[i] - value);
  const mesh = new Mesh(new BoxGeometry(...size), material);
  mesh.position.fromArray(low.map((value, i) => value + size[i] / 2));
  return mesh;
}

/** Stands on −0.9 at its lowest, as all of them do. */
const MODELS = {
  'a street lamp': new Group().add(
    box([-0.2, -0.9, -0.2], [0.2, -0.8, 0.2]),
    box([-0.02, -0.8, -0.02], [0.02, 0.9, 0.02]),
    box([0, 0.86, -0.02], [0.4, 0.9, 0.02]),
    box([0.34, 0.5, -0.06], [0.46, 0.75, 0.06]),
  ),
  'a wide chest': new Group().add(box([-0.8, -0.9, -0.4], [0.8, -0.4, 0.4])),
  'a thin leaning board': new Group().add(box([-0.5, -0.9, -0.01], [0.5, 0.9, 0.01])),
  'a knot of many triangles': new Group().add(new Mesh(new TorusKnotGeometry(0.5, 0.1, 160, 8))),
};
MODELS['a thin leaning board'].rotation.x = 0.3;

/** Shapes of the picture, the part of it that is the sheet, and the share of that which the model fills. */
const SHEETS: readonly (readonly [string, aspect: number, part: SheetPart, fill: number])[] = [
  ['a phone', 390 / 844, [1, 1], 0.9],
  ['A5', 148 / 210, [1, 1], 0.92],
  ['a wide page', 1.9, [1, 1], 0.76],
  ['a sheet on a wide page', 1.6, [0.42, 0.9], 0.86],
];

function lightAt(azimuth: number, elevation: number, isSun: boolean): GroundLight {
  const [around, up] = [azimuth, elevation].map((degrees) => (degrees * Math.PI) / 180);
  const position = new Vector3(Math.sin(around) * Math.cos(up), Math.sin(up), Math.cos(around) * Math.cos(up));
  if (!isSun) position.multiplyScalar(1.6);
  return { position, isSun, widthAt: (place) => (isSun ? WIDTH : 1.5 * place.distanceTo(position)) };
}

/** Points all over the triangles of a model, in the world. */
function surfaceOf(root: Group): Vector3[] {
  root.updateWorldMatrix(true, true);
  return (root.children as Mesh<BufferGeometry>[]).flatMap(({ geometry, matrixWorld }) => {
    const { index, attributes } = geometry;
    const corner = (i: number): Vector3 =>
      new Vector3().fromBufferAttribute(attributes.position, index!.getX(i)).applyMatrix4(matrixWorld);
    const points: Vector3[] = [];
    for (let i = 0; i < index!.count; i += 3) {
      const [a, b, c] = [corner(i), corner(i + 1), corner(i + 2)];
      const parts = Math.ceil(Math.max(a.distanceTo(b), b.distanceTo(c), c.distanceTo(a)) / 0.03);
      for (let k = 0; k <= parts; k++)
        for (let l = 0; k + l <= parts; l++)
          points.push(
            a
              .clone()
              .addScaledVector(b.clone().sub(a), k / parts)
              .addScaledVector(c.clone().sub(a), l / parts),
          );
    }
    return points;
  });
}

/** How far a place is on the way from the middle of the sheet to its edges. */
function reachOf(place: Vector3, camera: PerspectiveCamera | OrthographicCamera, [wide, high]: SheetPart): number {
  if (place.clone().applyMatrix4(camera.matrixWorldInverse).z >= 0) return Infinity;
  const { x, y } = place.clone().project(camera);
  return Math.max(Math.abs(x) / wide, Math.abs(y) / high);
}

/** Of a shadow, the largest share that is left of it at the edges of the sheet and beyond, and how far it reaches on it. */
function shadowAtEdges(
  surface: readonly Vector3[],
  ground: number,
  light: GroundLight,
  camera: PerspectiveCamera | OrthographicCamera,
  part: SheetPart,
  fade: number,
): { left: number; reach: number } {
  let [left, most] = [0, 0];
  for (const point of surface) {
    const way = light.isSun ? light.position.clone().negate() : point.clone().sub(light.position);
    if (way.y >= 0) continue;
    const cast = point.clone().addScaledVector(way, (ground - point.y) / way.y);
    const reach = reachOf(cast, camera, part);
    most = Math.max(most, reach);
    if (reach >= 1)
      left = Math.max(left, 1 - (Math.max(fade, LEAST_FADE) * cast.distanceTo(point)) / light.widthAt(cast));
  }
  return { left, reach: most };
}

function camerasFor(surface: readonly Vector3[], aspect: number, part: SheetPart, fill: number) {
  const perspective = new PerspectiveCamera(26, aspect, 0.05, 100);
  const positions = surface.flatMap((point) => point.toArray());
  fitCamera(perspective, positions, new Vector3(0.62, 0.36, 1), { part, fill });
  const half = (1.2 * Math.max(1, 1 / (aspect * part[0]))) / part[1];
  const orthographic = new OrthographicCamera(-half * aspect, half * aspect, half, -half, 0.05, 100);
  orthographic.position.set(2, 3, 8);
  orthographic.lookAt(0, 0, 0);
  for (const camera of [perspective, orthographic]) camera.updateMatrixWorld();
  return { perspective, orthographic };
}

describe.each(Object.entries(MODELS))('the shadow of %s', (model, root) => {
  const tags = model === 'a street lamp' ? [] : ['all'];
  const surface = surfaceOf(root);
  const casters = castersOf(root);
  const ground = surface.reduce((low, { y }) => Math.min(low, y), Infinity);

  test.each(SHEETS)(
    'has ended at every edge of %s, from wherever the light comes',
    { tags },
    (_sheet, aspect, part, fill) => {
      const faults: string[] = [];
      let cut = 0;
      for (const [lens, camera] of Object.entries(camerasFor(surface, aspect, part, fill)))
        for (const isSun of [true, false])
          for (let azimuth = 0; azimuth < 360; azimuth += 45)
            for (const elevation of [3, 12, 25, 45]) {
              const light = lightAt(azimuth, elevation, isSun);
              const fade = fadeOnSheet(casters, ground, light, camera, part);
              const { left, reach } = shadowAtEdges(surface, ground, light, camera, part, fade);
              if (reach > 1) cut++;
              if (!(left < 0.005))
                faults.push(`${lens}, ${isSun ? 'a sun' : 'a lamp'} at ${azimuth} and ${elevation}: ${left}`);
              if (reach < 0.65 && fade > 0) faults.push(`${lens}, ${azimuth} and ${elevation}: ends before ${reach}`);
            }
      expect(faults).toEqual([]);
      expect(cut).toBeGreaterThan(20);
    },
  );
});

const LAMP = MODELS['a street lamp'];

test('a slowly sinking light changes it slowly', () => {
  const surface = surfaceOf(LAMP);
  const casters = castersOf(LAMP);
  for (const [, aspect, part, fill] of SHEETS) {
    const { perspective } = camerasFor(surface, aspect, part, fill);
    const fades = Array.from({ length: 320 }, (_, i) =>
      fadeOnSheet(casters, -0.9, lightAt(90, 81 - i / 4, true), perspective, part),
    );
    expect(Math.max(...fades)).toBeGreaterThan(LEAST_FADE);
    for (const [i, fade] of fades.slice(1).entries()) expect(Math.abs(fade - fades[i])).toBeLessThan(0.4 + 0.2 * fade);
  }
});

test('if an edge cuts the model, it cuts the shadow too; the transition is continuous', () => {
  const surface = surfaceOf(LAMP);
  const casters = castersOf(LAMP);
  const { perspective } = camerasFor(surface, 1, [1, 1], 0.8);
  const light = lightAt(90, 8, true);
  const fades = Array.from({ length: 40 }, (_, i) => {
    perspective.zoom = 1 + i / 20;
    perspective.updateProjectionMatrix();
    return fadeOnSheet(casters, -0.9, light, perspective, [1, 1]);
  });
  expect(fades[0]).toBeGreaterThan(1);
  expect(fades.at(-1)).toBe(0);
  for (const [i, fade] of fades.slice(1).entries()) expect(Math.abs(fade - fades[i])).toBeLessThan(5);
});

test('all tiles of a picture have the same shadow', () => {
  const { perspective } = camerasFor(surfaceOf(LAMP), 1, [1, 1], 0.8);
  const fadeSeen = (): number => fadeOnSheet(castersOf(LAMP), -0.9, lightAt(90, 8, true), perspective, [1, 1]);
  const whole = fadeSeen();
  perspective.setViewOffset(400, 400, 0, 0, 100, 100);
  expect(fadeSeen()).toBe(whole);
});

test('a shadow that runs to the horizon fades before the edge of the sheet, and one framed with its model hardly fades early', () => {
  const level = new PerspectiveCamera(60, 1);
  level.position.set(0, 0, 6);
  level.updateMatrixWorld();
  expect(fadeOnSheet(castersOf(LAMP), -0.9, lightAt(0, 10, true), level, [1, 1])).toBe(0);
  const surface = surfaceOf(LAMP);
  const { perspective } = camerasFor(surface, 1.2, [1, 1], 0.8);
  const light = lightAt(-60, 40, true);
  const shadow = shadowOnGround(
    surface.flatMap((point) => point.toArray()),
    light.position,
    true,
    -0.9,
  );
  fitCamera(
    perspective,
    surface.flatMap((point) => point.toArray()),
    new Vector3(0.62, 0.36, 1),
    {
      fill: 0.95,
      shadow,
      room: { model: 0.95, shadow: 0.95, smaller: 3 },
    },
  );
  expect(shadowAtEdges(surface, -0.9, light, perspective, [1, 1], 0).reach).toBeGreaterThan(0.85);
  expect(fadeOnSheet(castersOf(LAMP), -0.9, light, perspective, [1, 1])).toBeLessThan(1.2 * LEAST_FADE);
});

test('there is no fading without casters, or with a light from below', () => {
  const { perspective } = camerasFor(surfaceOf(LAMP), 1, [1, 1], 0.8);
  expect(fadeOnSheet([], -0.9, lightAt(90, 8, true), perspective, [1, 1])).toBe(0);
  for (const isSun of [true, false])
    expect(fadeOnSheet(castersOf(LAMP), -0.9, lightAt(90, -50, isSun), perspective, [1, 1])).toBe(0);
});
