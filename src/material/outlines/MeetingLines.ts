import { type Material, Matrix4, type Mesh } from 'three';
import {
  INTERSECTION,
  IS_EDGE,
  POINT_BITS,
  POINT_WORDS,
  PRIMITIVE_WORDS,
  SEGMENT_POINTS,
} from '../../mesh/bake/outlineLayout.js';
import { paddedWords } from '../../mesh/bake/pullLayout.js';
import { OutlineData, outlineDataOf } from '../geometry/OutlineData.js';
import { type IntersectingOutlines, wantsIntersections } from './IntersectingOutlines.js';
import { areEqual } from './NumberedPart.js';
import type { OutlinePart } from './OutlineParts.js';

/** The lines of a pair of meshes, in the space of the first, which holds them. */
interface MeetingPair {
  readonly other: IntersectingOutlines;
  readonly data: OutlineData;
  readonly otherData: OutlineData;
  /** From the space of the other mesh to that of the first, as the lines were computed. */
  readonly relative: Matrix4;
  /** Packed points of segments; null if it was too much work. */
  readonly points: Uint32Array | null;
  /** The surface as firm as which they were drawn in the last frame; null if they were not drawn. */
  surface: Material | null;
}

/** Makes a part of outlines. It is given, since pages that load outlines without these lines would fetch what the two share as one more file. */
export type NewPart = (data: OutlineData, surface: Material) => OutlinePart;

const relative = /* @__PURE__ */ new Matrix4();

/** Computes the matrix from the space of one mesh to that of another. */
export const relativeTo = (other: Mesh, mesh: Mesh, into: Matrix4): Matrix4 =>
  into.copy(mesh.matrixWorld).invert().multiply(other.matrixWorld);

/** The share of ink that three.js' blending leaves of the surface of a mesh. */
function firmnessOf({ material }: Mesh): number {
  const { transparent, opacity } = Array.isArray(material) ? material[0] : material;
  return transparent ? opacity : 1;
}

/** Whether a mesh and all above it are visible. */
function isShown(mesh: Mesh): boolean {
  for (let object: Mesh['parent'] = mesh; object !== null; object = object.parent) if (!object.visible) return false;
  return mesh.matrixWorld.determinant() !== 0;
}

/** The lines along which a mesh meets others, as parts of its outlines. */
export class MeetingLines {
  private pairs: readonly MeetingPair[] = [];
  /** The lines, by the surfaces that they are as firm as. */
  private readonly found = new Map<Material, OutlinePart>();
  private parts: readonly OutlinePart[] = [];
  private own: readonly OutlinePart[] = [];

  constructor(private readonly outlines: IntersectingOutlines) {}

  /** Whether the lines with other outlines are known for where both meshes are now. */
  knows(other: IntersectingOutlines): boolean {
    const pair = this.pairs.find((one) => one.other === other);
    return pair !== undefined && this.isCurrent(pair);
  }

  /** Notes the lines of a pair. @param toFirst from the space of the other mesh to that of the first, as they were computed */
  set(
    other: IntersectingOutlines,
    data: OutlineData,
    otherData: OutlineData,
    toFirst: Matrix4,
    points: Uint32Array | null,
  ): void {
    const others = this.pairs.filter((pair) => pair.other !== other);
    this.pairs = [...others, { other, data, otherData, relative: toFirst, points, surface: null }];
    this.dropParts();
  }

  /** Forgets lines with outlines that are gone, or hold them now. */
  keep(isKept: (other: IntersectingOutlines) => boolean): void {
    const kept = this.pairs.filter(({ other }) => isKept(other));
    if (kept.length === this.pairs.length) return;
    this.pairs = kept;
    this.dropParts();
  }

  /** The parts of outlines, and the lines that are valid now. Allocates nothing while those are the same as in the last frame. */
  add(own: readonly OutlinePart[], newPart: NewPart): readonly OutlinePart[] {
    if (own.length === 0) return own;
    let isSame = own === this.own;
    let isAny = false;
    for (let i = 0; i < this.pairs.length; i++) {
      const pair = this.pairs[i];
      const surface = this.surfaceFor(pair, own[0].surface);
      if (surface !== pair.surface) isSame = false;
      pair.surface = surface;
      isAny ||= surface !== null;
    }
    if (!isAny) return own;
    if (!isSame || this.found.size === 0) {
      this.own = own;
      this.makeParts(newPart);
      this.parts = [...own, ...this.found.values()];
    }
    return this.parts;
  }

  dispose(): void {
    this.pairs = [];
    this.dropParts();
  }

  private isCurrent({ other, data, otherData, relative: computed }: MeetingPair): boolean {
    const { mesh } = this.outlines;
    if (!mesh || !other.mesh) return false;
    if (outlineDataOf(mesh.geometry) !== data || outlineDataOf(other.mesh.geometry) !== otherData) return false;
    return other === this.outlines || areEqual(relativeTo(other.mesh, mesh, relative), computed);
  }

  /** The surface as firm as which the lines of a pair are drawn, the firmer of both; null if they are not drawn. */
  private surfaceFor(pair: MeetingPair, ownSurface: Material): Material | null {
    const { other, points } = pair;
    if (points === null || points.length === 0 || !wantsIntersections(other)) return null;
    if (!this.isCurrent(pair) || !isShown(other.mesh!)) return null;
    const { material } = other.mesh!;
    if (firmnessOf(other.mesh!) <= firmnessOf(this.outlines.mesh!)) return ownSurface;
    return Array.isArray(material) ? material[0] : material;
  }

  private makeParts(newPart: NewPart): void {
    this.dropParts();
    for (const { surface } of this.pairs) {
      if (!surface || this.found.has(surface)) continue;
      const alike = this.pairs.filter((pair) => pair.surface === surface);
      this.found.set(surface, newPart(packedData(alike), surface));
    }
  }

  private dropParts(): void {
    for (const { data } of this.found.values()) data.dispose();
    this.found.clear();
  }
}

/** The data that the lines of some pairs are drawn from. */
function packedData(pairs: readonly MeetingPair[]): OutlineData {
  const wordsPerSegment = SEGMENT_POINTS * POINT_WORDS;
  const edgeCount = pairs.reduce((sum, { points }) => sum + points!.length, 0) / wordsPerSegment;
  const points = new Uint32Array(paddedWords(SEGMENT_POINTS * edgeCount, POINT_WORDS));
  let at = 0;
  for (const { points: ofPair } of pairs) {
    points.set(ofPair!, at);
    at += ofPair!.length;
  }
  const primitives = new Uint32Array(paddedWords(edgeCount, PRIMITIVE_WORDS));
  const flags = (((INTERSECTION | IS_EDGE) >> 4) << POINT_BITS) >>> 0;
  for (let edge = 0; edge < edgeCount; edge++) {
    for (let k = 0; k < SEGMENT_POINTS; k++) primitives[PRIMITIVE_WORDS * edge + k] = SEGMENT_POINTS * edge + k;
    primitives[PRIMITIVE_WORDS * edge + 1] |= flags;
  }
  const none = new Float32Array(0);
  const [{ data }] = pairs;
  const { createWorker, radius } = data;
  return new OutlineData(
    { points, primitives, searched: null, triangleCount: 0, edgeCount, positions: none, normals: none, radius },
    createWorker,
  );
}
