import { combined, cross, normalize, type Vec3 } from '../look/vectors.js';
import type { Paint } from './paint/ColourReader.js';
import type { PosedMaps, SurfaceDetails } from './paint/SurfaceDetails.js';
import type { FormAt } from './shading/readForm.js';
import type { Mat3 } from './shading/screenGradient.js';

/** Where the numbers of a vertex lie among its `STRIDE` ones. */
export const WORLD = 0;
export const VIEW = 3;
export const FIELD = 6;
/** At the scale of a stroke, field space. */
export const FIELD_NORMAL = 9;
/** World space. */
export const TONE_NORMAL = 12;
export const OCCLUSION = 15;
/** The two functions of the form: gradient per tile and rest, as `formVarying` has them. */
export const FORM = 16;
export const STRIDE = 24;

/** A surface whose lines are drawn: triangles of vertices of which all numbers are linear over a triangle. */
export interface LineSurface {
  /** `STRIDE` numbers per vertex. Vertices at one place have the same WORLD, VIEW and FIELD, bit by bit. */
  vertices: Float64Array;
  /** The place of each vertex. */
  placeOf: Int32Array;
  /** The vertex of each corner; the front is counter-clockwise as seen. */
  triangles: Int32Array;
  /** The triangle of the scene that each triangle is a part of. */
  parents: Int32Array;
  /** Which sides are drawn. */
  drawsFront: boolean;
  drawsBack: boolean;
  /** Takes normals of the field to the view, as a factor on the right. */
  viewToField: Mat3;
  /** Null for surfaces that have nothing more. */
  details: SurfaceDetails | null;
}

/** What all places of a triangle share. */
export interface FlatTriangle {
  /** In field space, of any length. */
  flatNormal: Vec3;
  /** Whether its corners have one tone normal. */
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
  /** Of a surface that deforms, in place of its one map from the view to the field. */
  posed: PosedMaps | null;
  /** Of a surface with textures or colours that count. */
  paint: Paint | null;
}

/** The numbers at a share of the way from one vertex to another. */
export function between(vertices: Float64Array, a: number, b: number, share: number): Float64Array {
  const [i, j] = [STRIDE * a, STRIDE * b];
  const numbers = new Float64Array(STRIDE);
  for (let k = 0; k < STRIDE; k++) numbers[k] = vertices[i + k] + share * (vertices[j + k] - vertices[i + k]);
  return numbers;
}

/**
 * The place that has numbers.
 *
 * @param side 1, or −1 where the back is seen, whose tone normal looks the other way
 * @param o where the numbers begin
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
    occlusion: n[o + OCCLUSION],
    form: { gradient: vectorAt(n, o + FORM), rest: n[o + FORM + 3] },
    formCrossing: { gradient: vectorAt(n, o + FORM + 4), rest: n[o + FORM + 7] },
    posed: null,
    paint: null,
  };
}

const vectorAt = (n: ArrayLike<number>, o: number): Vec3 => [n[o], n[o + 1], n[o + 2]];

/** The place of a vertex, as a triangle has it. */
export const placeOfVertex = (surface: LineSurface, vertex: number, triangle: number, side: number): SurfacePlace =>
  placeFrom(surface.vertices, readTriangle(surface, triangle), side, STRIDE * vertex);

export function readTriangle({ vertices, triangles }: LineSurface, triangle: number): FlatTriangle {
  const a = STRIDE * triangles[3 * triangle];
  const b = STRIDE * triangles[3 * triangle + 1];
  const c = STRIDE * triangles[3 * triangle + 2];
  const first = vectorAt(vertices, a + FIELD);
  return {
    flatNormal: cross(
      combined(1, vectorAt(vertices, b + FIELD), -1, first),
      combined(1, vectorAt(vertices, c + FIELD), -1, first),
    ),
    isPlane: hasOneToneNormal(vertices, a, b) && hasOneToneNormal(vertices, a, c),
  };
}

function hasOneToneNormal(vertices: Float64Array, a: number, b: number): boolean {
  const [i, j] = [a + TONE_NORMAL, b + TONE_NORMAL];
  return vertices[i] === vertices[j] && vertices[i + 1] === vertices[j + 1] && vertices[i + 2] === vertices[j + 2];
}
