import { type BufferGeometry, Shape } from 'three';
import type { ModelScene } from '../../viewer/files/gltf/parseGltf.js';
import { box, moved, type Opening, type Parts as PartsOf, rectangle, sceneOf, slab, together } from './solids.js';

/** The materials of a bookshelf: boards, and books in three colours. */
export type ShelfSubstance = 'wood' | 'darkBook' | 'middleBook' | 'lightBook';

const BOOKS = ['darkBook', 'middleBook', 'lightBook'] as const;
const BOARD = 0.035;

/** Size of a bookshelf, and its number of shelves. */
export interface Shelving {
  width: number;
  height: number;
  depth: number;
  shelves: number;
}

/** A bookshelf that stands on y = 0 in front of the plane z = 0, with books of different sizes, some leaning and some lying. */
export function bookshelf({ width, height, depth, shelves }: Shelving): PartsOf<ShelfSubstance> {
  const parts: Record<ShelfSubstance, BufferGeometry[]> = { wood: [], darkBook: [], middleBook: [], lightBook: [] };
  const foot = 0.08;
  const inner = width - 2 * BOARD;
  const room = (height - foot - BOARD) / shelves;
  parts.wood.push(
    ...[-1, 1].map((side) => box(BOARD, height, depth, (side * (width - BOARD)) / 2, 0, depth / 2)),
    box(inner, height, 0.015, 0, 0, 0.0075),
    box(width + 0.06, BOARD, depth + 0.03, 0, height, depth / 2 + 0.01),
    box(inner, foot, 0.02, 0, 0, depth - 0.04),
  );
  const next = chances(7);
  for (let shelf = 0; shelf < shelves; shelf++) {
    const y = foot + shelf * room;
    parts.wood.push(box(inner, BOARD, depth - 0.015, 0, y, depth / 2 + 0.0075));
    let x = -inner / 2 + 0.012;
    const end = inner / 2 - 0.012;
    // Each shelf has its gap at another place.
    const gap = -inner / 2 + inner * (0.3 + 0.5 * next());
    let isPassed = false;
    while (x < end - 0.03) {
      if (!isPassed && x > gap) {
        isPassed = true;
        x += pile(parts, x, y + BOARD, Math.min(0.26, end - x - 0.02), depth, next);
        continue;
      }
      const thick = 0.028 + 0.034 * next();
      const tall = (0.62 + 0.28 * next()) * (room - BOARD);
      const deep = (0.62 + 0.2 * next()) * depth;
      const leans = !isPassed && x + thick > gap;
      const lean = leans ? 0.2 : 0;
      if (x + thick + lean * tall > end) break;
      const book = box(thick, tall, deep, thick / 2, 0, 0);
      if (leans) book.rotateZ(lean).translate(lean * tall, 0, 0);
      parts[BOOKS[Math.floor(3 * next())]].push(book.translate(x, y + BOARD, 0.03 + deep / 2));
      x += thick + 0.004 + lean * tall;
    }
  }
  return parts;
}

/** A pile of lying books, starting at `x`. @returns its width */
function pile(
  parts: Record<ShelfSubstance, BufferGeometry[]>,
  x: number,
  foot: number,
  width: number,
  depth: number,
  next: () => number,
): number {
  let y = foot;
  const count = width < 0.12 ? 0 : 2 + Math.floor(2 * next());
  for (let i = 0; i < count; i++) {
    const thick = 0.03 + 0.02 * next();
    const wide = width * (0.92 - 0.12 * i);
    const deep = depth * (0.75 - 0.05 * i);
    parts[BOOKS[Math.floor(3 * next())]].push(box(wide, thick, deep, x + width / 2, y, 0.03 + deep / 2));
    y += thick + 0.001;
  }
  return width + 0.02;
}

/** A reproducible generator of numbers in [0, 1). */
function chances(seed: number): () => number {
  let state = seed;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
}

const COLOURS = {
  wall: '#efe8d8',
  board: '#cdb892',
  skirting: '#f6f3ea',
  wood: '#8a5f3c',
  darkBook: '#3a2b3a',
  middleBook: '#8d4a36',
  lightBook: '#d9c89a',
  glass: '#b9c4c6',
  rug: '#7d4438',
  paper: '#f8f5ec',
  iron: '#2b2d30',
};

type Substance = keyof typeof COLOURS;
type Parts = PartsOf<Substance>;

/** The size of the room. Its front is open, and the middle of its floor is the origin. */
const WIDTH = 3.4;
const HEIGHT = 2.75;
const DEPTH = 3.9;
const WALL = 0.1;
const LONGEST_EDGE = 0.3;

const WINDOW: Opening = { x: -0.35, y: 0.85, width: 1.1, height: 1.4 };
const DOORWAY: Opening = { x: 0.55, y: 0, width: 0.85, height: 2.05 };

/** An interior: a window, a door, a table with a chair, a bookshelf, a picture and a rug. */
export function makeRoom(): ModelScene {
  const shelf = moved(bookshelf({ width: 1.05, height: 2.05, depth: 0.3, shelves: 5 }), (geometry) =>
    geometry.translate(WIDTH / 2 - 0.62, 0, -DEPTH / 2 + 0.005),
  );
  return sceneOf(
    COLOURS,
    together<Substance>(walls(), floor(), shelf, window(), door(), table(), seat(), picture()),
    LONGEST_EDGE,
  );
}

/** The walls on the left, at the back and on the right, and the ceiling. */
function walls(): Parts {
  const back = slab(
    rectangle(new Shape(), { x: 0, y: 0, width: WIDTH + 2 * WALL, height: HEIGHT }),
    [WINDOW],
    WALL,
  ).translate(0, 0, -DEPTH / 2);
  const left = slab(rectangle(new Shape(), { x: 0, y: 0, width: DEPTH, height: HEIGHT }), [DOORWAY], WALL)
    .rotateY(Math.PI / 2)
    .translate(-WIDTH / 2, 0, 0);
  const right = box(WALL, HEIGHT, DEPTH, (WIDTH + WALL) / 2, 0, 0);
  const skirting = 0.11;
  return {
    wall: [back, left, right, box(WIDTH + 2 * WALL, WALL, DEPTH + WALL, 0, HEIGHT, -WALL / 2)],
    skirting: [
      box(WIDTH - 1.2, skirting, 0.02, -0.6, 0, -DEPTH / 2 + 0.01),
      box(0.02, skirting, DEPTH - 0.04, WIDTH / 2 - 0.01, 0, 0.02),
    ],
  };
}

/** Floorboards that run to the back, and a rug. */
function floor(): Parts {
  const count = 10;
  const each = (WIDTH + 2 * WALL) / count;
  const boards = Array.from({ length: count }, (_, i) =>
    box(each - 0.012, 0.08, DEPTH + WALL, (i - (count - 1) / 2) * each, -0.08, -WALL / 2),
  );
  return { board: boards, rug: [box(1.9, 0.015, 1.35, -0.25, 0, 0.75)] };
}

/** A window with bars and a sill. */
function window(): Parts {
  const { x, y, width, height } = WINDOW;
  const inner = { x, y: y + 0.06, width: width - 0.12, height: height - 0.12 };
  const frame = slab(rectangle(new Shape(), WINDOW), [inner], 0.05).translate(0, 0, -DEPTH / 2 - 0.03);
  return {
    skirting: [
      frame,
      box(0.05, inner.height, 0.035, x, inner.y, -DEPTH / 2 - 0.055),
      ...[0.33, 0.66].map((place) => box(inner.width, 0.03, 0.03, x, y + place * height, -DEPTH / 2 - 0.056)),
      box(width + 0.2, 0.05, 0.16, x, y - 0.05, -DEPTH / 2 + 0.07),
    ],
    glass: [box(inner.width, inner.height, 0.008, x, inner.y, -DEPTH / 2 - 0.085)],
  };
}

/** A door with four panels in the wall on the left. */
function door(): Parts {
  const { x, width, height } = DOORWAY;
  const leaf = box(width - 0.006, height - 0.006, 0.04, x, 0, -0.06);
  const panels = [-1, 1].flatMap((side) =>
    [
      [0.16, 0.66],
      [1, 0.84],
    ].map(([y, tall]) => box(0.26, tall, 0.02, x + side * 0.17, y, -0.035)),
  );
  const jambs = [-1, 1].map((side) => box(0.09, height + 0.07, 0.03, x + side * (width / 2 + 0.03), 0, 0.015));
  const parts: Parts = {
    skirting: [...jambs, box(width + 0.15, 0.09, 0.032, x, height - 0.02, 0.016)],
    wood: [leaf, ...panels],
    iron: [box(0.1, 0.025, 0.04, x - width / 2 + 0.16, 1, -0.02)],
  };
  return moved(parts, (geometry) => geometry.rotateY(Math.PI / 2).translate(-WIDTH / 2, 0, 0));
}

/** A table with a book, a sheet and a cup on it. */
function table(): Parts {
  const [x, z, top] = [-0.45, -0.35, 0.74];
  const legs = [-1, 1].flatMap((i) => [-1, 1].map((k) => box(0.06, top - 0.04, 0.06, x + 0.5 * i, 0, z + 0.28 * k)));
  return {
    wood: [
      ...legs,
      box(1.2, 0.04, 0.74, x, top - 0.04, z),
      ...[-1, 1].map((k) => box(0.94, 0.09, 0.03, x, top - 0.13, z + 0.28 * k)),
      ...[-1, 1].map((i) => box(0.03, 0.09, 0.5, x + 0.5 * i, top - 0.13, z)),
    ],
    darkBook: [
      box(0.24, 0.045, 0.17, 0, 0, 0)
        .rotateY(0.3)
        .translate(x - 0.3, top + 0.001, z - 0.08),
    ],
    lightBook: [
      box(0.2, 0.035, 0.15, 0, 0, 0)
        .rotateY(-0.1)
        .translate(x - 0.3, top + 0.047, z - 0.08),
    ],
    paper: [
      box(0.21, 0.006, 0.29, 0, 0, 0)
        .rotateY(-0.25)
        .translate(x + 0.1, top + 0.001, z + 0.12),
      box(0.08, 0.09, 0.08, x + 0.4, top + 0.001, z - 0.12),
    ],
  };
}

/** A chair with a straight back, turned a little away from the table. */
function seat(): Parts {
  const [half, seatTop] = [0.19, 0.45];
  const parts: Parts = {
    wood: [
      ...[-1, 1].map((i) => box(0.04, seatTop - 0.035, 0.04, i * half, 0, -half)),
      ...[-1, 1].map((i) => box(0.04, 0.95, 0.04, i * half, 0, half)),
      box(0.44, 0.035, 0.4, 0, seatTop - 0.035, -0.01),
      ...[0.62, 0.74, 0.86].map((y) => box(0.34, 0.06, 0.025, 0, y, half)),
      ...[-1, 1].map((i) => box(0.025, 0.03, 0.34, i * half, 0.2, 0)),
      box(0.34, 0.03, 0.025, 0, 0.24, -half),
    ],
  };
  return moved(parts, (geometry) => geometry.rotateY(-0.5).translate(0.05, 0.016, 0.42));
}

/** A picture in its frame on the wall on the right. */
function picture(): Parts {
  const [width, height] = [0.8, 0.6];
  const frame = slab(
    rectangle(new Shape(), { x: 0, y: 0, width, height }),
    [{ x: 0, y: 0.06, width: width - 0.12, height: height - 0.12 }],
    0.04,
  ).translate(0, 0, 0.04);
  const parts: Parts = {
    wood: [frame],
    paper: [box(width - 0.12, height - 0.12, 0.01, 0, 0.06, 0.01)],
    middleBook: [box(0.26, 0.2, 0.006, -0.05, 0.12, 0.019)],
  };
  return moved(parts, (geometry) => geometry.rotateY(-Math.PI / 2).translate(WIDTH / 2, 1.25, 0.2));
}
