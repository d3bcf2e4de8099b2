import { type Camera, type Mesh, Vector3, type Vector4 } from 'three';

const centre = /* @__PURE__ */ new Vector3();
const forward = /* @__PURE__ */ new Vector3();

/**
 * How many pixels a unit of a mesh's object space covers where the mesh is nearest to the camera. Tiles of a large picture count as parts
 * of it, since the projection of a camera with a view offset is that of its tile.
 *
 * @param viewport in pixels, of which the last two numbers are its width and height
 */
export function pixelsPerUnit({ geometry, matrixWorld }: Mesh, camera: Camera, viewport: Vector4): number {
  const sphere = geometry.boundingSphere!;
  const scale = matrixWorld.getMaxScaleOnAxis();
  const { elements } = camera.projectionMatrix;
  const pixels = (scale / 2) * Math.max(Math.abs(elements[0]) * viewport.z, Math.abs(elements[5]) * viewport.w);
  if (elements[15] === 1) return pixels;
  centre.copy(sphere.center).applyMatrix4(matrixWorld);
  centre.sub(forward.setFromMatrixPosition(camera.matrixWorld));
  const depth = -centre.dot(forward.setFromMatrixColumn(camera.matrixWorld, 2).normalize());
  const { near = 0 } = camera as Camera & { near?: number };
  return pixels / Math.max(depth - scale * sphere.radius, near, Number.MIN_VALUE);
}
