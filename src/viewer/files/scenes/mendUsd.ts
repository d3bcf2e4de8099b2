import type { BufferGeometry, Mesh } from 'three';
import { DISPLACEMENT_NOTE } from './LoadedScene.js';
import { replace } from './standIns.js';

/** What a path of a USD layer holds: a prim, or a property of one. */
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

/** What is used of three's composer of USD, which has no types. */
export interface UsdComposer {
  compose(data: { specsByPath: Specs }, ...others: unknown[]): unknown;
  _buildMesh(path: string, spec: Spec): Mesh;
  _computeVertexNormals(points: ArrayLike<number>): Float32Array;
  _getAttributes(path: string): Record<string, unknown>;
  _getGeomSubsets(path: string): Subset[];
  _getMaterialBindingTarget(path: string): string | null;
  _getReferences(spec: Spec): string[];
  _resolveReference(reference: string, ...others: unknown[]): unknown;
}

/** Faces of a mesh with a material of their own. */
interface Subset {
  name: string;
  indices: ArrayLike<number>;
  materialPath: string | null;
}

const PRIM = 6;
const RGB = 3;
const LINES = ['BasisCurves', 'HermiteCurves', 'NurbsCurves', 'Points'];
/** Prims that are not drawn, and what the caption is to say of them. */
const LEFT_OUT: Readonly<Record<string, string>> = {
  ...Object.fromEntries(LINES.map((name) => [name, 'points and lines left out'])),
  NurbsPatch: 'curved surfaces left out',
  TetMesh: 'tetrahedra left out',
  Plane: 'planes left out',
  PointInstancer: 'instances left out',
};

/**
 * Has three's composer of USD draw what a file says where it would not: it shows what is invisible or a stand-in, turns left-handed meshes
 * inside out, and leaves out the faces that no subset has. Meshes without normals get zeros, so that they are computed later, with edges kept.
 *
 * @param notes receives what the caption is to say
 * @returns a function that ends it
 */
export function mendUsd(prototype: UsdComposer, notes: Set<string>): () => void {
  const { compose, _buildMesh, _getGeomSubsets, _getReferences, _resolveReference } = prototype;
  return replace(prototype, {
    _computeVertexNormals: (points: ArrayLike<number>) => new Float32Array(points.length),
    compose(this: UsdComposer, data: { specsByPath: Specs }, ...others: unknown[]): unknown {
      dropHidden(data.specsByPath);
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

/** A text of USD as three's parser reads it: prims that are not active are none, and references are what others are added to. */
export const plainUsda = (text: string): string =>
  text
    .replace(/\bdef((?:\s+\w+)?\s+"[^"]*"\s*\([^)]*\bactive\s*=\s*false\b)/g, 'over$1')
    .replace(/\b(?:(?:prepend|append|add)\s+)?references(\s*=)/g, 'prepend references$1');

/** Takes away the prims that are not to be seen, with all below them: invisible and inactive ones, guides, and stand-ins for what is there itself. */
function dropHidden(specs: Specs): void {
  const prims = Object.entries(specs).filter(([, { specType }]) => specType === PRIM);
  const given = (path: string, name: string): unknown => specs[`${path}.${name}`]?.fields?.default;
  const isRendered = prims.some(([path]) => given(path, 'purpose') === 'render');
  const hidden = new Set<string>();
  for (const [path, { fields }] of prims) {
    const purpose = given(path, 'purpose');
    const isStandIn = purpose === 'guide' || (purpose === 'proxy' && isRendered);
    if (isStandIn || given(path, 'visibility') === 'invisible' || fields?.active === false) hidden.add(path);
  }
  if (hidden.size === 0) return;
  for (const path of Object.keys(specs)) {
    const [prim] = path.split('.');
    const parts = prim.split('/');
    if (parts.some((_, i) => hidden.has(parts.slice(0, i + 1).join('/')))) delete specs[path];
  }
}

function noteOn(path: string, { specType, fields = {} }: Spec, notes: Set<string>): void {
  const { typeName = '' } = fields;
  // What three's parser of text makes of variants.
  const note = specType === PRIM ? LEFT_OUT[typeName] : typeName === 'variantSet' ? 'variants left out' : undefined;
  if (note) notes.add(note);
  const isMoved = fields.connectionPaths?.length || Number(fields.default) > 0;
  if (path.endsWith('.inputs:displacement') && isMoved) notes.add(DISPLACEMENT_NOTE);
}

/** Turns the triangles of a geometry round. */
function turnTriangles(geometry: BufferGeometry): void {
  const { index } = geometry;
  const count = index?.count ?? geometry.getAttribute('position').count;
  const turned = Array.from({ length: count - (count % 3) }, (_, corner) => {
    const from = corner - (corner % 3) + [0, 2, 1][corner % 3];
    return index?.getX(from) ?? from;
  });
  geometry.setIndex(turned);
}
