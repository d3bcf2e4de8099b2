import { type BufferGeometry, FrontSide, type Material, type Mesh, Vector3 } from 'three';

/** The greatest number of triangles of a mesh that are read; in larger meshes each stands for its neighbours. */
const MOST_TRIANGLES = 4096;
/** The share of its box that a model must enclose from within to be a room. */
const ENCLOSED = 0.1;

/**
 * Lets the walls of a room of one-sided surfaces cast shadows with the side that is seen, so that a ceiling and walls that are not
 * drawn since they are seen from behind do not darken the room. Everything else casts as in three.js.
 */
export function castAsSeen(meshes: readonly Mesh[]): void {
  const materials = meshes.flatMap(({ material }) => material as Material | Material[]);
  const oneSided = materials.filter(({ side }) => side === FrontSide);
  if (oneSided.length === 0 || !isRoom(meshes)) return;
  for (const material of oneSided) material.shadowSide = FrontSide;
}

/** Whether the one-sided surfaces of meshes that face inward enclose more than those that face outward. */
function isRoom(meshes: readonly Mesh[]): boolean {
  let volume = 0;
  const low = new Vector3(Infinity, Infinity, Infinity);
  const high = low.clone().negate();
  const corners = [new Vector3(), new Vector3(), new Vector3()];
  const middle = new Vector3();
  const normal = new Vector3();
  // The sum of tetrahedra to the origin, about which a model is centred, is the volume, negative if faces look inward.
  for (const { geometry, material, matrixWorld } of meshes) {
    const isOneSided = [material].flat().every(({ side }) => side === FrontSide);
    if (!isOneSided || !geometry.attributes.position) continue;
    const [a, b, c] = corners;
    const sign = Math.sign(matrixWorld.determinant());
    const count = triangleCount(geometry);
    const step = Math.max(1, Math.ceil(count / MOST_TRIANGLES));
    for (let triangle = 0; triangle < count; triangle += step) {
      for (let k = 0; k < 3; k++) {
        const vertex = geometry.index ? geometry.index.getX(3 * triangle + k) : 3 * triangle + k;
        corners[k].fromBufferAttribute(geometry.attributes.position, vertex).applyMatrix4(matrixWorld);
        low.min(corners[k]);
        high.max(corners[k]);
      }
      middle.copy(a);
      normal.crossVectors(b.sub(a), c.sub(a));
      volume += (sign * step * middle.dot(normal)) / 6;
    }
  }
  const { x, y, z } = high.sub(low);
  return -volume > ENCLOSED * x * y * z;
}

const triangleCount = ({ index, attributes }: BufferGeometry): number =>
  Math.floor((index ?? attributes.position).count / 3);
