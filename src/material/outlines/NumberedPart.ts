import { type InstancedMesh, type Material, Matrix4, type Mesh, type Object3D } from 'three';
import { MOST_TRIANGLES } from '../../mesh/intersections/pairsOf.js';
import { deforms } from '../deformation/canDeform.js';
import { type OutlineData, outlineDataOf } from '../geometry/OutlineData.js';
import { type IntersectingOutlines, wantsIntersections } from './IntersectingOutlines.js';

/** The greatest difference of numbers of two matrices that count as equal, as a share of the largest: rounding of a chain of matrices. */
const ROUNDING = 1e-6;

/** Most movements that are told apart in a frame: what moves in another way counts as a part of its own. */
const MOST_MOVEMENTS = 64;

/** Whether two matrices are equal up to rounding. */
export function areEqual(a: Matrix4, b: Matrix4): boolean {
  let largest = 0;
  let difference = 0;
  for (let i = 0; i < 16; i++) {
    largest = Math.max(largest, Math.abs(a.elements[i]));
    difference = Math.max(difference, Math.abs(a.elements[i] - b.elements[i]));
  }
  return difference <= ROUNDING * largest;
}

/** Whether parts of a surface may be discarded. */
export const hasHoles = ({ alphaHash, alphaTest }: Material): boolean => alphaHash || alphaTest > 0;

/** Whether a mesh has several places, or a shape that changes. */
export const isLoose = (mesh: Mesh): boolean => 'isInstancedMesh' in mesh || deforms(mesh.geometry, mesh);

/** A mesh that may meet others, with the number by which pixels of the screen know what moves together. */
export class NumberedPart {
  /** Equal for parts whose lines are known where they are now; 0 for one that meets nothing. */
  number = 0;
  /** The number of its outline material in a frame, from 1; 0 if it is not in view. */
  look = 0;
  /** Whether what lies behind its surface is seen through it. */
  isClear = false;
  /** From the place at the last search to the place now. */
  readonly movement = new Matrix4();
  private readonly searchedAt = new Matrix4();
  private readonly fromSearched = new Matrix4();
  private data: OutlineData | undefined;

  constructor(readonly outlines: IntersectingOutlines) {}

  /** Notes that the lines between this part and all others are known for the places that they had. */
  noteSearch(place: Matrix4, data: OutlineData): void {
    this.searchedAt.copy(place);
    this.fromSearched.copy(place).invert();
    this.data = data;
  }

  /** Whether the lines with other parts are known for some place of the mesh. */
  isKnown(mesh: Mesh): boolean {
    return this.data !== undefined && outlineDataOf(mesh.geometry) === this.data && !isLoose(mesh);
  }

  /** Whether the mesh is where it was at the last search. Notes its movement if it is not. */
  rests({ matrixWorld }: Mesh): boolean {
    if (this.searchedAt.equals(matrixWorld)) return true;
    this.movement.multiplyMatrices(matrixWorld, this.fromSearched);
    return false;
  }
}

const still = /* @__PURE__ */ new Matrix4();
/** The first part of each movement of a frame. */
const leaders: NumberedPart[] = [];

/**
 * Numbers the parts of a scene: those that have moved together since their lines were found share a number, and each instance and each mesh
 * that deforms has one of its own. Returns how many numbers there are. Allocates nothing once as many movements were seen.
 */
export function numberParts(parts: readonly NumberedPart[], root: Object3D): number {
  let last = 1;
  let resting = 0;
  leaders.length = 0;
  for (let i = 0; i < parts.length; i++) {
    const part = parts[i];
    const { mesh } = part.outlines;
    part.number = 0;
    if (!mesh || !wantsIntersections(part.outlines) || !canMeet(mesh) || !isShownBelow(root, mesh)) continue;
    part.isClear = isClear(mesh);
    const isKnown = part.isKnown(mesh);
    if (isKnown && (part.rests(mesh) || areEqual(part.movement, still))) {
      part.number = 1;
      resting = 1;
      continue;
    }
    const leader = isKnown ? leaderOf(part) : null;
    if (leader) part.number = leader.number;
    else {
      part.number = last + 1;
      last += 'isInstancedMesh' in mesh ? (mesh as InstancedMesh).count : 1;
      if (isKnown && leaders.length < MOST_MOVEMENTS) leaders.push(part);
    }
  }
  return last - 1 + resting;
}

function leaderOf({ movement }: NumberedPart): NumberedPart | null {
  for (let i = 0; i < leaders.length; i++) if (areEqual(leaders[i].movement, movement)) return leaders[i];
  return null;
}

/** Whether a mesh has a surface that is seen, and is no picture cut out of cards. */
function canMeet(mesh: Mesh): boolean {
  const data = outlineDataOf(mesh.geometry);
  if (!data || data.triangleCount > MOST_TRIANGLES) return false;
  const { material } = mesh;
  if (!Array.isArray(material)) return isWhole(material);
  for (let i = 0; i < material.length; i++) if (!isWhole(material[i])) return false;
  return material.length > 0;
}

const isWhole = (material: Material): boolean =>
  material.visible && (material.depthWrite || material.transparent) && !hasHoles(material);

function isClear({ material }: Mesh): boolean {
  if (!Array.isArray(material)) return material.transparent;
  for (let i = 0; i < material.length; i++) if (material[i].transparent) return true;
  return false;
}

/** Whether a mesh and all above it are visible, and it lies below a root. */
function isShownBelow(root: Object3D, mesh: Mesh): boolean {
  for (let object: Object3D = mesh; object.visible; object = object.parent) {
    if (object === root) return true;
    if (object.parent === null) return false;
  }
  return false;
}
