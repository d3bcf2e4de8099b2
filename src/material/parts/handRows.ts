import { runsAway } from '../../look/queries.js';
import { HandTextures } from '../tam/HandTextures.js';
import type { MaterialPart } from './MaterialPart.js';

/** Pixels to a millimetre of the sheet, where a material gives no width of strokes. */
const PIXELS_PER_MILLIMETRE = 6;

const textures = new HandTextures();

/** What the technique `pen` with a hand needs in GLSL and in nodes alike. */
export const part: Required<Pick<MaterialPart, 'checkHand' | 'profilesOf' | 'writeUniforms'>> = {
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
    const { count, offset, halfWidth, bundled, laneOffset, laneShift, filled, shorter, spacing, cell } = drawn.profiles;
    u.handReach.value.set(count, offset + bundled + laneOffset, halfWidth, filled);
    u.handRows.value.set(shorter, bundled);
    u.handLanes.value.set(laneOffset, laneShift);
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
