import { type BufferGeometry, Matrix4, type Mesh, Vector3 } from 'three';
import { FAR } from '../mesh/nearFloats.js';

/** The maximum size of a model, and the inverse of the minimum, in single precision. */
const MAX_SIZE = 1e20;

/**
 * A matrix that moves meshes to the origin and scales them to a size of 1; undefined if not needed. Without it, tiny models would collapse
 * to a point, and distant ones would be rounded visibly.
 */
export function nearOrigin(placed: readonly { mesh: Mesh; matrix: Matrix4 }[]): Matrix4 | undefined {
  const low = new Vector3().setScalar(Infinity);
  const high = new Vector3().setScalar(-Infinity);
  const bounds = new Map<BufferGeometry, Vector3[]>();
  const corner = new Vector3();
  for (const { mesh, matrix } of placed) {
    const { geometry } = mesh;
    if (!bounds.has(geometry)) bounds.set(geometry, cornersOf(geometry));
    for (const place of bounds.get(geometry)!) {
      corner.copy(place).applyMatrix4(matrix);
      low.min(corner);
      high.max(corner);
    }
  }
  const centre = low.clone().lerp(high, 0.5);
  const size = high.distanceTo(low);
  const distance = centre.length();
  if (!(size > 0 && size + distance < Infinity)) return undefined;
  if (size < MAX_SIZE && size > 1 / MAX_SIZE && distance < FAR * size) return undefined;
  return new Matrix4().makeScale(1 / size, 1 / size, 1 / size).multiply(new Matrix4().makeTranslation(centre.negate()));
}

/** The corners of the bounding box of all drawn, finite vertices; empty if there are none. */
function cornersOf({ index, attributes: { position } }: BufferGeometry): Vector3[] {
  const low = new Vector3().setScalar(Infinity);
  const high = new Vector3().setScalar(-Infinity);
  const point = new Vector3();
  for (let i = 0; i < (index ?? position).count; i++) {
    point.fromBufferAttribute(position, index ? index.getX(i) : i);
    const sum = point.x + point.y + point.z;
    if (sum - sum !== 0) continue;
    low.min(point);
    high.max(point);
  }
  if (low.x > high.x) return [];
  return Array.from(
    { length: 8 },
    (_, i) => new Vector3(i & 1 ? low.x : high.x, i & 2 ? low.y : high.y, i & 4 ? low.z : high.z),
  );
}
