import { type BufferGeometry, DataTexture, FloatType, RGBAFormat, RGBAIntegerFormat, UnsignedIntType } from 'three';
import type { PackedPull } from '../bake/packPull.js';
import { pullTextureSize } from '../bake/pullLayout.js';
import type { HatchingStatistics } from './HatchingStatistics.js';

/** The textures that the corners of a geometry of the `pull` layout read (`pullLayout`). */
export class PulledVertices {
  readonly triangleVertices: DataTexture;
  /** In the rest pose. */
  readonly positions: DataTexture;

  constructor({ triangleVertices, vertexPositions }: PackedPull) {
    const triangles = pullTextureSize(triangleVertices.length / 4);
    const vertices = pullTextureSize(vertexPositions.length / 4);
    this.triangleVertices = new DataTexture(
      triangleVertices,
      triangles.width,
      triangles.height,
      RGBAIntegerFormat,
      UnsignedIntType,
    );
    this.positions = new DataTexture(vertexPositions, vertices.width, vertices.height, RGBAFormat, FloatType);
    this.triangleVertices.needsUpdate = true;
    this.positions.needsUpdate = true;
  }

  dispose(): void {
    this.triangleVertices.dispose();
    this.positions.dispose();
  }
}

/** By the statistics, which a copy of the geometry shares. */
const pulledVertices = new WeakMap<HatchingStatistics, PulledVertices>();

export const pulledVerticesOf = ({ userData }: BufferGeometry): PulledVertices | undefined =>
  pulledVertices.get(userData.hatching);

/** Makes the textures those of the geometry and of its copies. They leave the graphics card when it is disposed of. */
export function setPulledVertices(geometry: BufferGeometry, vertices: PulledVertices): void {
  pulledVertices.set(geometry.userData.hatching, vertices);
  geometry.addEventListener('dispose', () => vertices.dispose());
}
