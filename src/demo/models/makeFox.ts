import type { ModelScene } from '../../files/gltf/parseGltf.js';
import { facets, type Parts as PartsOf, type Point, sceneOf, together } from './solids.js';

const COLOURS = {
  fur: '#c8713a',
  white: '#f7f1e4',
  dark: '#3a2a24',
};

type Substance = keyof typeof COLOURS;
type Parts = PartsOf<Substance>;
type Faces = Partial<Record<Substance, readonly (readonly number[])[]>>;

/** A fox that sits, of few flat triangles. It looks along z; its left half mirrors its right one. */
export function makeFox(): ModelScene {
  const parts = [torso(), ...both(frontLeg), ...both(haunch), head(), ...both(ear), tail()];
  return sceneOf(COLOURS, together<Substance>(...parts));
}

/** A part on the right, x > 0, and its mirror on the left. */
const both = (part: (side: number) => Parts): Parts[] => [part(1), part(-1)];

function part(corners: readonly Point[], faces: Faces, inside: Point): Parts {
  const entries = Object.entries(faces) as [Substance, readonly (readonly number[])[]][];
  return Object.fromEntries(entries.map(([substance, some]) => [substance, [facets(corners, some, inside)]])) as Parts;
}

/** Corners of a ring of six: front, right in front, right behind, back, left behind, left in front. */
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
    ...ring([0, 0.72, 0.33], [0.18, 0.7, 0.2], [0.17, 0.76, -0.14], [0, 0.8, -0.28]),
    ...ring([0, 1.02, 0.26], [0.13, 1.02, 0.17], [0.12, 1.08, -0.02], [0, 1.1, -0.08]),
  ];
  const white: number[][] = [];
  const fur: number[][] = [];
  for (let band = 0; band < 3; band++) {
    for (let i = 0; i < 6; i++) {
      const a = 6 * band + i;
      const b = 6 * band + ((i + 1) % 6);
      // Quads are split so that both halves of the body mirror each other.
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
    // Above, at the middle and at the ankle: outside in front, inside in front, behind.
    ...[at(0.2, 0.6, 0.27), at(0.05, 0.58, 0.32), at(0.16, 0.58, 0.08)],
    ...[at(0.17, 0.26, 0.28), at(0.06, 0.26, 0.29), at(0.13, 0.26, 0.15)],
    ...[at(0.16, 0.07, 0.27), at(0.06, 0.07, 0.28), at(0.12, 0.07, 0.16)],
    // The paw: its corners on the ground.
    ...[at(0.18, 0, 0.38), at(0.05, 0, 0.38), at(0.17, 0, 0.15), at(0.06, 0, 0.15)],
  ];
  return part(
    corners,
    {
      fur: [
        [0, 1, 4],
        [0, 4, 3],
        [1, 2, 5],
        [1, 5, 4],
        [2, 0, 3],
        [2, 3, 5],
      ],
      dark: [
        [3, 4, 7],
        [3, 7, 6],
        [4, 5, 8],
        [4, 8, 7],
        [5, 3, 6],
        [5, 6, 8],
        [6, 7, 10, 9],
        [6, 9, 11],
        [6, 11, 8],
        [7, 12, 10],
        [7, 8, 12],
        [8, 11, 12],
      ],
    },
    at(0.12, 0.3, 0.21),
  );
}

function haunch(side: number): Parts {
  const at = (x: number, y: number, z: number): Point => [side * x, y, z];
  const corners = [
    at(0.22, 0.5, -0.2),
    at(0.24, 0.3, 0.16),
    at(0.24, 0.02, 0.12),
    at(0.26, 0, -0.4),
    at(0.22, 0.3, -0.46),
    at(0.37, 0.22, -0.1),
    // The hind paw.
    at(0.34, 0.1, 0.14),
    at(0.36, 0, 0.3),
    at(0.22, 0, 0.3),
    at(0.37, 0, -0.05),
    at(0.22, 0.1, 0.14),
  ];
  return together<Substance>(
    part(
      corners,
      {
        fur: [
          [5, 0, 1],
          [5, 1, 2],
          [5, 2, 3],
          [5, 3, 4],
          [5, 4, 0],
        ],
      },
      at(0.2, 0.22, -0.12),
    ),
    part(
      corners,
      {
        dark: [
          [6, 7, 8, 10],
          [6, 9, 7],
          [6, 10, 9],
        ],
      },
      at(0.29, 0.03, 0.12),
    ),
  );
}

/** The head: from the nape to the tip of the nose. */
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
    [0.29, 1.2, 0.14],
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
  const corners = [at(0.05, 1.48, 0.16), at(0.22, 1.38, 0.14), at(0.14, 1.42, 0.02), at(0.2, 1.82, 0.06)];
  return part(
    corners,
    {
      fur: [
        [1, 2, 3],
        [0, 2, 3],
      ],
      dark: [[0, 1, 3]],
    },
    at(0.14, 1.5, 0.07),
  );
}

/** The tail lies around the right side and ends in a white tip. */
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

/** Four corners around a place: above, outside, below, inside. @param turn where its outside lies, from −z towards x */
function square([x, y, z]: Point, radius: number, turn: number): Point[] {
  const [side, along] = [radius * Math.sin(turn), -radius * Math.cos(turn)];
  return [
    [x, y + radius, z],
    [x + side, y, z + along],
    [x, Math.max(0, y - radius), z],
    [x - side, y, z - along],
  ];
}
