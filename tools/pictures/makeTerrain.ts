import { type BufferGeometry, Group, Mesh, MeshStandardMaterial, PlaneGeometry } from 'three';
import { solid } from '../../src/playground/models/solids.js';

/** Squares along a side of the terrain, and their length. */
const SQUARES = 14;
const SQUARE = 1;

/** Hills and a peak of large flat triangles. */
export function makeTerrain(): Group {
  const plane = new PlaneGeometry(SQUARES * SQUARE, SQUARES * SQUARE, SQUARES, SQUARES).rotateX(-Math.PI / 2);
  const { position } = plane.attributes;
  for (let i = 0; i < position.count; i++) {
    const [column, row] = [i % (SQUARES + 1), Math.floor(i / (SQUARES + 1))];
    // Corners of the lattice are moved aside, so that no two triangles are alike.
    const x = position.getX(i) + 0.32 * (spread(column, row, 1) - 0.5);
    const z = position.getZ(i) + 0.32 * (spread(column, row, 2) - 0.5);
    position.setXYZ(i, x, heightAt(x, z) + 0.55 * spread(column, row, 3), z);
  }
  const geometry: BufferGeometry = solid(plane);
  geometry.computeVertexNormals();
  return new Group().add(new Mesh(geometry, new MeshStandardMaterial({ color: '#ffffff' })));
}

const hill = (x: number, z: number, height: number, width: number): number =>
  height * Math.exp(-(x * x + z * z) / (width * width));

const heightAt = (x: number, z: number): number =>
  hill(x + 1.2, z + 3, 3.6, 2.2) + hill(x - 3.2, z + 2.2, 2.2, 1.8) + hill(x + 4.6, z + 0.5, 1.8, 2);

/** A number in [0, 1) for a corner of the lattice, always the same. */
function spread(column: number, row: number, kind: number): number {
  const value = Math.sin(12.9898 * column + 78.233 * row + 37.719 * kind) * 43758.5453;
  return value - Math.floor(value);
}
