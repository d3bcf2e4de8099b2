import type { BufferGeometry, Mesh } from 'three';
import { USDLoader } from 'three/addons/loaders/USDLoader.js';
import { hiddenChange } from '../common/fileChanges.js';
import { replace, withFakeDocument } from './fakeDocument.js';
import { DISPLACEMENT_NOTE, type LoadedScene, sceneOf } from './LoadedScene.js';
import { repairFans } from './repairFans.js';

const SIGNATURE = '#usda';

/**
 * Reads a USD file: text, binary or package (USDZ).
 *
 * @param showsHidden whether invisible prims are shown
 * @throws Error of the loader
 */
export async function readUsd(bytes: Uint8Array, name: string, showsHidden = false): Promise<LoadedScene> {
  const notes = new Set<string>();
  const hidden = { isShown: showsHidden, meshes: 0 };
  const prototype = await composerPrototype();
  // Nothing is awaited while the composer is patched, so that two files that are read at once do not undo each other's patch.
  const restore = prototype ? patchUsd(prototype, notes, hidden) : () => {};
  try {
    const isText = new TextDecoder('latin1').decode(bytes.subarray(0, SIGNATURE.length)) === SIGNATURE;
    const content = isText ? plainUsda(new TextDecoder().decode(bytes)) : bytes.slice().buffer;
    const root = withFakeDocument(() => new USDLoader().parse(content));
    if (root) repairFans(root);
    return { ...sceneOf(root, name), notes: [...notes], changes: hiddenChange(hidden.meshes) };
  } finally {
    restore();
  }
}

/** The prototype of three's USD composer; null in versions of three.js without this module. */
async function composerPrototype(): Promise<UsdComposer | null> {
  try {
    const { USDComposer } = await import('three/addons/loaders/usd/USDComposer.js');
    return USDComposer.prototype as UsdComposer;
  } catch {
    return null;
  }
}

/** A spec of a USD layer: a prim, or a property of one. */
interface Spec {
  specType: number;
  fields?: {
    typeName?: string;
    default?: unknown;
    active?: boolean;
    connectionPaths?: string[];
    references?: unknown[];
  };
}

type Specs = Record<string, Spec>;

/** The used members of three's USD composer, which has no types. */
interface UsdComposer {
  compose(data: { specsByPath: Specs }, ...others: unknown[]): unknown;
  _buildMesh(path: string, spec: Spec): Mesh;
  _computeVertexNormals(points: ArrayLike<number>): Float32Array;
  _getAttributes(path: string): Record<string, unknown>;
  _getGeomSubsets(path: string): Subset[];
  _getMaterialBindingTarget(path: string): string | null;
  _getReferences(spec: Spec): string[];
  _resolveReference(reference: string, ...others: unknown[]): unknown;
}

/** Faces of a mesh with their own material. */
interface Subset {
  name: string;
  indices: ArrayLike<number>;
  materialPath: string | null;
}

const PRIM = 6;
const RGB = 3;
const LINES = ['BasisCurves', 'HermiteCurves', 'NurbsCurves', 'Points'];
/** Prims that are not drawn, and their notes for the caption. */
const LEFT_OUT: Readonly<Record<string, string>> = {
  ...Object.fromEntries(LINES.map((name) => [name, 'points and lines left out'])),
  NurbsPatch: 'curved surfaces left out',
  TetMesh: 'tetrahedra left out',
  Plane: 'planes left out',
  PointInstancer: 'instances left out',
};

/**
 * Patches three's USD composer where it misreads files: it shows invisible and proxy prims, turns left-handed meshes inside out, and drops
 * faces outside of all subsets. Meshes without normals get zeros, so that normals are computed later with creases kept.
 *
 * @param notes receives notes for the caption
 * @param hidden whether invisible prims are shown; receives the number of their meshes that are left out
 * @returns a function that removes the patch
 */
function patchUsd(
  prototype: UsdComposer,
  notes: Set<string>,
  hidden: { readonly isShown: boolean; meshes: number },
): () => void {
  const { compose, _buildMesh, _getGeomSubsets, _getReferences, _resolveReference } = prototype;
  return replace(prototype, {
    _computeVertexNormals: (points: ArrayLike<number>) => new Float32Array(points.length),
    compose(this: UsdComposer, data: { specsByPath: Specs }, ...others: unknown[]): unknown {
      hidden.meshes += dropHidden(data.specsByPath, hidden.isShown);
      for (const [path, spec] of Object.entries(data.specsByPath)) noteOn(path, spec, notes);
      return compose.call(this, data, ...others);
    },
    _buildMesh(this: UsdComposer, path: string, spec: Spec): Mesh {
      const mesh = _buildMesh.call(this, path, spec);
      const { orientation, 'primvars:displayColor': colors } = this._getAttributes(path);
      if (orientation === 'leftHanded') turnTriangles(mesh.geometry);
      if (((colors as ArrayLike<number> | undefined)?.length ?? 0) > RGB)
        notes.add('colours of single faces and points left out');
      return mesh;
    },
    _getReferences(this: UsdComposer, spec: Spec): string[] {
      const found = _getReferences.call(this, spec);
      if (found.length === 0 && spec.fields?.references?.length) notes.add('repeated parts left out');
      return found;
    },
    _resolveReference(this: UsdComposer, reference: string, ...others: unknown[]): unknown {
      const found = _resolveReference.call(this, reference, ...others);
      if (!found) notes.add('parts in other files left out');
      return found;
    },
    _getGeomSubsets(this: UsdComposer, path: string): Subset[] {
      const subsets = _getGeomSubsets.call(this, path).filter(({ materialPath }) => materialPath);
      if (subsets.length === 0) return [];
      const { faceVertexCounts } = this._getAttributes(path);
      const isNamed = new Uint8Array((faceVertexCounts as ArrayLike<number> | undefined)?.length ?? 0);
      for (const { indices } of subsets) for (let i = 0; i < indices.length; i++) isNamed[indices[i]] = 1;
      const indices = [...isNamed.keys()].filter((face) => isNamed[face] === 0);
      const rest = { name: '', indices, materialPath: this._getMaterialBindingTarget(path) };
      return indices.length > 0 ? [...subsets, rest] : subsets;
    },
  });
}

/** Rewrites a USD text for three's parser: inactive prims become `over`, and references are written as `prepend references`. */
const plainUsda = (text: string): string =>
  text
    .replace(/\bdef((?:\s+\w+)?\s+"[^"]*"\s*\([^)]*\bactive\s*=\s*false\b)/g, 'over$1')
    .replace(/\b(?:(?:prepend|append|add)\s+)?references(\s*=)/g, 'prepend references$1');

/**
 * Removes inactive prims, guides and proxies, and invisible prims unless they are shown, with all below them.
 *
 * @returns the number of meshes removed because they are invisible
 */
function dropHidden(specs: Specs, showsInvisible: boolean): number {
  const prims = Object.entries(specs).filter(([, { specType }]) => specType === PRIM);
  const given = (path: string, name: string): unknown => specs[`${path}.${name}`]?.fields?.default;
  const isRendered = prims.some(([path]) => given(path, 'purpose') === 'render');
  const dropped = new Set<string>();
  const invisible = new Set<string>();
  for (const [path, { fields }] of prims) {
    const purpose = given(path, 'purpose');
    const isLeftOut = purpose === 'guide' || (purpose === 'proxy' && isRendered);
    if (isLeftOut || fields?.active === false) dropped.add(path);
    else if (!showsInvisible && given(path, 'visibility') === 'invisible') invisible.add(path);
  }
  if (dropped.size + invisible.size === 0) return 0;
  let meshes = 0;
  for (const path of Object.keys(specs)) {
    const [prim] = path.split('.');
    const parts = prim.split('/');
    const isBelow = (prims: ReadonlySet<string>): boolean =>
      parts.some((_, i) => prims.has(parts.slice(0, i + 1).join('/')));
    const isDropped = isBelow(dropped);
    if (!isDropped && !isBelow(invisible)) continue;
    if (!isDropped && path === prim && specs[path].fields?.typeName === 'Mesh') meshes++;
    delete specs[path];
  }
  return meshes;
}

function noteOn(path: string, { specType, fields = {} }: Spec, notes: Set<string>): void {
  const { typeName = '' } = fields;
  // The form in which three's text parser returns variants.
  const note = specType === PRIM ? LEFT_OUT[typeName] : typeName === 'variantSet' ? 'variants left out' : undefined;
  if (note) notes.add(note);
  const isMoved = fields.connectionPaths?.length || Number(fields.default) > 0;
  if (path.endsWith('.inputs:displacement') && isMoved) notes.add(DISPLACEMENT_NOTE);
}

/** Reverses the triangles of a geometry. */
function turnTriangles(geometry: BufferGeometry): void {
  const { index } = geometry;
  const count = index?.count ?? geometry.getAttribute('position').count;
  const turned = Array.from({ length: count - (count % 3) }, (_, corner) => {
    const from = corner - (corner % 3) + [0, 2, 1][corner % 3];
    return index?.getX(from) ?? from;
  });
  geometry.setIndex(turned);
}
