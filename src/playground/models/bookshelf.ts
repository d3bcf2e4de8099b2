import type { BufferGeometry } from 'three';
import { box, type Parts } from './solids.js';

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
export function bookshelf({ width, height, depth, shelves }: Shelving): Parts<ShelfSubstance> {
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
