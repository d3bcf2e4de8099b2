import { cornerLayout } from '../bake/cornerLayout.js';
import { HATCHING_PROPERTIES } from './hatchingProperties.js';

export const TONE_CURVES = ['linear', 'perceptual', 'points'] as const;
/** The most spans a tone curve of one's own can have: one less than it has points. */
export const TONE_CURVE_SPANS = 7;

export const VERTEX_LAYOUTS = ['corner', 'pull', 'deforming'] as const;
/** Where a vertex finds its adjacency primitive: in its attributes, in textures, or in textures that a pre-pass writes. */
export type VertexLayout = (typeof VERTEX_LAYOUTS)[number];

const numbered = (prefix: string, names: readonly string[]) =>
  names.map((name, index) => `#define ${prefix}_${constantCase(name)} ${index}`);

const constantCase = (name: string) => name.replace(/([A-Z])/g, '_$1').toUpperCase();

/** The names TypeScript and GLSL share, as defines. Which of them is chosen is a define of the material. */
export const conventionsChunk = [
  ...Object.values(HATCHING_PROPERTIES).flatMap((property) =>
    property.kind === 'choice' ? numbered(property.define, property.choices) : [],
  ),
  ...numbered('TONE_CURVE', TONE_CURVES),
  `#define TONE_CURVE_SPANS ${TONE_CURVE_SPANS}`,
  ...numbered('VERTEX_LAYOUT', VERTEX_LAYOUTS),
  // The triangles c, α, β, γ, or c alone.
  '#if TECHNIQUE == TECHNIQUE_ADJACENCY\n#define TRIANGLE_COUNT 4\n#else\n#define TRIANGLE_COUNT 1\n#endif // TECHNIQUE',
  '#if VERTEX_LAYOUT == VERTEX_LAYOUT_DEFORMING && STROKE_ANCHOR == STROKE_ANCHOR_REST\n#define ANCHORED_AT_REST\n#endif // VERTEX_LAYOUT',
].join('\n');

/** Declarations of the attributes of the `corner` layout. */
export const cornerAttributesChunk = cornerLayout
  .map(({ name, itemSize }) => `attribute vec${itemSize} ${name};`)
  .join('\n');
