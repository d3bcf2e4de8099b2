import type { Fans } from '../normals/buildFans.js';

/**
 * The surface cut open so that directions can be combed: on the cut surface they have signs that agree across every edge. Edges
 * and corners share their numbers (see `corners.ts`).
 */
export interface FormSeam {
  /** The sign of each face's direction after combing, 1 or −1. */
  flip: Int8Array<ArrayBuffer>;
  /** For each edge 1 if the surface is cut there, else 0. Both halves of an edge have the same. */
  cut: Uint8Array<ArrayBuffer>;
  /** For each cut edge 1 or −1: whether combed directions on its two sides agree. 1 for all others. Both halves have the same. */
  cutSign: Int8Array<ArrayBuffer>;
  /** The twins of the surface, with NO_TWIN where it is cut. */
  cutTwins: Int32Array<ArrayBuffer>;
  /** The fans of `cutTwins`: the vertices of φ. */
  wedges: Fans;
  /** For each fan how often directions turn around it, in half turns: 1 or −1 at most singular points, 0 at regular fans and open ones. */
  halfTurns: Int8Array<ArrayBuffer>;
  /** For each fan 1 if directions turn by an odd number of half turns around it, so that they come back reversed. */
  isSingular: Uint8Array<ArrayBuffer>;
  /** For each fan 1 if directions turn by whole turns around it: a hole for φ, which has no value there. */
  isPuncture: Uint8Array<ArrayBuffer>;
  /** For each fan 1 if it lies on a border or a crease. */
  isOpen: Uint8Array<ArrayBuffer>;
  /** For each fan the number of cut edges that meet there. */
  degree: Uint32Array<ArrayBuffer>;
  /** For each fan the corner from which a walk across the edges that start there, from `corner` to `nextCorner(twins[corner])`, meets the whole fan. */
  cornerOf: Int32Array<ArrayBuffer>;
}
