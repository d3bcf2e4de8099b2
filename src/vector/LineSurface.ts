import { combined, cross, normalize, type Vec3, vectorAt } from '../look/vectors.js';
import type { Projection } from './Projection.js';
import type { Paint, PosedMaps, SurfaceDetails } from './paint/PaintLook.js';
import type { FormAt } from './shading/lineFunctions.js';
import type { Mat3 } from './shading/screenGradient.js';

/** Offsets of the numbers of a vertex within its `STRIDE`. */
export const WORLD = 0;
export const VIEW = 3;
export const FIELD = 6;
/** Normal smoothed to the scale of a stroke, field space. */
export const FIELD_NORMAL = 9;
/** World space. */
export const TONE_NORMAL = 12;
/** Of the front, then of the back. */
export const OCCLUSION = 15;
/** The two functions of the form: gradient per tile and rest, as in `formVarying`. */
export const FORM = 17;
export const STRIDE = 25;

/** A surface with lines: triangles over which all numbers of vertices are linear. */
export interface LineSurface {
  /** `STRIDE` numbers per vertex. Vertices at one place have bit-identical WORLD, VIEW and FIELD. */
  vertices: Float64Array;
  /** Index of the place of each vertex. */
  placeOf: Int32Array;
  /** Vertices of corners; the front is counter-clockwise as seen. */
  triangles: Int32Array;
  /** The triangle of the scene that each triangle is a part of. */
  parents: Int32Array;
  /** Which sides are drawn. */
  drawsFront: boolean;
  drawsBack: boolean;
  /** Transforms normals from field space to view space, as a factor on the right. */
  viewToField: Mat3;
  /** Null without further numbers. */
  details: SurfaceDetails | null;
}

/** Properties of a triangle. */
export interface FlatTriangle {
  /** Field space, of any length. */
  flatNormal: Vec3;
  /** Whether its corners have the same tone normal. */
  isPlane: boolean;
}

/** A place on a surface. Normals are unit. */
export interface SurfacePlace extends FlatTriangle {
  world: Vec3;
  view: Vec3;
  field: Vec3;
  fieldNormal: Vec3;
  toneNormal: Vec3;
  occlusion: number;
  form: FormAt;
  formCrossing: FormAt;
  /** The maps of a surface that deforms; null for the surface's single map from view to field. */
  posed: PosedMaps | null;
  /** Null without textures and vertex colours that affect tone. */
  paint: Paint | null;
}

/** Numbers interpolated between two vertices. */
export function between(vertices: Float64Array, a: number, b: number, share: number): Float64Array {
  const [i, j] = [STRIDE * a, STRIDE * b];
  const numbers = new Float64Array(STRIDE);
  for (let k = 0; k < STRIDE; k++) numbers[k] = vertices[i + k] + share * (vertices[j + k] - vertices[i + k]);
  return numbers;
}

/**
 * The place with the given numbers.
 *
 * @param side 1 on front faces; −1 on back faces, whose tone normal is reversed, and which have an occlusion of their own
 * @param o offset of the numbers
 */
export function placeFrom(n: ArrayLike<number>, triangle: FlatTriangle, side: number, o = 0): SurfacePlace {
  const toneNormal = normalize(vectorAt(n, o + TONE_NORMAL));
  return {
    world: vectorAt(n, o + WORLD),
    view: vectorAt(n, o + VIEW),
    field: vectorAt(n, o + FIELD),
    fieldNormal: normalize(vectorAt(n, o + FIELD_NORMAL)),
    toneNormal: side < 0 ? [-toneNormal[0], -toneNormal[1], -toneNormal[2]] : toneNormal,
    ...triangle,
    occlusion: n[o + OCCLUSION + (side < 0 ? 1 : 0)],
    form: { gradient: vectorAt(n, o + FORM), rest: n[o + FORM + 3] },
    formCrossing: { gradient: vectorAt(n, o + FORM + 4), rest: n[o + FORM + 7] },
    posed: null,
    paint: null,
  };
}

/** The place of a vertex of a triangle. */
export const placeOfVertex = (surface: LineSurface, vertex: number, triangle: number, side: number): SurfacePlace =>
  placeFrom(surface.vertices, readTriangle(surface, triangle), side, STRIDE * vertex);

/** The vertices of the corners of a triangle. */
export const cornersOf = ({ triangles }: LineSurface, triangle: number): Vec3 => vectorAt(triangles, 3 * triangle);

/** The position of a vertex on the picture, pixels. */
export const onPicture = (
  { vertices }: LineSurface,
  vertex: number,
  projection: Projection,
): readonly [number, number] => projection.project(...vectorAt(vertices, STRIDE * vertex + VIEW));

export function readTriangle(surface: LineSurface, triangle: number): FlatTriangle {
  const { vertices } = surface;
  const [a, b, c] = cornersOf(surface, triangle);
  const first = vectorAt(vertices, STRIDE * a + FIELD);
  return {
    flatNormal: cross(
      combined(1, vectorAt(vertices, STRIDE * b + FIELD), -1, first),
      combined(1, vectorAt(vertices, STRIDE * c + FIELD), -1, first),
    ),
    isPlane: hasOneToneNormal(vertices, a, b) && hasOneToneNormal(vertices, a, c),
  };
}

function hasOneToneNormal(vertices: Float64Array, a: number, b: number): boolean {
  const [i, j] = [STRIDE * a + TONE_NORMAL, STRIDE * b + TONE_NORMAL];
  return vertices[i] === vertices[j] && vertices[i + 1] === vertices[j + 1] && vertices[i + 2] === vertices[j + 2];
}
