import { runsAway } from '../../look/queries.js';
import { HAND_STROKE_CONSTANTS, HAND_TEXTURE, MOST_ROWS } from '../../strokes/handConstants.js';
import { definesOf } from '../shaders/shaderText.js';
import { HandTextures } from '../tam/HandTextures.js';
import type { MaterialPart } from './MaterialPart.js';
import { surface } from './surface.js';

/** Pixels to a millimetre of the sheet, where a material gives no width of strokes. */
const PIXELS_PER_MILLIMETRE = 6;

const {
  './chunks/handStrokes.glsl': rows,
  './chunks/handShadowStrokes.glsl': inShadows,
  ...shadows
} = import.meta.glob<string>('./chunks/{handStrokes,handShadowStrokes,strokeShadows}.glsl', {
  base: '../../../shaders',
  query: '?raw',
  import: 'default',
  eager: true,
});

const textures = new HandTextures();

/** The technique `pen` with a hand, beyond what the part of lines has. */
export const part: MaterialPart = {
  surface,
  files: {
    ...shadows,
    './chunks/shadowStrokes.glsl': inShadows,
    // Rows of strokes are drawn in the place of lines.
    './techniques/lines/ruledLines.glsl': [
      definesOf({ ...HAND_STROKE_CONSTANTS, ...HAND_TEXTURE }),
      definesOf({ MOST_ROWS }, ''),
      rows,
    ].join('\n'),
  },
  checkHand(hand) {
    textures.profilesOf(hand);
  },
  profilesOf(hand) {
    return textures.profilesOf(hand);
  },
  writeUniforms(u, material, pixelRatio) {
    const { hand, screenSpaceShare, strokeWidth } = material;
    if (hand === null) return;
    const drawn = textures.use(material, hand);
    if (!drawn) return;
    u.handStrokes.value = drawn.texture;
    const { count, offset, halfWidth, bundled, filled, shorter, spacing, cell } = drawn.profiles;
    u.handReach.value.set(count, offset + bundled, halfWidth, filled);
    u.handRows.value.set(shorter, bundled);
    const { width, crossingAngle, crossingFrom } = hand.numbers;
    const pixels = strokeWidth === null ? PIXELS_PER_MILLIMETRE : strokeWidth / width;
    const onScreen = pixels * pixelRatio ** screenSpaceShare;
    u.lineSpacing.value = onScreen * spacing;
    u.strokeLength.value = onScreen * cell;
    u.irregularity.value = 0;
    const isCrossed = crossingAngle !== 0 && !runsAway(material);
    u.crossFrom.value = isCrossed ? crossingFrom : 1;
    const angle = (crossingAngle * Math.PI) / 180;
    const half = Math.abs(angle) / 2;
    // The third family leans to the side that the second does not.
    const side = crossingAngle < 0 ? -1 : 1;
    u.layerTurns.value.set(Math.cos(angle), Math.sin(angle), -Math.sin(half), side * Math.cos(half));
  },
};
