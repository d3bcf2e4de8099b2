import { type BufferGeometry, ExtrudeGeometry } from 'three';
import type { ModelScene } from '../../viewer/files/gltf/parseGltf.js';
import {
  box,
  facets,
  moved,
  type Opening,
  type Parts as PartsOf,
  type Point,
  polygon,
  sceneOf,
  slab,
  solid,
  together,
} from './solids.js';

const COLOURS = {
  lightPlaster: '#efe6d2',
  plaster: '#d9c7a6',
  brick: '#a8694f',
  roof: '#6d3a2c',
  frame: '#f6f3ea',
  glass: '#27323a',
  door: '#4c2f25',
  shutter: '#4d6b5a',
  kerb: '#d8d3c7',
  road: '#c3bcae',
  iron: '#26282b',
};

type Substance = keyof typeof COLOURS;
type Parts = PartsOf<Substance>;

/** Half the width of the carriageway, the width of each pavement, and the depth of the houses. */
const ROAD = 2.1;
const PAVEMENT = 0.85;
const DEPTH = 1.05;
const FRONT = ROAD + PAVEMENT;
const PAVEMENT_HEIGHT = 0.1;
const WALL = 0.12;
const STOREY = 1.35;

/** A house: its width, number of storeys, gable towards the street, and materials. */
interface House {
  width: number;
  storeys: number;
  gabled: boolean;
  walls: 'lightPlaster' | 'plaster' | 'brick';
  shutters?: boolean;
  /** The bay with the door; the other bays of the ground floor have windows. */
  door: number;
}

const LEFT: readonly House[] = [
  { width: 2.6, storeys: 3, gabled: true, walls: 'lightPlaster', door: 1, shutters: true },
  { width: 3.3, storeys: 2, gabled: false, walls: 'brick', door: 0 },
  { width: 2.4, storeys: 3, gabled: true, walls: 'plaster', door: 1 },
  { width: 3.2, storeys: 3, gabled: false, walls: 'lightPlaster', door: 2, shutters: true },
  { width: 2.6, storeys: 2, gabled: true, walls: 'brick', door: 0 },
  { width: 3.3, storeys: 2, gabled: false, walls: 'plaster', door: 1 },
  { width: 2.5, storeys: 3, gabled: true, walls: 'lightPlaster', door: 0 },
  { width: 3, storeys: 3, gabled: false, walls: 'brick', door: 1 },
  { width: 2.5, storeys: 2, gabled: true, walls: 'plaster', door: 0 },
  { width: 3.1, storeys: 2, gabled: false, walls: 'lightPlaster', door: 2 },
];
const RIGHT: readonly House[] = [
  { width: 3.3, storeys: 2, gabled: false, walls: 'plaster', door: 1, shutters: true },
  { width: 2.5, storeys: 3, gabled: true, walls: 'brick', door: 0 },
  { width: 3, storeys: 3, gabled: false, walls: 'lightPlaster', door: 1 },
  { width: 2.6, storeys: 2, gabled: true, walls: 'plaster', door: 1, shutters: true },
  { width: 3.3, storeys: 2, gabled: false, walls: 'lightPlaster', door: 0 },
  { width: 2.4, storeys: 3, gabled: true, walls: 'brick', door: 1 },
  { width: 3, storeys: 2, gabled: false, walls: 'plaster', door: 2 },
  { width: 2.8, storeys: 3, gabled: true, walls: 'lightPlaster', door: 0 },
  { width: 3.2, storeys: 2, gabled: false, walls: 'brick', door: 0 },
  { width: 2.4, storeys: 3, gabled: true, walls: 'plaster', door: 1 },
];
const LENGTH = LEFT.reduce((sum, { width }) => sum + width, 0);

/** A street between two rows of old houses, from z = 0 to the horizon along −z. */
export function makeStreet(): ModelScene {
  return sceneOf(
    COLOURS,
    together<Substance>(
      ground(),
      church(),
      ...[-1, 1].map(endWall),
      row(LEFT, (geometry, along) => geometry.rotateY(Math.PI / 2).translate(-FRONT, PAVEMENT_HEIGHT, -along)),
      row(RIGHT, (geometry, along) => geometry.rotateY(-Math.PI / 2).translate(FRONT, PAVEMENT_HEIGHT, -along)),
      ...[3, 10, 17].flatMap((along) => [lamp(-ROAD - 0.16, -along, 1), lamp(ROAD + 0.16, -along - 3.5, -1)]),
    ),
  );
}

/** A row of houses. @param place turns a house to the street and moves its middle there */
function row(houses: readonly House[], place: (geometry: BufferGeometry, along: number) => BufferGeometry): Parts {
  let along = 0;
  const parts = houses.map((house) => {
    const middle = along + house.width / 2;
    along += house.width;
    return moved(houseOf(house), (geometry) => place(geometry, middle));
  });
  return together<Substance>(...parts);
}

function ground(): Parts {
  const width = 2 * (FRONT + DEPTH);
  const flags = 1.2;
  const count = Math.round(LENGTH / flags);
  const kerbs = [-1, 1].flatMap((side) =>
    Array.from({ length: count }, (_, i) =>
      box(
        PAVEMENT,
        PAVEMENT_HEIGHT,
        LENGTH / count - 0.012,
        side * (ROAD + PAVEMENT / 2),
        0,
        (-(i + 0.5) * LENGTH) / count,
      ),
    ),
  );
  return { road: [box(width, 0.15, LENGTH, 0, -0.15, -LENGTH / 2)], kerb: kerbs };
}

/** A house whose front is z = 0 and whose foot is y = 0, with its middle at x = 0. */
function houseOf({ width, storeys, gabled, walls, shutters, door }: House): Parts {
  const bays = width > 2.7 ? 3 : 2;
  const eaves = storeys * STOREY + 0.15;
  const middleOf = (bay: number) => ((bay + 0.5) / bays - 0.5) * (width - 0.3);
  const doorway: Opening = { x: middleOf(door), y: 0.1, width: 0.6, height: 1.08 };
  const openings: Opening[] = [];
  for (let storey = 0; storey < storeys; storey++) {
    for (let bay = 0; bay < bays; bay++) {
      if (storey > 0 || bay !== door) {
        openings.push({ x: middleOf(bay), y: storey * STOREY + 0.42, width: 0.46, height: storey === 0 ? 0.76 : 0.72 });
      }
    }
  }
  const half = width / 2 - 0.015;
  const rise = gabled ? width * 0.52 : 0.95;
  const front = gabled
    ? polygon([
        [-half, 0],
        [half, 0],
        [half, eaves],
        [0, eaves + rise],
        [-half, eaves],
      ])
    : polygon([
        [-half, 0],
        [half, 0],
        [half, eaves],
        [-half, eaves],
      ]);
  const attic: Opening[] = gabled ? [{ x: 0, y: eaves + 0.1, width: 0.36, height: 0.46 }] : [];
  return together<Substance>(
    {
      [walls]: [
        slab(front, [doorway, ...openings, ...attic], WALL),
        box(2 * half, eaves, DEPTH - WALL, 0, 0, -WALL - (DEPTH - WALL) / 2),
      ],
    },
    gabled ? steepRoof(half, eaves, rise) : longRoof(half, eaves, rise),
    doorOf(doorway),
    ...openings.map((opening) => windowOf(opening, shutters === true)),
    ...attic.map((opening) => windowOf(opening, false)),
    { kerb: [box(2 * half, 0.07, 0.05, 0, STOREY + 0.12, 0.025)] },
  );
}

/** The windows in the end wall of the first house. @param side of the street, −1 for the left */
function endWall(side: number): Parts {
  const { storeys } = side < 0 ? LEFT[0] : RIGHT[0];
  const windows = Array.from({ length: storeys }, (_, storey) =>
    windowOf({ x: 0, y: PAVEMENT_HEIGHT + storey * STOREY + 0.42, width: 0.46, height: 0.72 }, false),
  );
  // The panes are in front of the wall.
  return moved(together<Substance>(...windows), (geometry) =>
    geometry.translate(side * (FRONT + DEPTH / 2 + 0.06), 0, WALL - 0.015),
  );
}

/** A church tower with a pointed roof, behind the houses on the left. */
function church(): Parts {
  const [x, z, half, height] = [-FRONT - 1.1, -LENGTH - 1.4, 0.95, 8];
  const corners: Point[] = [
    [x - half - 0.1, height, z - half - 0.1],
    [x + half + 0.1, height, z - half - 0.1],
    [x + half + 0.1, height, z + half + 0.1],
    [x - half - 0.1, height, z + half + 0.1],
    [x, height + 4, z],
  ];
  const faces = [
    [0, 1, 4],
    [1, 2, 4],
    [2, 3, 4],
    [3, 0, 4],
    [0, 1, 2, 3],
  ];
  const opening = (turn: number) =>
    box(0.5, 1.1, 0.06, 0, height - 1.7, half)
      .rotateY(turn)
      .translate(x, 0, z);
  return {
    plaster: [box(2 * half, height, 2 * half, x, 0, z)],
    roof: [facets(corners, faces, [x, height + 1, z])],
    kerb: [box(2 * half + 0.1, 0.12, 2 * half + 0.1, x, height - 2.2, z)],
    glass: [0, Math.PI / 2].map(opening),
  };
}

/** A roof whose gable faces the street. */
function steepRoof(half: number, eaves: number, rise: number): Parts {
  const over = 0.12;
  const slope = rise / half;
  const profile = polygon([
    [-half - over, eaves - over * slope],
    [0, eaves + rise],
    [half + over, eaves - over * slope],
    [half + over, eaves - over * slope + 0.13],
    [0, eaves + rise + 0.15],
    [-half - over, eaves - over * slope + 0.13],
  ]);
  const depth = DEPTH + 0.16;
  const roof = solid(new ExtrudeGeometry(profile, { depth, bevelEnabled: false })).translate(0, 0, -DEPTH);
  return { roof: [roof], brick: [box(0.34, 0.75, 0.34, 0.45 * half, eaves + 0.55 * rise, -1)] };
}

/** A roof whose ridge runs along the street. */
function longRoof(half: number, eaves: number, rise: number): Parts {
  const over = 0.2;
  const profile = polygon([
    [over, eaves - 0.05],
    [over, eaves + 0.08],
    [-DEPTH / 2, eaves + rise],
    [-DEPTH, eaves],
  ]);
  const roof = solid(new ExtrudeGeometry(profile, { depth: 2 * half, bevelEnabled: false }))
    .translate(0, 0, -half)
    .rotateY(-Math.PI / 2);
  return { roof: [roof], brick: [box(0.5, 0.8, 0.34, -half + 0.35, eaves + rise - 0.35, -DEPTH / 2)] };
}

/** A frame with a cross of bars, dark panes and a sill. */
function windowOf({ x, y, width, height }: Opening, shutters: boolean): Parts {
  const edge = 0.045;
  return {
    glass: [box(width, height, 0.01, x, y, -WALL + 0.01)],
    frame: [
      ...[-1, 0, 1].map((side) => box(edge, height, 0.03, x + side * (width - edge) * 0.5, y, -0.07)),
      ...[0, 0.6, 1].map((share) => box(width, edge, 0.028, x, y + share * (height - edge), -0.07)),
      box(width + 0.14, 0.05, 0.09, x, y - 0.05, 0.03),
    ],
    shutter: shutters
      ? [-1, 1].map((side) => box(0.23, height + 0.02, 0.035, x + side * (width / 2 + 0.125), y - 0.01, 0.02))
      : [],
  };
}

/** A door with two panels in a stone frame, above a step. */
function doorOf({ x, y, width, height }: Opening): Parts {
  return {
    door: [
      box(width, height, 0.03, x, y, -0.08),
      ...[0.12, 0.58].map((place) => box(width * 0.6, 0.36, 0.02, x, y + place, -0.055)),
    ],
    kerb: [
      ...[-1, 1].map((side) => box(0.09, height + 0.09, 0.05, x + side * (width / 2 + 0.045), y, 0.02)),
      box(width + 0.24, 0.1, 0.09, x, y + height + 0.09, 0.03),
      box(width + 0.2, 0.1, 0.28, x, 0, 0.14),
    ],
  };
}

/** A lantern on a post. @param side direction of its arm along x */
function lamp(x: number, z: number, side: number): Parts {
  const top = 2.7;
  return {
    iron: [
      box(0.16, 0.22, 0.16, x, PAVEMENT_HEIGHT, z),
      box(0.07, top, 0.07, x, PAVEMENT_HEIGHT + 0.22, z),
      box(0.4, 0.05, 0.05, x + 0.17 * side, top + 0.2, z),
      box(0.3, 0.06, 0.3, x + 0.34 * side, top + 0.14, z),
      box(0.2, 0.04, 0.2, x + 0.34 * side, top - 0.22, z),
    ],
    frame: [box(0.22, 0.32, 0.22, x + 0.34 * side, top - 0.18, z)],
  };
}
