import type { HiddenOutlines } from '../../look/hiddenOutlines.js';
import type { Vec3 } from '../../look/vectors.js';
import type { Matrix } from '../Projection.js';
import type { ObjectFading } from '../shading/fading.js';
import type { LiftedPiece } from '../shading/outlines.js';

/** The mesh whose outlines are drawn. */
export interface OutlineMesh {
  /** Points, one for each normal at a vertex: position and unit normal, three numbers each, object space. */
  positions: Float32Array | Float64Array;
  normals: Float32Array | Float64Array;
  /** Positions at rest. */
  anchors: Float32Array;
  /** Six numbers per point, xx xy xz yy yz zz: the curvature tensor times the bounding radius. */
  curvatures: Float32Array;
  /** Index of the place of each point. */
  placeOf: Uint32Array;
  /** Points of the triangles. */
  triangles: Uint32Array;
  /** For each triangle the distance of the lines there, object units. */
  spacings: Float32Array;
  edges: readonly FeatureEdge[];
  /** Radius of the bounding sphere, object units. */
  radius: number;
  toWorld: Matrix;
  /** Rows of the matrix that transforms normals to world space. */
  normalToWorld: readonly [Vec3, Vec3, Vec3];
  /** World units per object unit, the mean over directions. */
  scale: number;
  /** Position of the eye, with w = 1; or the direction to it, with w = 0. Object space. */
  eye: readonly [x: number, y: number, z: number, w: number];
}

/** An edge, with the points at its ends for each of its two sides. */
export interface FeatureEdge {
  leftStart: number;
  leftEnd: number;
  rightStart: number;
  rightEnd: number;
  isBorder: boolean;
  isCrease: boolean;
  isMaterialBorder: boolean;
  /** Whether the sides are those of two surfaces that cut each other. */
  isIntersection: boolean;
  /** Whether the windings of the two sides are contrary. */
  isContrary: boolean;
  /** Whether a straight line of edges ends, branches or turns there. */
  isCornerAtStart: boolean;
  isCornerAtEnd: boolean;
  /** The distance of the lines there, object units. */
  spacing: number;
}

/** The appearance of outlines. */
export interface OutlineLook {
  /** Pixels. */
  width: number;
  /** The share of their ink that blending leaves, which the width takes account of. */
  opacity: number;
  contours: number;
  innerContours: number;
  borders: number;
  creases: number;
  materialBorders: number;
  /** The weight of lines where surfaces meet; 0 for none. */
  intersections: number;
  suggestiveContours: number;
  taper: number;
  shadeWeights: readonly [number, number];
  lostEdges: number;
  /** The extra weight of a contour where another one ends behind it. */
  accents: number;
  /** Length by which lines run beyond corners, pixels. */
  overshoot: number;
  /** Pixels. */
  wobble: number;
  /** How outlines behind a surface are drawn. */
  hidden: HiddenOutlines;
  /** Whether parts of the surface may be cut out, where there are no outlines. */
  isCutOut: boolean;
  /** Whether the back of the surface can be seen. */
  showsBack: boolean;
  /** Null where everything has its full weight. */
  fading: ObjectFading | null;
}

/** An end of a piece of outline. */
export interface PieceEnd {
  /** Object space; the normal is of any length. */
  position: Vec3;
  /** Object space, at rest. */
  anchor: Vec3;
  normal: Vec3;
  bend: number;
  /** Weights before paper, and before a surface. */
  weight: number;
  innerWeight: number;
  /** The share of the weight before paper that is left where edges are lost. */
  left: number;
  /** Length by which the outline runs beyond the end, pixels. */
  overshoot: number;
  /** Key of the place: ends with the same key are at one place. */
  key: string;
}

/** A piece of an outline. Lengths in object units. */
export interface OutlinePiece extends Omit<LiftedPiece, 'bend'> {
  start: PieceEnd;
  end: PieceEnd;
  /** The share of the piece that is a contour or a border. */
  contour: number;
  /** The distance of the lines there. */
  spacing: number;
}
