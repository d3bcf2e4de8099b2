/** Solids with plane faces, and how models are composed of them. */
import {
  BoxGeometry,
  BufferGeometry,
  ExtrudeGeometry,
  Float32BufferAttribute,
  Group,
  Mesh,
  MeshStandardMaterial,
  Path,
  Shape,
  Vector3,
} from 'three';
import { TessellateModifier } from 'three/addons/modifiers/TessellateModifier.js';
import { mergeGeometries } from 'three/addons/utils/BufferGeometryUtils.js';
import type { ModelScene } from '../../viewer/files/gltf/parseGltf.js';

/** The geometries of a model by material. Solids must not have coplanar touching faces. */
export type Parts<Substance extends string> = Partial<Record<Substance, BufferGeometry[]>>;

export type Point = readonly [x: number, y: number, z: number];

/** A rectangle in a wall: its middle, its foot and its size. */
export interface Opening {
  x: number;
  y: number;
  width: number;
  height: number;
}

/** A box at x, y, z, where y is its foot. */
export const box = (width: number, height: number, depth: number, x: number, y: number, z: number): BufferGeometry =>
  solid(new BoxGeometry(width, height, depth)).translate(x, y + height / 2, z);

/** A geometry as {@link together} and {@link sceneOf} need it: without shared vertices. */
export function solid(geometry: BufferGeometry): BufferGeometry {
  geometry.deleteAttribute('uv');
  return geometry.index ? geometry.toNonIndexed() : geometry;
}

export function rectangle<Outline extends Path>(outline: Outline, { x, y, width, height }: Opening): Outline {
  const [left, right] = [x - width / 2, x + width / 2];
  outline
    .moveTo(left, y)
    .lineTo(right, y)
    .lineTo(right, y + height)
    .lineTo(left, y + height)
    .closePath();
  return outline;
}

/** A slab with an outline and holes, from z = −`depth` to 0. */
export function slab(outline: Shape, openings: readonly Opening[], depth: number): BufferGeometry {
  outline.holes.push(...openings.map((opening) => rectangle(new Path(), opening)));
  return solid(new ExtrudeGeometry(outline, { depth, bevelEnabled: false })).translate(0, 0, -depth);
}

/** A polygonal outline. */
export const polygon = (points: readonly (readonly [x: number, y: number])[]): Shape => {
  const shape = new Shape();
  points.forEach(([x, y], i) => {
    if (i === 0) shape.moveTo(x, y);
    else shape.lineTo(x, y);
  });
  shape.closePath();
  return shape;
};

/**
 * Flat faces between corners.
 *
 * @param faces corner indices around each face, in either direction
 * @param inside a point behind all faces
 */
export function facets(
  corners: readonly Point[],
  faces: readonly (readonly number[])[],
  inside: Point,
): BufferGeometry {
  const positions: number[] = [];
  const middle = new Vector3(...inside);
  for (const face of faces) {
    for (let i = 2; i < face.length; i++) {
      const [a, b, c] = [face[0], face[i - 1], face[i]].map((corner) => new Vector3(...corners[corner]));
      const normal = b.clone().sub(a).cross(c.clone().sub(a));
      const turned = normal.dot(a.clone().sub(middle)) < 0 ? [a, c, b] : [a, b, c];
      positions.push(...turned.flatMap((corner) => corner.toArray()));
    }
  }
  const geometry = new BufferGeometry().setAttribute('position', new Float32BufferAttribute(positions, 3));
  geometry.computeVertexNormals();
  return geometry;
}

/** Copies of parts, each transformed in the same way. */
export function moved<Substance extends string>(
  parts: Parts<Substance>,
  change: (geometry: BufferGeometry) => BufferGeometry,
): Parts<Substance> {
  const entries = Object.entries(parts) as [Substance, BufferGeometry[]][];
  return Object.fromEntries(
    entries.map(([substance, solids]) => [substance, solids.map((geometry) => change(geometry.clone()))]),
  ) as Parts<Substance>;
}

export function together<Substance extends string>(...parts: Parts<Substance>[]): Parts<Substance> {
  const all: Parts<Substance> = {};
  for (const part of parts) {
    for (const [name, solids] of Object.entries(part) as [Substance, BufferGeometry[]][]) {
      all[name] = [...(all[name] ?? []), ...solids];
    }
  }
  return all;
}

/**
 * A scene with a mesh for each material.
 *
 * @param colours of the materials
 * @param longestEdge maximum edge length, so that occlusion has vertices to be stored at; undefined leaves faces whole
 */
export function sceneOf<Substance extends string>(
  colours: Readonly<Record<Substance, string>>,
  parts: Parts<Substance>,
  longestEdge?: number,
): ModelScene {
  const root = new Group();
  for (const [substance, color] of Object.entries(colours) as [Substance, string][]) {
    const whole = mergeGeometries(parts[substance] ?? []);
    const geometry = longestEdge === undefined ? whole : new TessellateModifier(longestEdge, 12).modify(whole);
    const mesh = new Mesh(geometry, new MeshStandardMaterial({ color }));
    mesh.name = substance;
    root.add(mesh);
  }
  return { root, animations: [] };
}
