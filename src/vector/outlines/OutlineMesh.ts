import type { HiddenOutlines } from '../../look/hiddenOutlines.js';
import type { Vec3 } from '../../look/vectors.js';
import type { Matrix } from '../Projection.js';
import type { Emphasis } from '../shading/emphasis.js';

/** What outlines are found on. */
export interface OutlineMesh {
  /** Points, each a fan of corners with one normal: three numbers of the position and of the unit normal, object space. */
  positions: Float32Array | Float64Array;
  normals: Float32Array | Float64Array;
  /** The positions at rest. */
  anchors: Float32Array;
  /** Six numbers per point, xx xy xz yy yz zz: the curvature tensor times the bounding radius. */
  curvatures: Float32Array;
  /** The place of each point. */
  placeOf: Uint32Array;
  /** The points of each triangle. */
  triangles: Uint32Array;
  edges: readonly FeatureEdge[];
  /** Of the bounding sphere, object units. */
  radius: number;
  toWorld: Matrix;
  /** Rows of the matrix that takes normals to the world. */
  normalToWorld: readonly [Vec3, Vec3, Vec3];
  /** World units per object unit, the mean over directions. */
  scale: number;
  /** Where the eye is, and 1; or the direction to it, and 0. Object space. */
  eye: readonly [x: number, y: number, z: number, w: number];
}

/** An edge with the points at its ends, as the triangles on its two sides have them. */
export interface FeatureEdge {
  leftStart: number;
  leftEnd: number;
  rightStart: number;
  rightEnd: number;
  isBorder: boolean;
  isCrease: boolean;
  isMaterialBorder: boolean;
  /** The windings of the two sides contradict each other. */
  isContrary: boolean;
  /** A straight line of edges ends, branches or turns there. */
  isCornerAtStart: boolean;
  isCornerAtEnd: boolean;
}

/** How outlines look. */
export interface OutlineLook {
  /** Pixels. */
  width: number;
  contours: number;
  innerContours: number;
  borders: number;
  creases: number;
  materialBorders: number;
  suggestiveContours: number;
  taper: number;
  shadeWeights: readonly [number, number];
  lostEdges: number;
  /** How much heavier a contour becomes where another one ends behind it. */
  accents: number;
  /** How far lines run on beyond corners, pixels. */
  overshoot: number;
  /** Pixels. */
  wobble: number;
  /** What is drawn of outlines behind a surface. */
  hidden: HiddenOutlines;
  /** Whether parts of their surface may be cut away, which have none. */
  isCutOut: boolean;
  /** What takes weight away; null where all has its full weight. */
  emphasis: Emphasis | null;
}

/** An end of a piece of outline. */
export interface PieceEnd {
  /** Object space; the normal is of any length. */
  position: Vec3;
  /** The same at rest. */
  anchor: Vec3;
  normal: Vec3;
  bend: number;
  /** Weights before the paper, and before a surface. */
  weight: number;
  innerWeight: number;
  /** What is left of the weight before the paper where edges are lost, as a share. */
  left: number;
  /** How far the outline runs on beyond it, pixels. */
  overshoot: number;
  /** Names the place: two ends that have it in common lie there. */
  key: string;
}

export interface OutlinePiece {
  start: PieceEnd;
  end: PieceEnd;
  /** On a surface, not an edge. */
  isSmooth: boolean;
  /** The share of the piece that is a contour or a border. */
  contour: number;
  /** How deep the surface beside the piece is along the line of sight, object units. */
  extent: number;
  /** How much of that may lie before the piece, though the piece is to be seen. */
  ownCover: number;
  /** An edge whose two sides rise from it. */
  isValley: boolean;
}
