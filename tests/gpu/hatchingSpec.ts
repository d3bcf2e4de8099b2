import type { StrokeDirection } from '../../src/look/hatchingProperties.js';
import type { Hand } from '../../src/strokes/hand/Hand.js';
import type { ReferenceLight, ReferenceMaterial } from '../reference/hatchingReference.js';
import type { ReferenceCamera } from '../reference/rasterizeReference.js';
import type { AnalyticMapName } from './analyticMaps.js';
import type { Quadratic } from './quadratics.js';

/** Properties of lines alone. */
export interface LineSettings {
  direction: 'light' | 'towardsLight' | 'x' | 'y' | 'z' | 'slant' | 'form' | 'acrossForm';
  /** For the last two: the functions whose level sets are lines, and those of the crossing lines. */
  form?: readonly [first: Quadratic, crossing: Quadratic];
  lineSpacing: number;
  strokeLength: number;
  crossFrom: number;
  crossAngle: number;
  irregularity: number;
  /** Default: 'engraving'. */
  technique?: 'engraving' | 'pen' | 'woodcut';
  /** With the technique `pen`: its numbers take the place of those above. */
  hand?: Hand;
}

/** A picture to render, as plain data: what the test page and the reference both understand. */
export interface HatchingSpec {
  width: number;
  height: number;
  /** xyz per vertex. */
  positions: number[];
  /** xyz per vertex, if the mesh has normals of its own. */
  normals?: number[];
  indices: number[];
  matrixWorld: number[];
  camera: ReferenceCamera;
  orthographic?: boolean;
  lights: ReferenceLight[];
  material: Omit<ReferenceMaterial, 'ink' | 'paper' | 'color'> & { ink: number[]; paper: number[]; color: number[] };
  map: AnalyticMapName;
  /** For strokes and dots, which draw the mesh unprepared, with its own normals and hard edges. */
  latticeSpacing?: number;
  /** The field of strokes, if not that of the light: for the form, the baked functions. */
  strokes?: { direction: StrokeDirection; form?: readonly [first: Quadratic, crossing: Quadratic] };
  screenSpaceShare?: number;
  /** For the technique `stipple`: the dots. */
  dots?: { strokeWidth: number; edgePixels: number };
  /** For techniques of lines, which draw the mesh unprepared too. */
  lines?: LineSettings;
  doubleSided?: boolean;
  /** Importance of the mesh. Default: 1. */
  importance?: number;
}
