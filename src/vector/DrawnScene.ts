import type { Field } from '../engraving/fieldAxis.js';
import type { EngravedLook } from './Engraver.js';
import type { LineSurface } from './LineSurface.js';
import type { OutlineLook, OutlineMesh } from './OutlineMesh.js';
import type { MeanLight } from './outlineChains.js';
import type { CameraMatrices } from './Projection.js';
import type { Clip } from './paint/Clip.js';
import type { Cutout, PaintLook } from './paint/PaintLook.js';
import type { Illumination, SurfaceLook } from './Toner.js';

/** A surface whose lines are engraved. */
export interface EngravedSurface {
  surface: LineSurface;
  engraved: EngravedLook;
  /** Of the first family; null for lines that follow the form. */
  field: Field | null;
  look: SurfaceLook;
  /** Null where neither textures nor colours of vertices count. */
  paint: PaintLook | null;
  /** Null where nothing is clipped. */
  clip: Clip | null;
  /** As in `#1c1a17`. */
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
  surfaces: readonly EngravedSurface[];
  outlines: readonly OutlinedMesh[];
  illumination: Illumination;
  meanLight: MeanLight;
}

/** The sheet and the way of drawing. Lengths in millimetres. */
export interface DrawingPlan {
  width: number;
  height: number;
  margin: number;
  /** The width of a pen; null for filled outlines whose width is the tone. */
  pen: number | null;
  /** CSS pixels to an inch of the sheet, which the sizes of materials and outlines are measured in. */
  dpi: number;
  order: 'travel' | 'drawn';
  paper: string | null;
}
