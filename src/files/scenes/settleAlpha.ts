import type { BufferAttribute, Material, Mesh, Object3D, Texture } from 'three';

/** A surface with less opacity is not seen. */
const LEAST = 0.02;
/** A surface with more opacity hides what is behind it. */
export const MOST = 0.95;
/** The most that a surface loses of its opacity by letting light through: glass is clear, and yet there. */
export const TRANSMITTED = 0.8;
/** The alpha from which on a picture that is blended is drawn. */
const HALF = 0.5;

/** What materials of three.js may have beyond `Material` that says how far they are seen through. */
type Surface = Material & { map?: Texture | null; alphaMap?: Texture | null; transmission?: number };

/**
 * Settles how the surfaces of a scene are drawn. Ink knows no half opacity, so that each is one of four: opaque; cut out by its picture
 * (`alphaTest`); seen through as glass is (`transparent`); or not there (`visible` is false). Triangles whose vertices have no alpha are
 * left out. Of a scene of which nothing would be seen, all is opaque: some programs write opacity the wrong way round.
 */
export function settleAlpha(root: Object3D): void {
  const drawn: Surface[] = [];
  root.traverseVisible((object) => {
    const mesh = object as Mesh;
    if (!mesh.isMesh || !mesh.geometry.getAttribute('position')) return;
    const { material } = mesh;
    if (Array.isArray(material)) for (const one of material) one && settle(one);
    else if (material) {
      const alpha = dropClearTriangles(mesh, material);
      if (alpha !== undefined) mesh.material = material.clone();
      settle(mesh.material as Surface, alpha);
    }
    drawn.push(...[mesh.material].flat().filter(Boolean));
  });
  if (drawn.some(({ visible }) => visible)) return;
  for (const material of drawn) Object.assign(material, { visible: true, transparent: false, depthWrite: true });
}

/** How opaque a material is where its picture and its vertices are. */
const opacityOf = ({ opacity, transmission = 0 }: Surface): number =>
  (Number.isFinite(opacity) ? opacity : 1) * (1 - TRANSMITTED * transmission);

const isBlended = ({ transparent, transmission = 0 }: Surface): boolean => transparent || transmission > 0;

/** @param alpha of its vertices */
function settle(material: Surface, alpha = 1): void {
  const opacity = alpha * opacityOf(material);
  const picture = material.map ?? material.alphaMap;
  const settled = { transparent: false, depthWrite: true, opacity: 1, alphaTest: 0, transmission: 0 };
  if (material.alphaTest > 0) {
    const cutOff = material.alphaTest / Math.max(opacity, Number.EPSILON);
    Object.assign(material, settled, { alphaTest: picture ? cutOff : 0 });
    if (cutOff > 1) material.visible = false;
  } else if (isBlended(material)) {
    if (opacity < LEAST) material.visible = false;
    if (opacity < MOST) Object.assign(material, settled, { transparent: true, depthWrite: false, opacity });
    else Object.assign(material, settled, { alphaTest: picture?.image ? HALF : 0 });
  }
}

/**
 * Leaves out the triangles of a mesh whose vertices let everything through.
 *
 * @returns the mean alpha of the vertices of the others, or 1 where alpha cuts them out; undefined if vertices have none
 */
function dropClearTriangles(mesh: Mesh, material: Surface): number | undefined {
  const { geometry } = mesh;
  const color = geometry.getAttribute('color') as BufferAttribute | undefined;
  const least = material.alphaTest > 0 ? material.alphaTest : LEAST;
  if (color?.itemSize !== 4 || !material.vertexColors || !(material.alphaTest > 0 || isBlended(material)))
    return undefined;
  const opacity = opacityOf(material);
  const { index } = geometry;
  const corners = index?.count ?? color.count;
  const kept: number[] = [];
  let sum = 0;
  for (let corner = 0; corner + 2 < corners; corner += 3) {
    const vertices = [corner, corner + 1, corner + 2].map((at) => (index ? index.getX(at) : at));
    const alphas = vertices.map((vertex) => color.getW(vertex));
    if (opacity * Math.max(...alphas) < least) continue;
    kept.push(...vertices);
    sum += alphas[0] + alphas[1] + alphas[2];
  }
  if (kept.length < corners - (corners % 3)) {
    mesh.geometry = geometry.clone();
    mesh.geometry.setIndex(kept);
  }
  if (kept.length === 0) return 0;
  return material.alphaTest > 0 ? 1 : sum / kept.length;
}
