import { describe, expect, it } from 'vitest';
import { pairedEdges } from '../../../../tools/metrics/measures/pairedEdges.js';

/*  3───2
 *  │ ╱ │   triangles 0 1 2 and 0 2 3, corners numbered along
 *  0───1
 */
const points = [
  [0, 0, 0],
  [1, 0, 0],
  [1, 1, 0],
  [0, 1, 0],
];
const soup = (...indices: number[]) => indices.flatMap((i) => [...points[i]]);

describe('pairedEdges', () => {
  it('names the common edge by the corners of both triangles, ends in the same order', () => {
    // Corner 2 (point 2) to corner 0 (point 0); the twin runs from corner 3 (point 0) to corner 4 (point 2).
    expect([...pairedEdges(soup(0, 1, 2, 0, 2, 3), 1)]).toEqual([2, 0, 4, 3]);
  });

  it('leaves out creases, borders, and windings that contradict', () => {
    const folded = soup(0, 1, 2, 0, 2, 3);
    folded.splice(15, 3, 0.5, 0.5, 1);
    expect(pairedEdges(folded, 0.5)).toHaveLength(0);
    expect(pairedEdges(folded, 3)).toHaveLength(4);
    expect(pairedEdges(soup(0, 1, 2), 3)).toHaveLength(0);
    expect(pairedEdges(soup(0, 1, 2, 2, 0, 3), 3)).toHaveLength(0);
  });

  it('leaves out an edge of three triangles', () => {
    expect(pairedEdges(soup(0, 1, 2, 0, 2, 3, 0, 2, 1), 3)).toHaveLength(0);
  });
});
