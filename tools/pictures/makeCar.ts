import { type BufferGeometry, CylinderGeometry } from 'three';
import { box, facets, type Point, sceneOf, solid } from '../../src/playground/models/solids.js';
import type { ModelScene } from '../../src/viewer/files/gltf/parseGltf.js';

const COLOURS = { panel: '#d9c9a6', glass: '#26323c', tyre: '#222222', metal: '#c9c9c4', lamp: '#f7f1e0' };

/** Half the width of the body, and where the axles are along x: the car looks along x. */
const HALF = 0.8;
const AXLES = [-1.25, 1.3] as const;
const WHEEL = 0.36;

/** A car of flat panels on wheels of twelve sides. */
export function makeCar(): ModelScene {
  const wheels = AXLES.flatMap((x) => [-1, 1].map((side) => wheel(x, side)));
  return sceneOf(COLOURS, {
    panel: [body(), cabin().posts],
    glass: cabin().panes,
    tyre: wheels.map(({ tyre }) => tyre),
    metal: [
      ...wheels.map(({ hub }) => hub),
      box(0.12, 0.14, 1.5, 2.2, 0.36, 0),
      box(0.12, 0.14, 1.5, -2.17, 0.36, 0),
      box(0.04, 0.18, 0.8, 2.16, 0.58, 0),
      ...[-1, 1].map((side) => box(0.16, 0.03, 0.03, -0.25, 0.82, side * (HALF + 0.01))),
    ],
    lamp: [-1, 1].map((side) => box(0.05, 0.14, 0.24, 2.14, 0.62, side * 0.58)),
  });
}

/** The outline of the body from the side, from the rear bumper over the roof line to the front and back below. */
const SIDE: readonly (readonly [x: number, y: number])[] = [
  [-2.15, 0.32],
  [-2.15, 0.72],
  [-2.05, 0.92],
  [-1.2, 0.98],
  [0.85, 0.95],
  [1.95, 0.82],
  [2.15, 0.7],
  [2.15, 0.32],
];

/** Panels are folded along the waist, which stands out from the upper and the lower edge. */
function body(): BufferGeometry {
  const waist = 0.62;
  const corners: Point[] = [];
  for (const side of [-1, 1]) {
    for (const [x, y] of SIDE) corners.push([x, y, side * (y < waist ? HALF - 0.06 : HALF - 0.1)]);
    corners.push([-2.18, waist, side * HALF], [2.18, waist, side * HALF]);
  }
  const count = SIDE.length + 2;
  const [rear, fore] = [SIDE.length, SIDE.length + 1];
  const flank = (from: number) => [
    [0, 7, fore, rear].map((corner) => corner + from),
    [rear, fore, 6, 5, 4, 3, 2, 1].map((corner) => corner + from),
  ];
  const around = [0, rear, 1, 2, 3, 4, 5, 6, fore, 7].map((corner, i, all) => [
    corner,
    all[(i + 1) % all.length],
    all[(i + 1) % all.length] + count,
    corner + count,
  ]);
  return facets(corners, [...flank(0), ...flank(count), ...around], [0, 0.6, 0]);
}

/** The part with the windows: posts and roof of sheet, and panes that lie a little before them. */
function cabin(): { posts: BufferGeometry; panes: BufferGeometry[] } {
  const [low, high] = [0.95, 1.48];
  const [base, top] = [HALF - 0.12, HALF - 0.26];
  const corners: Point[] = [-1, 1].flatMap((side): Point[] => [
    [-1.6, low, side * base],
    [0.95, low, side * base],
    [0.2, high, side * top],
    [-1.2, high, side * top],
  ]);
  const inside: Point = [-0.4, 1.2, 0];
  const faces = [
    [0, 1, 2, 3],
    [4, 5, 6, 7],
    [1, 5, 6, 2],
    [3, 2, 6, 7],
    [0, 3, 7, 4],
  ];
  const pane = (face: readonly Point[], from: number, to: number, out: Point): BufferGeometry => {
    const [a, b, c, d] = face;
    const at = (u: number, v: number): Point =>
      [0, 1, 2].map((axis) => {
        const [lower, upper] = [a[axis] + u * (b[axis] - a[axis]), d[axis] + u * (c[axis] - d[axis])];
        return lower + v * (upper - lower) + out[axis];
      }) as unknown as Point;
    return facets([at(from, 0.12), at(to, 0.12), at(to, 0.88), at(from, 0.88)], [[0, 1, 2, 3]], inside);
  };
  const face = (...indices: number[]) => indices.map((corner) => corners[corner]);
  return {
    posts: facets(corners, faces, inside),
    panes: [
      ...[0, 4].flatMap((from) =>
        [
          [0.06, 0.44],
          [0.5, 0.92],
        ].map(([start, end]) =>
          pane(face(from, from + 1, from + 2, from + 3), start, end, [0, 0.002, from === 0 ? -0.008 : 0.008]),
        ),
      ),
      pane(face(1, 5, 6, 2), 0.07, 0.93, [0.008, 0.006, 0]),
      pane(face(0, 4, 7, 3), 0.07, 0.93, [-0.008, 0.006, 0]),
    ],
  };
}

function wheel(x: number, side: number): { tyre: BufferGeometry; hub: BufferGeometry } {
  const round = (radius: number, width: number, sides: number, z: number) => {
    const cylinder = solid(new CylinderGeometry(radius, radius, width, sides))
      .rotateX(Math.PI / 2)
      .translate(x, WHEEL, z);
    cylinder.computeVertexNormals();
    return cylinder;
  };
  return {
    tyre: round(WHEEL, 0.24, 12, side * (HALF - 0.06)),
    hub: round(0.2, 0.05, 6, side * (HALF + 0.075)),
  };
}
