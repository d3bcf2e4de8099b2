import {
  BoxGeometry,
  Float32BufferAttribute,
  Group,
  type Material,
  Mesh,
  MeshPhysicalMaterial,
  type MeshPhysicalMaterialParameters,
  MeshStandardMaterial,
  PlaneGeometry,
  Texture,
} from 'three';
import { expect, test } from 'vitest';
import { mergeScene } from '../../../../../src/viewer/files/scenes/mergeScene.js';
import { resolveAlpha } from '../../../../../src/viewer/files/scenes/resolveAlpha.js';
import { measure } from '../../../../../tools/modelFiles/modelWriters.js';

const map = new Texture({ url: 'leaf.png', width: 1, height: 1 });
const solid = (): Mesh => new Mesh(new BoxGeometry(), new MeshStandardMaterial());

function kindOf({ visible, transparent, alphaTest, depthWrite }: Material): string {
  if (!visible) return 'not there';
  expect(depthWrite).toBe(!transparent);
  if (transparent) return 'glass';
  return alphaTest > 0 ? `cut out below ${alphaTest}` : 'opaque';
}

test.each<[MeshPhysicalMaterialParameters, string]>([
  [{ opacity: 0.25 }, 'opaque'],
  [{ transparent: true, opacity: 1 }, 'opaque'],
  [{ transparent: true, opacity: 0.99, depthWrite: false }, 'opaque'],
  [{ transparent: true, opacity: 0.25 }, 'glass'],
  [{ transparent: true, opacity: 0.9, map }, 'glass'],
  [{ transparent: true, opacity: 0 }, 'not there'],
  [{ transparent: true, map, depthWrite: false }, 'cut out below 0.5'],
  [{ transparent: true, map: new Texture() }, 'opaque'],
  [{ alphaTest: 0.3, map }, 'cut out below 0.3'],
  [{ alphaTest: 0.3, opacity: 0.6, map }, 'cut out below 0.5'],
  [{ alphaTest: 0.5, opacity: 0.4, map }, 'not there'],
  [{ alphaTest: 0.5, opacity: 0.4 }, 'not there'],
  [{ alphaTest: 0.5, opacity: 0.6 }, 'opaque'],
  [{ transmission: 1 }, 'glass'],
])('a surface with %o is %s', (parameters, kind) => {
  const material = new MeshPhysicalMaterial(parameters);
  const root = new Group().add(solid(), new Mesh(new BoxGeometry(), material));
  for (let times = 0; times < 2; times++) {
    resolveAlpha(root);
    expect(kindOf(material)).toBe(kind);
  }
});

test.each([
  [[0.3, 0.3, 0.3, 0.3], 'glass', 2],
  [[1, 1, 1, 1], 'opaque', 2],
  [[0, 0, 0, 0], 'not there', 0],
  // One of the two triangles is not there.
  [[1, 0, 1, 0], 'glass', 2],
  [[0, 0, 0, 1], 'glass', 1],
])('vertices of alpha %j make a surface that is %s', (alphas, kind, triangles) => {
  const pane = new Mesh(new PlaneGeometry(), new MeshStandardMaterial({ transparent: true, vertexColors: true }));
  pane.geometry.setAttribute(
    'color',
    new Float32BufferAttribute(
      alphas.flatMap((alpha) => [1, 1, 1, alpha]),
      4,
    ),
  );
  resolveAlpha(new Group().add(solid(), pane));
  expect(kindOf(pane.material)).toBe(kind);
  expect(pane.geometry.index!.count / 3).toBe(triangles);
});

test('vertex alpha splits one mesh into opaque, see-through and invisible parts', () => {
  const geometry = new PlaneGeometry(3, 1, 3, 1).toNonIndexed();
  const alphas = [1, 0.3, 0].flatMap((alpha) => Array<number>(6).fill(alpha));
  const colors = alphas.flatMap((alpha) => [1, 1, 1, alpha]);
  geometry.setAttribute('color', new Float32BufferAttribute(colors, 4));
  const squares = new Mesh(geometry, new MeshStandardMaterial({ transparent: true, vertexColors: true }));
  const root = new Group().add(squares);
  for (let times = 0; times < 2; times++) {
    resolveAlpha(root);
    const materials = squares.material as unknown as MeshStandardMaterial[];
    expect(materials.map(kindOf)).toEqual(['opaque', 'glass']);
    expect(squares.geometry.groups.map(({ start, count }) => [start, count])).toEqual([
      [0, 6],
      [6, 6],
    ]);
  }
  expect(geometry.index).toBe(null);
  expect(mergeScene(root).ranges).toEqual([
    { start: 0, count: 6, picture: -1 },
    { start: 6, count: 6, picture: -1, isSeeThrough: true },
  ]);
});

test('where nothing would be seen all is opaque, and a note says so', () => {
  const material = new MeshStandardMaterial({ transparent: true, opacity: 0 });
  const note = ['invisible in the file, drawn as opaque'];
  expect(resolveAlpha(new Group().add(new Mesh(new BoxGeometry(), material)))).toEqual(note);
  expect(kindOf(material)).toBe('opaque');
  const notes: string[] = [];
  const clear = new Mesh(new BoxGeometry(), new MeshStandardMaterial({ transparent: true, opacity: 0 }));
  mergeScene(new Group().add(clear), undefined, undefined, notes);
  expect(notes).toEqual(note);
  expect(resolveAlpha(new Group().add(solid()))).toEqual([]);
});

test('in a merged scene, glass has its own ranges, and invisible parts are ignored', () => {
  const glass = new MeshStandardMaterial({ transparent: true, opacity: 0.3 });
  const nothing = new MeshStandardMaterial({ transparent: true, opacity: 0 });
  const root = new Group().add(
    new Mesh(new BoxGeometry(3, 3, 3), glass),
    solid(),
    new Mesh(new BoxGeometry(9, 9, 9), nothing),
  );
  const mesh = mergeScene(root);
  expect(mesh.ranges).toEqual([
    { start: 0, count: 36, picture: -1 },
    { start: 36, count: 36, picture: -1, isSeeThrough: true },
  ]);
  expect(measure({ mesh } as Parameters<typeof measure>[0]).volume).toBeCloseTo(28);
  expect(mergeScene(new Group().add(solid())).ranges).toBeUndefined();
});
