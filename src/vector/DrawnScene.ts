import type { DotSet } from './dots/placeDots.js';
import type { EngravedLook } from './Engraver.js';
import type { LineSurface } from './LineSurface.js';
import type { OutlineLook, OutlineMesh } from './outlines/OutlineMesh.js';
import type { CameraMatrices } from './Projection.js';
import type { Clip } from './paint/Clip.js';
import type { Veil } from './paint/Fading.js';
import type { Cutout, PaintLook } from './paint/PaintLook.js';
import type { Field } from './shading/fieldAxis.js';
import type { DotLayers, DotSize } from './shading/stipple.js';
import type { Illumination, SurfaceLook } from './Toner.js';

/** The lines of a surface where shadows of some lights turn them. */
export interface TurnedLines {
  /** The lights that do not arrive, as bits. */
  shadows: number;
  engraved: EngravedLook;
  field: Field | null;
}

/** A surface whose lines are engraved. */
export interface EngravedSurface {
  surface: LineSurface;
  engraved: EngravedLook;
  /** Of the first family; null for lines that follow the form. */
  field: Field | null;
  /** Other lines for other shadows. */
  turned: readonly TurnedLines[];
  look: SurfaceLook;
  /** Whether it hides what is behind it, and so is among what rays meet. */
  hides: boolean;
  /** Null where neither textures nor colours of vertices count. */
  paint: PaintLook | null;
  /** Null where nothing is clipped. */
  clip: Clip | null;
  /** As in `#1c1a17`. */
  ink: string;
}

/** A surface whose dots are drawn. The field space of its places is that of the object. */
export interface StippledSurface {
  surface: LineSurface;
  size: DotSize;
  set: DotSet;
  layers: DotLayers;
  look: SurfaceLook;
  /** Null where neither textures nor colours of vertices count. */
  paint: PaintLook | null;
  /** Null where nothing is clipped. */
  clip: Clip | null;
  ink: string;
}

/** A field of ruled lines behind a subject. */
export interface DrawnBackground {
  /** As of `HatchingBackground`: shares, pixels, radians and sizes of the subject. */
  tone: number;
  contrast: number;
  spacing: number;
  angle: number;
  extent: number;
  /** Where the subject lies on the sheet, from −1 to 1, y up. */
  seen: { left: number; right: number; bottom: number; top: number };
  /** Towards the light on the sheet, of length 1 where it comes from the side. */
  lit: readonly [number, number];
  /** The lower left corner of the sheet and its size, in widths and heights of the picture. */
  sheet: readonly [x: number, y: number, width: number, height: number];
  ink: string;
}

export interface OutlinedMesh {
  mesh: OutlineMesh;
  look: OutlineLook;
  /** Null where nothing is clipped. */
  clip: Clip | null;
  ink: string;
}

/** All that a drawing is made of, as plain data. */
export interface DrawnScene {
  camera: CameraMatrices;
  /** The triangles that hide and cast shadows: nine numbers each, world space, and bits of their sides. */
  corners: Float64Array;
  sides: Uint8Array;
  /** Of the triangles that have holes or are clipped, in their order. */
  cutouts: readonly Cutout[];
  /** See-through triangles, in their order. */
  veils: readonly Veil[];
  surfaces: readonly EngravedSurface[];
  stippled: readonly StippledSurface[];
  outlines: readonly OutlinedMesh[];
  backgrounds: readonly DrawnBackground[];
  illumination: Illumination;
}

/** The sheet and the way of drawing. Lengths in millimetres. */
export interface DrawingPlan {
  width: number;
  height: number;
  margin: number;
  /** The width of a pen; null for filled outlines whose width is the tone. */
  pen: number | null;
  /** The width of the thinnest line of a print; 0 for none. */
  leastWidth: number;
  /** CSS pixels to an inch of the sheet, which the sizes of materials and outlines are measured in. */
  dpi: number;
  order: 'travel' | 'drawn';
  paper: string | null;
  /** Seconds that the drawing takes to draw itself; null for one that stands still. */
  animate: number | null;
  /** A data URL of a picture below the lines; null for none. */
  picture: string | null;
}
