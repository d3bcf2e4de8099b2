import { DataTexture, FloatType, RGBAFormat, RGBAIntegerFormat, UnsignedIntType } from 'three';
import type { PackedPull } from '../../mesh/bake/bakePull.js';
import { pullTextureSize } from '../../mesh/bake/pullLayout.js';

/** The textures of a geometry in the `pull` layout (see `pullLayout.ts`). */
export class PulledVertices {
  readonly triangleVertices: DataTexture;
  /** The positions of the vertices in the rest pose. */
  readonly positions: DataTexture;
  /** The base-2 logarithm of the number of texels in a row. */
  readonly rowShift: number;

  constructor({ columns, triangleVertices, vertexPositions }: PackedPull) {
    this.rowShift = Math.log2(columns);
    const triangles = pullTextureSize(triangleVertices.length / 4, columns);
    const vertices = pullTextureSize(vertexPositions.length / 4, columns);
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
