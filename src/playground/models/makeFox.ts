import type { ModelScene } from '../../viewer/files/gltf/parseGltf.js';
import { facets, type Parts as PartsOf, type Point, sceneOf, together } from './solids.js';

const COLOURS = {
  fur: '#c8713a',
  white: '#f7f1e4',
  dark: '#3a2a24',
};

type Substance = keyof typeof COLOURS;
type Parts = PartsOf<Substance>;
type Faces = Partial<Record<Substance, readonly (readonly number[])[]>>;

/** A sitting fox of few flat triangles, symmetric about x = 0. It looks along z. */
export function makeFox(): ModelScene {
  const parts = [torso(), ...both(frontLeg), ...both(haunch), head(), ...both(ear), ...both(eye), tail()];
  return sceneOf(COLOURS, together<Substance>(...parts));
}

/** A part on the right, x > 0, and its mirror image on the left. */
const both = (part: (side: number) => Parts): Parts[] => [part(1), part(-1)];

function part(corners: readonly Point[], faces: Faces, inside: Point): Parts {
  const entries = Object.entries(faces) as [Substance, readonly (readonly number[])[]][];
  return Object.fromEntries(entries.map(([substance, some]) => [substance, [facets(corners, some, inside)]])) as Parts;
}

/** The corners of a ring of six: front, right in front, right behind, back, left behind, left in front. */
const ring = (front: Point, fore: Point, hind: Point, back: Point): Point[] => [
  front,
  fore,
  hind,
  back,
  mirrored(hind),
  mirrored(fore),
];

const mirrored = ([x, y, z]: Point): Point => [-x, y, z];

function torso(): Parts {
  const corners = [
    ...ring([0, 0, 0.06], [0.2, 0, 0.02], [0.25, 0, -0.36], [0, 0, -0.5]),
    ...ring([0, 0.34, 0.2], [0.2, 0.34, 0.1], [0.25, 0.34, -0.34], [0, 0.36, -0.5]),
    ...ring([0, 0.74, 0.35], [0.2, 0.72, 0.2], [0.18, 0.78, -0.14], [0, 0.82, -0.27]),
    ...ring([0, 1.18, 0.25], [0.12, 1.18, 0.16], [0.11, 1.22, -0.02], [0, 1.24, -0.08]),
  ];
  const white: number[][] = [];
  const fur: number[][] = [];
  for (let band = 0; band < 3; band++) {
    for (let i = 0; i < 6; i++) {
      const a = 6 * band + i;
      const b = 6 * band + ((i + 1) % 6);
      // Quads are split symmetrically on both halves of the body.
      const halves =
        i < 3
          ? [
              [a, b, b + 6],
              [a, b + 6, a + 6],
            ]
          : [
              [b, a, a + 6],
              [b, a + 6, b + 6],
            ];
      (i === 0 || i === 5 ? white : fur).push(...halves);
    }
  }
  return part(corners, { white, fur }, [0, 0.5, -0.08]);
}

function frontLeg(side: number): Parts {
  const at = (x: number, y: number, z: number): Point => [side * x, y, z];
  const corners = [
    // At the chest, the middle and the ankle: outside in front, inside in front, behind.
    ...[at(0.17, 0.68, 0.2), at(0.05, 0.66, 0.29), at(0.15, 0.62, 0.06)],
    ...[at(0.18, 0.28, 0.27), at(0.06, 0.28, 0.29), at(0.14, 0.28, 0.14)],
    ...[at(0.17, 0, 0.26), at(0.07, 0, 0.28), at(0.13, 0, 0.17)],
  ];
  const band = (from: number): number[][] => [
    [from, from + 1, from + 4, from + 3],
    [from + 1, from + 2, from + 5, from + 4],
    [from + 2, from, from + 3, from + 5],
  ];
  return together<Substance>(
    part(corners, { fur: band(0), dark: band(3) }, at(0.12, 0.3, 0.21)),
    paw(at, [0.05, 0.19], [0.2, 0.4], 0.1),
  );
}

/** A wedge on the ground. @param across, along its extents on x and z @param height at its rear end */
function paw(
  at: (x: number, y: number, z: number) => Point,
  across: readonly [number, number],
  along: readonly [number, number],
  height: number,
): Parts {
  const [[left, right], [back, front]] = [across, along];
  const corners = [
    at(left + 0.02, height, back),
    at(right - 0.02, height, back),
    at(right, 0, front),
    at(left, 0, front),
    at(left, 0, back),
    at(right, 0, back),
  ];
  const faces = [
    [0, 1, 2, 3],
    [1, 5, 2],
    [0, 3, 4],
  ];
  return part(corners, { dark: faces }, at((left + right) / 2, 0.2 * height, back + 0.3 * (front - back)));
}

function haunch(side: number): Parts {
  const at = (x: number, y: number, z: number): Point => [side * x, y, z];
  const corners = [
    at(0.2, 0.54, -0.18),
    at(0.22, 0.34, 0.17),
    at(0.27, 0, 0.16),
    at(0.28, 0, -0.4),
    at(0.2, 0.3, -0.47),
    at(0.38, 0.24, -0.08),
  ];
  const faces = [0, 1, 2, 3, 4].map((i) => [5, i, (i + 1) % 5]);
  return together<Substance>(
    part(corners, { fur: faces }, at(0.2, 0.22, -0.12)),
    paw(at, [0.2, 0.37], [0.02, 0.34], 0.13),
  );
}

/** The head, from the nape to the tip of the nose. */
function head(): Parts {
  const half: Point[] = [
    [0, 1.5, 0.14],
    [0, 1.36, -0.1],
    [0, 1.42, 0.33],
    [0, 1.27, 0.47],
    [0, 1.2, 0.7],
    [0, 1.12, 0.66],
    [0, 1.04, 0.28],
    [0.19, 1.44, 0.12],
    [0.33, 1.18, 0.1],
    [0.16, 1.22, -0.1],
    [0.12, 1.32, 0.37],
    [0.06, 1.2, 0.64],
    [0.11, 1.1, 0.4],
  ];
  const corners = [...half, ...half.slice(7).map(mirrored)];
  const left = (corner: number) => (corner < 7 ? corner : corner + 6);
  const twice = (faces: number[][]) => [...faces, ...faces.map((face) => face.map(left))];
  return part(
    corners,
    {
      fur: twice([
        [0, 7, 2],
        [2, 7, 10],
        [7, 8, 10],
        [2, 10, 3],
        [0, 1, 7],
        [1, 9, 7],
        [9, 8, 7],
        [3, 10, 11],
        [3, 11, 4],
      ]),
      white: twice([
        [10, 8, 12],
        [10, 12, 11],
        [12, 8, 6],
        [12, 6, 5],
        [11, 12, 5],
        [9, 6, 8],
        [1, 6, 9],
      ]),
      dark: twice([[4, 11, 5]]),
    },
    [0, 1.25, 0.2],
  );
}

function ear(side: number): Parts {
  const at = (x: number, y: number, z: number): Point => [side * x, y, z];
  const corners = [at(0.03, 1.49, 0.15), at(0.26, 1.36, 0.1), at(0.14, 1.42, -0.04), at(0.23, 1.78, 0.03)];
  const faces: Faces = {
    fur: [
      [1, 2, 3],
      [0, 2, 3],
    ],
    dark: [[0, 1, 3]],
  };
  return part(corners, faces, at(0.15, 1.5, 0.05));
}

/** An eye, just in front of the fold of the cheek. */
function eye(side: number): Parts {
  const at = (x: number, y: number, z: number): Point => [side * x, y, z];
  return part(
    [at(0.132, 1.339, 0.338), at(0.156, 1.377, 0.261), at(0.175, 1.332, 0.26)],
    { dark: [[0, 1, 2]] },
    at(0, 1.3, 0.1),
  );
}

/** The tail, around the right side, with a white tip. */
function tail(): Parts {
  const rings: Point[][] = [
    square([0.05, 0.12, -0.46], 0.07, 0.2),
    square([0.36, 0.17, -0.5], 0.15, 0.9),
    square([0.58, 0.17, -0.16], 0.15, 1.9),
    square([0.56, 0.13, 0.16], 0.11, 1.75),
  ];
  const tip: Point = [0.42, 0.08, 0.46];
  const corners = [...rings.flat(), tip];
  const band = (from: number): number[][] =>
    [0, 1, 2, 3].flatMap((i) => {
      const [a, b] = [4 * from + i, 4 * from + ((i + 1) % 4)];
      return [
        [a, b, b + 4],
        [a, b + 4, a + 4],
      ];
    });
  const end = corners.length - 1;
  return together<Substance>(
    part(corners, { fur: band(0) }, [0.2, 0.14, -0.48]),
    part(corners, { fur: band(1) }, [0.47, 0.17, -0.33]),
    part(corners, { fur: band(2) }, [0.57, 0.15, 0]),
    part(corners, { white: [0, 1, 2, 3].map((i) => [12 + i, 12 + ((i + 1) % 4), end]) }, [0.53, 0.12, 0.2]),
  );
}

/** Four corners around a place: above, outside, below, inside. @param turn direction of the outside, from −z towards x */
function square([x, y, z]: Point, radius: number, turn: number): Point[] {
  const [side, along] = [radius * Math.sin(turn), -radius * Math.cos(turn)];
  return [
    [x, y + radius, z],
    [x + side, y, z + along],
    [x, Math.max(0, y - radius), z],
    [x - side, y, z - along],
  ];
}
