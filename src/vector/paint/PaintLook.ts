import type { Vec3 } from '../../look/vectors.js';
import type { Mat3 } from '../shading/screenGradient.js';
import type { Clip } from './Clip.js';
import type { SurfaceDetails } from './SurfaceDetails.js';

/** The pixels of a texture. */
export interface ToneImage {
  width: number;
  height: number;
  /** Red, green, blue and alpha of each pixel in linear light; the first row lies at v = 0. */
  data: Float32Array;
}

/** What lies beyond the edge of an image. */
export type Wrapping = 'repeat' | 'mirror' | 'clamp';

/** A texture on a surface. */
export interface MapLook {
  image: ToneImage;
  /** Where its coordinates lie among the details of a vertex. */
  uv: number;
  /** What coordinates go through: u' = a u + b v + c, v' = d u + e v + f. */
  transform: readonly [a: number, b: number, c: number, d: number, e: number, f: number];
  wrapU: Wrapping;
  wrapV: Wrapping;
  /** Whether pixels have edges, not ramps between them. */
  isSharp: boolean;
}

/** What differs from place to place in how a surface shows the light: its textures and colours. Colours are in linear light. */
export interface PaintLook {
  color: Vec3;
  opacity: number;
  /** Of what the surface gives off. */
  emissive: Vec3;
  /** How much of the darkness of the colour becomes tone, and what its lightness is multiplied by. */
  localTone: number;
  colorExposure: number;
  /** Where the red, green, blue and alpha of vertices lie among their details; null where they have no colours. */
  vertexColor: number | null;
  map: MapLook | null;
  emissiveMap: MapLook | null;
  aoMap: MapLook | null;
  aoMapIntensity: number;
  lightMap: MapLook | null;
  lightMapIntensity: number;
  alphaMap: MapLook | null;
  /** Normals in the space of the surface and its coordinates, and what their two slopes are multiplied by. */
  normalMap: MapLook | null;
  normalScale: readonly [number, number];
  /** Takes normals of the map to the world where it has those of the object; null where it has those of the surface. */
  normalToWorld: Mat3 | null;
  /** Heights in its red, and what they are multiplied by; null where a map of normals takes its place. */
  bumpMap: MapLook | null;
  bumpScale: number;
  /** Nothing is there where alpha is below this; 0 cuts nothing out. */
  alphaTest: number;
}

/** Triangles of the scene of which not all is there. */
export interface Cutout {
  /** The first of them, and the first after them. */
  first: number;
  end: number;
  /** Where their alpha is too low there are holes; null where they have none. */
  painted: { details: SurfaceDetails; paint: PaintLook } | null;
  /** What clipping planes leave of them, as they are seen and as they cast shadows. */
  clip: Clip | null;
  shadowClip: Clip | null;
}
