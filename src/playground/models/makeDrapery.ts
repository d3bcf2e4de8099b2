import {
  BufferAttribute,
  BufferGeometry,
  Color,
  CylinderGeometry,
  DoubleSide,
  Group,
  LatheGeometry,
  Mesh,
  MeshStandardMaterial,
  SphereGeometry,
  Vector2,
} from 'three';
import type { ModelScene } from '../../viewer/files/gltf/parseGltf.js';

/** Half the side of the cloth, the radius of the table, and the radius of the bend at its edge. */
const HALF = 1.24;
const TABLE = 0.6;
const BEND = 0.1;
/** The number of squares along a side of the cloth. */
const SQUARES = 88;
const FOLDS = 10;
/** Start and end of the band along the hem, as shares of half the side. */
const BAND = [0.82, 0.92] as const;

const LINEN = '#f1ebdd';
const BLUE = '#2a3a5e';

/** A square white tablecloth with a dark band over a round table, with a jug and two fruits on it. */
export function makeDrapery(): ModelScene {
  const root = new Group();
  const add = (name: string, geometry: BufferGeometry, material: MeshStandardMaterial): void => {
    const mesh = new Mesh(geometry, material);
    mesh.name = name;
    root.add(mesh);
  };
  const coloured = (color: string) => new MeshStandardMaterial({ color });
  add('cloth', cloth(), new MeshStandardMaterial({ vertexColors: true, side: DoubleSide }));
  add(
    'table',
    new CylinderGeometry(TABLE - 0.01, TABLE - 0.01, 0.06, 64, 1).translate(0, -0.04, 0),
    coloured('#6e4a30'),
  );
  add('foot', foot(), coloured('#6e4a30'));
  add('jug', jug().translate(-0.16, 0.012, -0.1), coloured('#a9583a'));
  add('plum', fruit(0.105).translate(0.2, 0.1, 0.12), coloured('#3b2036'));
  add('lemon', fruit(0.1).scale(1.25, 0.95, 0.95).rotateY(0.7).translate(0.02, 0.1, 0.28), coloured('#ead58a'));
  return { root, animations: [] };
}

/** The cloth as a square grid; points beyond the edge of the table hang down in folds. */
function cloth(): BufferGeometry {
  const count = (SQUARES + 1) ** 2;
  const positions = new Float32Array(3 * count);
  const colors = new Float32Array(3 * count);
  const [linen, blue] = [new Color(LINEN), new Color(BLUE)];
  const indices: number[] = [];
  for (let row = 0; row <= SQUARES; row++) {
    for (let column = 0; column <= SQUARES; column++) {
      const vertex = row * (SQUARES + 1) + column;
      const [u, v] = [(2 * column) / SQUARES - 1, (2 * row) / SQUARES - 1];
      positions.set(draped(HALF * u, HALF * v), 3 * vertex);
      const place = Math.max(Math.abs(u), Math.abs(v));
      (place > BAND[0] && place < BAND[1] ? blue : linen).toArray(colors, 3 * vertex);
      if (row === SQUARES || column === SQUARES) continue;
      const next = vertex + SQUARES + 1;
      indices.push(vertex, next, vertex + 1, vertex + 1, next, next + 1);
    }
  }
  const geometry = new BufferGeometry().setIndex(indices);
  geometry.setAttribute('position', new BufferAttribute(positions, 3));
  geometry.setAttribute('color', new BufferAttribute(colors, 3));
  geometry.computeVertexNormals();
  return geometry;
}

/** The position of the cloth's point x, z. The top of the table is y = 0. */
function draped(x: number, z: number): [x: number, y: number, z: number] {
  const far = Math.hypot(x, z);
  const beyond = far - TABLE;
  if (beyond <= 0) return [x, 0, z];
  const angle = Math.atan2(z, x);
  const bend = Math.min(beyond / BEND, Math.PI / 2);
  const hanging = Math.max(beyond - (BEND * Math.PI) / 2, 0);
  // A ring of cloth is longer than the table's edge by as much as it lies beyond it; folds of this depth take that up.
  const depth = ((2.6 * TABLE) / FOLDS) * Math.sqrt(hanging / TABLE);
  const fold = Math.cos(FOLDS * angle) * (0.75 + 0.25 * Math.sin(3 * angle + 1)) + 0.22 * Math.cos(15 * angle + 2);
  const out = TABLE + BEND * Math.sin(bend) + depth * (0.75 + 0.75 * fold) + 0.1 * hanging;
  // Gathers the cloth where it stands out, so that folds are round and the valleys between them narrow.
  const turned = angle - ((0.35 * depth) / TABLE) * Math.sin(FOLDS * angle);
  const drop = BEND * (1 - Math.cos(bend)) + 0.95 * hanging;
  return [out * Math.cos(turned), -drop, out * Math.sin(turned)];
}

/** A turned column on three steps. */
function foot(): BufferGeometry {
  const outline = [
    [0.001, -1.2],
    [0.42, -1.2],
    [0.42, -1.14],
    [0.36, -1.1],
    [0.14, -1.04],
    [0.1, -0.9],
    [0.1, -0.07],
  ] as const;
  return new LatheGeometry(
    outline.map(([x, y]) => new Vector2(x, y)),
    48,
  );
}

/** An open jug with a wall. */
function jug(): BufferGeometry {
  const outer = [
    [0.001, 0],
    [0.13, 0],
    [0.19, 0.08],
    [0.22, 0.2],
    [0.19, 0.32],
    [0.11, 0.43],
    [0.1, 0.5],
    [0.14, 0.56],
  ] as const;
  const inner = [
    [0.12, 0.56],
    [0.08, 0.5],
    [0.09, 0.42],
    [0.17, 0.3],
    [0.001, 0.1],
  ] as const;
  return new LatheGeometry(
    [...outer, ...inner].map(([x, y]) => new Vector2(x, y)),
    40,
  );
}

const fruit = (radius: number): BufferGeometry => new SphereGeometry(radius, 32, 20);
