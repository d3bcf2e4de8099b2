import type { BufferAttribute, Material, Mesh, Object3D, Texture } from 'three';
import { LEAST_ALPHA, OPAQUE_ALPHA } from '../mesh/vertexColors.js';

/** The largest loss of opacity by transmission: clear glass still counts as visible. */
export const TRANSMITTED = 0.8;
/** The alpha threshold for cutting out blended pictures. */
const HALF = 0.5;

/** The fields of three's materials that affect transparency. */
type Surface = Material & { map?: Texture | null; alphaMap?: Texture | null; transmission?: number };

/**
 * Decides how the surfaces of a scene are drawn. Ink has no half opacity, so each surface is opaque, cut out by its picture (`alphaTest`),
 * see-through (`transparent`) or invisible (`visible` is false). Triangles with transparent vertices are left out, and others are split by
 * vertex alpha. If nothing would be visible, all is opaque: some programs write opacity inverted.
 *
 * @returns notes for the caption
 */
export function resolveAlpha(root: Object3D): string[] {
  const drawn: Surface[] = [];
  root.traverseVisible((object) => {
    const mesh = object as Mesh;
    if (!mesh.isMesh || !mesh.geometry.getAttribute('position')) return;
    const { material } = mesh;
    if (Array.isArray(material)) for (const one of material) one && resolve(one);
    else if (material && !resolveVertices(mesh, material)) resolve(material);
    drawn.push(...[mesh.material].flat().filter(Boolean));
  });
  if (drawn.length === 0 || drawn.some(({ visible }) => visible)) return [];
  for (const material of drawn) Object.assign(material, { visible: true, transparent: false, depthWrite: true });
  return ['invisible in the file, drawn as opaque'];
}

/** The opacity of a material without its picture and vertices. */
const opacityOf = ({ opacity, transmission = 0 }: Surface): number =>
  (Number.isFinite(opacity) ? opacity : 1) * (1 - TRANSMITTED * transmission);

const isBlended = ({ transparent, transmission = 0 }: Surface): boolean => transparent || transmission > 0;

/** @param alpha of its vertices */
function resolve(material: Surface, alpha = 1): void {
  const opacity = alpha * opacityOf(material);
  const picture = material.map ?? material.alphaMap;
  const plain = { transparent: false, depthWrite: true, opacity: 1, alphaTest: 0, transmission: 0 };
  if (material.alphaTest > 0) {
    const cutOff = material.alphaTest / Math.max(opacity, Number.EPSILON);
    Object.assign(material, plain, { alphaTest: picture ? cutOff : 0 });
    if (cutOff > 1) material.visible = false;
  } else if (isBlended(material)) {
    if (opacity < LEAST_ALPHA) material.visible = false;
    if (opacity < OPAQUE_ALPHA) Object.assign(material, plain, { transparent: true, depthWrite: false, opacity });
    else {
      Object.assign(material, plain, { alphaTest: picture?.image ? HALF : 0 });
      // The picture decides once it is decoded.
      material.userData.isBlended = material.alphaTest > 0;
    }
  }
}

/**
 * Splits a mesh by vertex alpha into opaque, see-through and invisible triangles.
 *
 * @returns whether vertices have an alpha
 */
function resolveVertices(mesh: Mesh, material: Surface): boolean {
  const { geometry } = mesh;
  const color = geometry.getAttribute('color') as BufferAttribute | undefined;
  const isCutOut = material.alphaTest > 0;
  if (color?.itemSize !== 4 || !material.vertexColors || !(isCutOut || isBlended(material))) return false;
  const opacity = opacityOf(material);
  const { index } = geometry;
  const corners = index?.count ?? color.count;
  const solid = { vertices: [] as number[], sum: 0 };
  const clear = { vertices: [] as number[], sum: 0 };
  for (let corner = 0; corner + 2 < corners; corner += 3) {
    const vertices = [corner, corner + 1, corner + 2].map((at) => (index ? index.getX(at) : at));
    const alphas = vertices.map((vertex) => color.getW(vertex));
    if (opacity * Math.max(...alphas) < (isCutOut ? material.alphaTest : LEAST_ALPHA)) continue;
    const sum = isCutOut ? 3 : alphas[0] + alphas[1] + alphas[2];
    const side = isCutOut || (opacity * sum) / 3 >= OPAQUE_ALPHA ? solid : clear;
    side.vertices.push(...vertices);
    side.sum += sum;
  }
  const parts = [solid, clear].filter(({ vertices }) => vertices.length > 0);
  if (parts.length > 1 || solid.vertices.length + clear.vertices.length < corners - (corners % 3)) {
    mesh.geometry = geometry.clone();
    mesh.geometry.setIndex(solid.vertices.concat(clear.vertices));
  }
  const materials = parts.map(({ vertices, sum }) => resolved(material, sum / vertices.length));
  if (parts.length < 2) mesh.material = materials[0] ?? resolved(material, 0);
  else {
    mesh.material = materials;
    mesh.geometry.clearGroups();
    mesh.geometry.addGroup(0, solid.vertices.length, 0);
    mesh.geometry.addGroup(solid.vertices.length, clear.vertices.length, 1);
  }
  return true;
}

/** A copy of a material, resolved for a vertex alpha. */
function resolved(material: Surface, alpha: number): Surface {
  const copy = material.clone();
  resolve(copy, alpha);
  return copy;
}
