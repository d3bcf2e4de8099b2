import type { BufferGeometry, Mesh, WebGLRenderer } from 'three';
import { identityOf } from '../geometry/identityOf.js';
import type { PulledVertices } from '../geometry/PulledVertices.js';
import { Deformation } from './Deformation.js';

/** Per `renderer.properties`: three.js makes a new one when a lost context is restored. Then by the identity of the mesh. */
const deformations = new WeakMap<object, WeakMap<object, Deformation>>();
/** Frees a deformation when its mesh is garbage-collected: meshes have no `dispose()`. */
const disposeWithMesh = /* @__PURE__ */ new FinalizationRegistry<Deformation>((deformation) => deformation.dispose());

/**
 * The deformation of a mesh on the renderer's graphics context, made on first use. Meshes that share a geometry have one each.
 *
 * @param vertices the textures of the `pull` layout; null: the geometry has an index, and its vertices are deformed
 */
export function deformationOf(
  renderer: WebGLRenderer,
  mesh: Mesh,
  geometry: BufferGeometry,
  vertices: PulledVertices | null,
): Deformation {
  let ofContext = deformations.get(renderer.properties);
  if (!ofContext) {
    ofContext = new WeakMap();
    deformations.set(renderer.properties, ofContext);
  }
  const identity = identityOf(mesh);
  const known = ofContext.get(identity);
  if (known && !known.isDisposed && known.isOf(geometry)) return known;
  if (known) {
    known.dispose();
    disposeWithMesh.unregister(known);
  }
  const deformation = new Deformation(renderer, geometry, vertices);
  ofContext.set(identity, deformation);
  disposeWithMesh.register(identity, deformation, deformation);
  return deformation;
}
