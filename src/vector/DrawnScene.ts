import type { EngravedLook } from './Engraver.js';
import type { LineSurface } from './LineSurface.js';
import type { OutlineLook, OutlineMesh } from './outlines/OutlineMesh.js';
import type { CameraMatrices } from './Projection.js';
import type { Clip, Cutout, PaintLook } from './paint/PaintLook.js';
import type { TranslucentRange } from './paint/Translucency.js';
import type { PenPlan } from './plot/pens.js';
import type { PlotterSpeeds } from './plot/plotTime.js';
import type { Field } from './shading/fieldAxis.js';
import type { DotLayers, DotSet, DotSize } from './shading/stipple.js';
import type { SurfaceLines } from './streamlines/SurfaceLines.js';
import type { Illumination, SurfaceLook } from './ToneReader.js';

/** The lines of a surface in the shadows of some lights, where lines turn. */
export interface TurnedLines {
  /** The lights that do not arrive, as bits. */
  shadows: number;
  engraved: EngravedLook;
  field: Field | null;
}

/** A surface with lines or dots. */
interface DrawnSurface {
  surface: LineSurface;
  look: SurfaceLook;
  /** Null without textures and vertex colours that affect tone. */
  paint: PaintLook | null;
  /** Null without clipping planes. */
  clip: Clip | null;
  /** Such as `#1c1a17`. */
  ink: string;
  /** The material or part that it belongs to, if these have layers of their own. */
  group: string;
}

/** A surface whose lines are engraved. */
export interface EngravedSurface extends DrawnSurface {
  engraved: EngravedLook;
  /** The field of the first family; null for lines that follow the form. */
  field: Field | null;
  /** The lines in shadows that turn them. */
  turned: readonly TurnedLines[];
  /** Whether it hides what is behind it, and so is part of the hierarchy. */
  hides: boolean;
}

/** A stippled surface. Its field space is object space. */
export interface StippledSurface extends DrawnSurface {
  size: DotSize;
  set: DotSet;
  layers: DotLayers;
}

/** A field of ruled lines behind a subject. */
export interface DrawnBackground {
  /** As in `HatchingBackground`: shares, pixels, radians and sizes of the subject. */
  tone: number;
  contrast: number;
  spacing: number;
  angle: number;
  extent: number;
  /** The subject on the sheet, in coordinates from −1 to 1, y up. */
  seen: { left: number; right: number; bottom: number; top: number };
  /** Towards the light on the sheet; of length 1 if it comes from the side. */
  lit: readonly [number, number];
  /** The lower left corner of the sheet and its size, in widths and heights of the picture. */
  sheet: readonly [x: number, y: number, width: number, height: number];
  ink: string;
}

export interface OutlinedMesh {
  mesh: OutlineMesh;
  look: OutlineLook;
  /** Null without clipping planes. */
  clip: Clip | null;
  ink: string;
  group: string;
}

/** The input of a drawing, as plain data. */
export interface DrawnScene {
  camera: CameraMatrices;
  /** The triangles that hide and cast shadows: nine numbers each, world space, and bits of their sides. */
  corners: Float64Array;
  sides: Uint8Array;
  /** Ranges of triangles that have holes or are clipped, in order. */
  cutouts: readonly Cutout[];
  /** Ranges of see-through triangles, in order. */
  translucent: readonly TranslucentRange[];
  surfaces: readonly EngravedSurface[];
  stippled: readonly StippledSurface[];
  outlines: readonly OutlinedMesh[];
  backgrounds: readonly DrawnBackground[];
  illumination: Illumination;
}

/** The sheet and the options of drawing. Lengths in millimetres. */
export interface DrawingPlan {
  width: number;
  height: number;
  margin: number;
  /** The pens of a plotter; null for filled outlines whose width is the tone. */
  pens: PenPlan | null;
  /** Whether the lines of a pen are placed on the sheet evenly, or lie where the canvas has them. */
  lines: 'even' | 'canvas';
  /** The even lines of the frame before, none for the first one; null for a picture of its own. */
  before: readonly SurfaceLines[] | null;
  /** Shorter lines of a pen are omitted. */
  shortest: number;
  /** The greatest number of times that pens pass over a place. */
  maxPasses: number;
  /** The width of the thinnest line of a print; 0 for no limit. */
  leastWidth: number;
  /** CSS pixels per inch of the sheet, for the sizes of materials and outlines. */
  dpi: number;
  order: 'travel' | 'drawn';
  plotter: PlotterSpeeds;
  /** Whether each pen has a file of its own, too. */
  isSplit: boolean;
  /** Whether a DXF file is written, too. */
  hasDxf: boolean;
  /** The words of the user in a note, which tells of pens, too; null for no note. */
  note: string | null;
  paper: string | null;
  /** Duration of the animation in seconds; null for a still drawing. */
  animate: number | null;
  /** Data URL of a picture below the lines; null for none. */
  picture: string | null;
}
