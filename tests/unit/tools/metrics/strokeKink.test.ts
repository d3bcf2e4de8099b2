import { describe, expect, it } from 'vitest';
import { pairedEdges } from '../../../../tools/metrics/measures/pairedEdges.js';
import { strokeKink } from '../../../../tools/metrics/measures/strokeKink.js';

/** Two triangles with the edge from the origin to (0, 1, 0) in common, sloping up by these angles to its left and right. */
function roof(left: number, right: number): number[] {
  // biome-ignore format: one vertex per line
  return [
    0, 0, 0,
    Math.cos(right), 0.5, Math.sin(right),
    0, 1, 0,
    0, 0, 0,
    0, 1, 0,
    -Math.cos(left), 0.5, Math.sin(left),
  ];
}
const kinkOf = (positions: number[], toLight: [number, number, number], normals?: number[]) =>
  strokeKink(positions, pairedEdges(positions, 2), toLight, normals);

describe('strokeKink', () => {
  it('is none on a plane, whatever the light', () => {
    expect(kinkOf(roof(0, 0), [0.3, 0.4, 1]).median).toBeCloseTo(0);
  });

  it('is the turn of the projected light on a roof', () => {
    // On the flat right side B = (1, 1, 0): strokes at 135° to the x axis. The left side rises by 60°, so that it sees of a
    // light from (1, 1, 0) the component cos 60° along its slope and 1 along the edge.
    const left = Math.PI / 3;
    const expected = Math.abs(Math.atan2(1, 1) - Math.atan2(1, Math.cos(left)));
    expect(kinkOf(roof(left, 0), [1, 1, 0]).median).toBeCloseTo((expected * 180) / Math.PI);
  });

  it('is smaller for frames made from common normals', () => {
    const positions = roof(0.3, 0.1);
    const common = Array.from({ length: 6 }, () => [Math.sin(0.1), 0, Math.cos(0.1)]).flat();
    const toLight: [number, number, number] = [1, 0.7, 0.6];
    expect(kinkOf(positions, toLight, common).median).toBeLessThan(0.5 * kinkOf(positions, toLight).median);
  });

  it('counts no turn where strokes only change their head', () => {
    const positions = roof(0, 0);
    // The light passes from one side of the normal to the other between the triangles' own normals.
    const normals = [...Array(3).fill([0.2, 0, 1]), ...Array(3).fill([-0.2, 0, 1])].flat();
    expect(kinkOf(positions, [0, 0, 1], normals).median).toBeCloseTo(0);
  });

  it('leaves out triangles that face the light', () => {
    expect(kinkOf(roof(0, 0), [0, 0, 1]).median).toBeNaN();
  });
});
