import type { Vec3 } from '../../look/vectors.js';
import type { Mat3 } from '../shading/screenGradient.js';
import type { ColorTones } from '../shading/tone.js';

/** The pixels of a texture. */
export interface ToneImage {
  width: number;
  height: number;
  /** Red, green, blue and alpha of each pixel in linear light; the first row is at v = 0. */
  data: Float32Array;
}

/** Wrapping beyond the edges of an image. */
export type Wrapping = 'repeat' | 'mirror' | 'clamp';

/** A texture on a surface. */
export interface MapLook {
  image: ToneImage;
  /** Offset of its coordinates in the details of a vertex. */
  uv: number;
  /** Transform of coordinates: u' = a u + b v + c, v' = d u + e v + f. */
  transform: readonly [a: number, b: number, c: number, d: number, e: number, f: number];
  wrapU: Wrapping;
  wrapV: Wrapping;
  /** Whether pixels are not interpolated. */
  isSharp: boolean;
}

/** The textures that affect tone, named as in three.js. */
export const TONE_MAPS = ['map', 'emissiveMap', 'aoMap', 'lightMap', 'alphaMap', 'normalMap', 'bumpMap'] as const;
export type ToneMap = (typeof TONE_MAPS)[number];

/** Textures and colours of a surface. Colours are in linear light. */
export interface PaintLook extends Readonly<Record<ToneMap, MapLook | null>> {
  color: Vec3;
  opacity: number;
  /** Emissive colour. */
  emissive: Vec3;
  /** How the colour becomes darkness. */
  tones: ColorTones;
  /** How many levels coarser than the picture the map is read for it. */
  mapBlur: number;
  /** Offset of the vertex colour (red, green, blue, alpha) in the details of a vertex; null for none. */
  vertexColor: number | null;
  aoMapIntensity: number;
  lightMapIntensity: number;
  /** The factors on the two slopes of a normal map. */
  normalScale: readonly [number, number];
  /** The matrix from object space to world space for a map in object space; null for tangent space. */
  normalToWorld: Mat3 | null;
  /** The factor on the heights of a bump map, which is null if there is a normal map. */
  bumpScale: number;
  /** Alpha below which nothing is drawn; 0 for none. */
  alphaTest: number;
}

/** A range of triangles of the scene with holes. */
export interface Cutout {
  /** The first of them, and the end of the range. */
  first: number;
  end: number;
  /** Their paint, if there are holes by alpha; otherwise null. */
  painted: { details: SurfaceDetails; paint: PaintLook } | null;
  /** Clipping planes of the visible surface, and of its shadow. */
  clip: Clip | null;
  shadowClip: Clip | null;
}

/** Numbers of vertices that only some surfaces have, linear over the triangles of the scene, however small these are subdivided later. */
export interface SurfaceDetails {
  /** The first triangle of the scene that belongs to the surface, and the vertices of the corners of all its triangles. */
  firstTriangle: number;
  corners: ArrayLike<number>;
  /** Count of numbers per vertex, and the numbers. */
  stride: number;
  numbers: ArrayLike<number>;
  /**
   * Offset of the nine numbers, row by row, of the map from view to field of a surface that deforms, whose field is that of the surface at
   * rest. Null if one map serves the whole surface.
   */
  viewToField: number | null;
}

/** The maps from view to field at a place on a surface that deforms: of the smooth surface, and of the flat triangle. */
export interface PosedMaps {
  smooth: Mat3;
  flat: Mat3;
}

/** A clipping plane, which cuts where n·p + d is below 0. World space. */
export type ClipPlane = readonly [x: number, y: number, z: number, d: number];

/** The clipping planes of a surface. */
export interface Clip {
  /** Each of these planes cuts what lies beyond it. */
  each: readonly ClipPlane[];
  /** These planes cut only what lies beyond all of them. */
  together: readonly ClipPlane[];
}

const isBeyond = ([x, y, z, d]: ClipPlane, place: Vec3): boolean => x * place[0] + y * place[1] + z * place[2] + d < 0;

/** Whether a place is clipped. */
export const isClipped = ({ each, together }: Clip, place: Vec3): boolean =>
  each.some((plane) => isBeyond(plane, place)) ||
  (together.length > 0 && together.every((plane) => isBeyond(plane, place)));

/** The effect of textures and colours at a place. */
export interface Paint {
  /** The share to which the colour brings the tone to that of no light. */
  darkness: number;
  /** Emitted luminance. */
  emitted: number;
  /** Ambient light added by a light map, and the share of it that an occlusion map leaves. */
  around: number;
  open: number;
  /** Alpha minus its threshold: above 0 where the surface is not cut out; 1 if nothing is. */
  alphaMargin: number;
}
