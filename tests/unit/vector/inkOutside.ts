import { type Camera, type Mesh, type Object3D, Vector3 } from 'three';
import { pathsOf, ringsOf } from './paths.js';

/** A square sheet without margins, filled by the picture of a camera with aspect 1. Millimetres. */
export interface SquareSheet {
  side: number;
  /** Greatest distance of ink from a silhouette. */
  reach: number;
}

/** Pixels per millimetre. */
const FINENESS = 8;

/** A bitmap, 1 where something is. */
class Raster {
  readonly pixels: Uint8Array;

  constructor(readonly size: number) {
    this.pixels = new Uint8Array(size * size);
  }

  /** Fills rings by the rule `nonzero`, sampled at pixel centres. Coordinates in pixels. */
  fill(rings: readonly (readonly number[])[]): void {
    const { size, pixels } = this;
    const crossings = new Map<number, [number, number][]>();
    for (const ring of rings) {
      for (let i = 0; i < ring.length; i += 2) {
        const next = (i + 2) % ring.length;
        const [x0, y0, x1, y1] = [ring[i], ring[i + 1], ring[next], ring[next + 1]];
        const [low, high] = [Math.min(y0, y1), Math.max(y0, y1)];
        for (let row = Math.max(Math.ceil(low - 0.5), 0); row + 0.5 < high && row < size; row++) {
          const x = x0 + ((row + 0.5 - y0) / (y1 - y0)) * (x1 - x0);
          const found = crossings.get(row);
          if (found) found.push([x, y0 < y1 ? 1 : -1]);
          else crossings.set(row, [[x, y0 < y1 ? 1 : -1]]);
        }
      }
    }
    for (const [row, list] of crossings) {
      list.sort((a, b) => a[0] - b[0]);
      let winding = 0;
      for (const [i, [x, turn]] of list.entries()) {
        winding += turn;
        if (winding === 0 || i + 1 === list.length) continue;
        const from = Math.max(Math.ceil(x - 0.5), 0);
        const to = Math.min(Math.ceil(list[i + 1][0] - 0.5), size);
        if (to > from) pixels.fill(1, row * size + from, row * size + to);
      }
    }
  }

  /** All pixels within a distance of a filled one, in pixels. */
  grown(reach: number): Raster {
    const { size, pixels } = this;
    const grown = new Raster(size);
    for (let y = 0; y < size; y++) {
      for (let x = 0; x < size; x++) {
        if (pixels[y * size + x] === 0) continue;
        // Pixels inside a filled area are within reach of those at its rim.
        const isInner =
          x > 0 &&
          y > 0 &&
          x + 1 < size &&
          y + 1 < size &&
          pixels[y * size + x - 1] +
            pixels[y * size + x + 1] +
            pixels[(y - 1) * size + x] +
            pixels[(y + 1) * size + x] ===
            4;
        if (isInner) {
          grown.pixels[y * size + x] = 1;
          continue;
        }
        for (let dy = -Math.floor(reach); dy <= reach; dy++) {
          const across = Math.floor(Math.sqrt(reach * reach - dy * dy));
          const row = y + dy;
          if (row < 0 || row >= size) continue;
          grown.pixels.fill(1, row * size + Math.max(x - across, 0), row * size + Math.min(x + across + 1, size));
        }
      }
    }
    return grown;
  }
}

/** The silhouettes of meshes as a camera sees them. */
function silhouettes(scene: Object3D, camera: Camera, size: number): Raster {
  const raster = new Raster(size);
  const corner = new Vector3();
  scene.updateMatrixWorld();
  camera.updateMatrixWorld();
  scene.traverse((object) => {
    const mesh = object as Mesh;
    if (!mesh.isMesh || 'isHatchingOutlines' in mesh) return;
    const { position } = mesh.geometry.attributes;
    const { index } = mesh.geometry;
    const at = (i: number): number[] => {
      corner
        .fromBufferAttribute(position, index ? index.getX(i) : i)
        .applyMatrix4(mesh.matrixWorld)
        .project(camera);
      return [0.5 * (1 + corner.x) * size, 0.5 * (1 - corner.y) * size];
    };
    const count = index ? index.count : position.count;
    for (let i = 0; i < count; i += 3) raster.fill([[...at(i), ...at(i + 1), ...at(i + 2)]]);
  });
  return raster;
}

/** The share of the ink of some layers that lies farther outside of silhouettes than it may. */
export function inkOutside(
  svg: string,
  layers: RegExp,
  scene: Object3D,
  camera: Camera,
  { side, reach }: SquareSheet,
): number {
  const size = side * FINENESS;
  const ink = new Raster(size);
  for (const data of pathsOf(svg, layers)) ink.fill(ringsOf(data).map((ring) => ring.map((value) => value * FINENESS)));
  // A margin of one pixel, since a triangle between pixel centres fills none.
  const inside = silhouettes(scene, camera, size).grown(reach * FINENESS + 1);
  let [all, outside] = [0, 0];
  for (const [i, isInk] of ink.pixels.entries()) {
    all += isInk;
    outside += isInk * (1 - inside.pixels[i]);
  }
  return outside / Math.max(all, 1);
}
