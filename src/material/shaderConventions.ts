import { cornerLayout } from '../bake/cornerLayout.js';

export const TONE_MODELS = ['lambert', 'halfLambert', 'phong', 'toon'] as const;
/**
 * How light becomes tone (paper, section 3.4 and figure 9).
 * - `lambert`: N·L.
 * - `halfLambert`: (N·L / 2 + 1/2)², which reaches round to the side turned away.
 * - `phong`: Lambert plus a highlight (R·V)^shininess.
 * - `toon`: Lambert in `toneSteps` hard bands, each of them one tone.
 */
export type ToneModel = (typeof TONE_MODELS)[number];

export const TONE_NORMALS = ['face', 'smooth'] as const;
/** The normal tone is computed from: that of the flat triangle, as in the paper, or the interpolated vertex normal. */
export type ToneNormal = (typeof TONE_NORMALS)[number];

export const DEBUG_VIEWS = ['none', 'blendFactors', 'tone', 'frames'] as const;
/**
 * - `blendFactors`: the contributions of α, β, γ as red, green, blue (figure 8).
 * - `tone`: the wanted tone as grey.
 * - `frames`: a checker in the stroke coordinates of the triangle itself.
 */
export type DebugView = (typeof DEBUG_VIEWS)[number];

export const TONE_CURVES = ['linear', 'perceptual', 'points'] as const;
/** The most spans a tone curve of one's own can have: one less than it has points. */
export const TONE_CURVE_SPANS = 7;

export const LEVEL_RULES = ['derivatives', 'depth'] as const;
/**
 * From what `triangle` and `adjacency` choose the level of the map.
 * - `derivatives`: from how fast texture coordinates change on the screen, foreshortening included. Strokes are never finer
 *   than drawn, and wider where the surface is seen at a slant.
 * - `depth`: from the depth of the fragment alone (paper, section 3.4). Strokes are as wide as drawn where the surface is
 *   seen face on, and foreshortened like the surface elsewhere.
 */
export type LevelRule = (typeof LEVEL_RULES)[number];

export const INK_BLENDS = ['cover', 'multiply'] as const;
/**
 * What ink does to the colour below it.
 * - `cover`: hides it, as gouache or a printer's black.
 * - `multiply`: tints it, as transparent ink.
 */
export type InkBlend = (typeof INK_BLENDS)[number];

export const STROKE_ANCHORS = ['rest', 'deformed'] as const;
/**
 * What strokes are fixed to on a mesh that deforms.
 * - `rest`: to the surface. Coordinates are those of the rest pose, and the light is carried into it.
 * - `deformed`: to object space, through which the surface moves; the paper to the letter.
 */
export type StrokeAnchor = (typeof STROKE_ANCHORS)[number];

export const VERTEX_LAYOUTS = ['corner', 'pull', 'deforming'] as const;
/** Where a vertex finds its adjacency primitive: in its attributes, in textures, or in textures that a pre-pass writes. */
export type VertexLayout = (typeof VERTEX_LAYOUTS)[number];

const constantCase = (name: string) => name.replace(/([A-Z])/g, '_$1').toUpperCase();

const numbered = (prefix: string, names: readonly string[]) =>
  names.map((name, index) => `#define ${prefix}_${constantCase(name)} ${index}`).join('\n');

/** The names TypeScript and GLSL share, as defines. Which of them is chosen is a define of the material. */
export const conventionsChunk = (): string =>
  [
    numbered('TONE_MODEL', TONE_MODELS),
    numbered('TONE_NORMAL', TONE_NORMALS),
    numbered('TONE_CURVE', TONE_CURVES),
    numbered('LEVEL_RULE', LEVEL_RULES),
    numbered('INK_BLEND', INK_BLENDS),
    numbered('DEBUG_VIEW', DEBUG_VIEWS),
    `#define TONE_CURVE_SPANS ${TONE_CURVE_SPANS}`,
    numbered('STROKE_ANCHOR', STROKE_ANCHORS),
    numbered('VERTEX_LAYOUT', VERTEX_LAYOUTS),
  ].join('\n');

/** Declarations of the attributes of the `corner` layout. */
export const cornerAttributesChunk = (): string =>
  cornerLayout.map(({ name, itemSize }) => `attribute vec${itemSize} ${name};`).join('\n');
