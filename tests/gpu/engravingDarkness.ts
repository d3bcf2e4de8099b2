import { mat4, vec3 } from 'gl-matrix';
import { LINE_CONSTANTS } from '../../src/look/constants/lineConstants.js';
import { combined, dot, normalize, type Vec3 } from '../../src/look/vectors.js';
import { MOST_ROWS } from '../../src/strokes/handConstants.js';
import { strokeProfiles } from '../../src/strokes/strokeProfiles.js';
import { type EngravedLook, Engraver } from '../../src/vector/Engraver.js';
import type { SurfacePlace } from '../../src/vector/LineSurface.js';
import type { FamilyMeasure, HandPlace } from '../../src/vector/lineMarks.js';
import { Projection } from '../../src/vector/Projection.js';
import { cutFor, cutWidth } from '../../src/vector/shading/carving.js';
import { across, type CutDirection, type Field, fieldLight, firstField } from '../../src/vector/shading/fieldAxis.js';
import { handWidth } from '../../src/vector/shading/hand.js';
import { rowsFor, strokesOnRow } from '../../src/vector/shading/handStrokes.js';
import { formVarying } from '../../src/vector/shading/lineFunctions.js';
import { penFor, strokeAt } from '../../src/vector/shading/penStrokes.js';
import { powerOf2, roomOf } from '../../src/vector/shading/ruledLines.js';
import { changePerPixel, type Mat3 } from '../../src/vector/shading/screenGradient.js';
import type { HatchingReference, ReferenceLight } from '../reference/hatchingReference.js';
import type { Vec3 as List3 } from '../reference/referenceAdjacency.js';
import type { HatchingSpec } from './hatchingSpec.js';
import { quadraticAt, quadraticGradient } from './quadratics.js';
import type { DarknessOf } from './referenceCase.js';

const DIRECTED: readonly ReferenceLight['type'][] = ['directional', 'point', 'spot'];
const LUMINANCE: Vec3 = [0.2126, 0.7152, 0.0722];

/** Where a material gives no width of strokes. */
const PIXELS_PER_MILLIMETRE = 6;

/** The input of the darkness of engraved lines. */
export type EngravedScene = Pick<HatchingSpec, 'lights' | 'matrixWorld' | 'camera' | 'width' | 'height'> & {
  lines: NonNullable<HatchingSpec['lines']>;
  material: Pick<HatchingSpec['material'], 'strokeAngle' | 'tilesPerObjectUnit' | 'shadowStrokes'>;
  screenSpaceShare: number;
  /** The centre of the bounding sphere, object space. */
  centre: Vec3;
};

/** The darkness of engraved lines, by the functions that draw them in vector files. Light and tone are those of the reference. */
export function engravingDarkness(scene: EngravedScene, reference: HatchingReference): DarknessOf {
  const { lines, lights, matrixWorld, camera, material, screenSpaceShare, centre } = scene;
  const {
    direction,
    form,
    technique = 'engraving',
    lineSpacing,
    strokeLength,
    crossFrom,
    crossAngle,
    irregularity,
    hand = null,
  } = lines;
  const { tilesPerObjectUnit, strokeAngle, shadowStrokes } = material;
  const world = mat4.invert(mat4.create(), camera.view as unknown as mat4)!;
  const projection = new Projection({ ...camera, world, near: 0 }, scene.width, scene.height);
  const toObject = mat4.invert(mat4.create(), matrixWorld as unknown as mat4)!;
  const back = mat4.multiply(mat4.create(), toObject, world);
  const row = (i: number): Vec3 => [
    tilesPerObjectUnit * back[i],
    tilesPerObjectUnit * back[4 + i],
    tilesPerObjectUnit * back[8 + i],
  ];
  const viewToField: Mat3 = [row(0), row(1), row(2)];
  const profiles = hand && strokeProfiles(hand);
  const look: Omit<EngravedLook, 'direction'> = {
    ...{ technique, strokeLength, crossFrom, crossAngle, irregularity },
    spacing: { lineSpacing, minLineSpacing: 3, screenSpaceShare },
    crossesInShadows: shadowStrokes === 'cross',
    hand: profiles,
  };
  if (hand && profiles) {
    look.spacing.lineSpacing = PIXELS_PER_MILLIMETRE * profiles.spacing;
    look.strokeLength = PIXELS_PER_MILLIMETRE * profiles.cell;
    look.irregularity = 0;
    look.crossFrom = hand.numbers.crossingAngle === 0 ? 1 : hand.numbers.crossingFrom;
    look.crossAngle = (hand.numbers.crossingAngle * Math.PI) / 180;
  }

  const lightFrom = (arriving: readonly ReferenceLight[]): Field =>
    fieldLight(
      arriving.flatMap(({ type, position, target = [0, 0, 0], color }) => {
        if (!DIRECTED.includes(type)) return [];
        const isFar = type === 'directional';
        const inObject = (p: List3) => vec3.transformMat4([0, 0, 0], p, toObject) as List3;
        const way = combined(1, inObject(position!), -1, isFar ? inObject(target) : centre);
        return [{ toLight: combined(tilesPerObjectUnit, way, 0, way), luminance: dot(color, LUMINANCE), isFar }];
      }),
    );

  const engravers = new Map<string, Engraver>();
  /** Lines turn in the shadows of lights: what draws them where only some arrive. */
  function engraverFor(arriving: readonly ReferenceLight[]): Engraver {
    const key = lights.map((light) => arriving.includes(light)).join();
    const known = engravers.get(key);
    if (known) return known;
    const isDark = arriving.length < lights.length && !arriving.some(({ type }) => DIRECTED.includes(type));
    let engraver: Engraver;
    if (form) {
      const isAcross = (direction === 'acrossForm') !== isDark;
      engraver = new Engraver({ ...look, direction: isAcross ? 'acrossForm' : 'form' }, null, viewToField, projection);
    } else {
      const light = isDark ? { axis: across(lightFrom(lights).axis), bend: 0 } : lightFrom(arriving);
      const field = firstField(direction as CutDirection, light, strokeAngle);
      engraver = new Engraver({ ...look, direction }, field, viewToField, projection);
    }
    engravers.set(key, engraver);
    return engraver;
  }

  return (at, normal, litNormal, flatNormal, isPlane) => {
    const toneNormal = normalize(litNormal);
    const inWorld = reference.toWorld(at);
    const tone = reference.tone(inWorld, [...toneNormal], true, isPlane);
    const unshadowed = shadowStrokes === 'cross' ? reference.tone(inWorld, [...toneNormal], false, isPlane) : tone;
    if (tone >= 1) return 1;
    const field = combined(tilesPerObjectUnit, at, -tilesPerObjectUnit, centre);
    const [first, crossing] = (form ?? []).map((quadratic) =>
      formVarying(quadraticGradient(quadratic, [...field]), quadraticAt(quadratic, [...field]), field),
    );
    const none = { gradient: [0, 0, 0] as const, rest: 0 };
    const place: SurfacePlace = {
      ...{ world: inWorld, view: projection.toView(inWorld), field, fieldNormal: normalize(normal), toneNormal },
      ...{ flatNormal, isPlane, occlusion: 0, form: first ?? none, formCrossing: crossing ?? none },
      ...{ posed: null, paint: null },
    };
    const engraver = engraverFor(lights.filter((light) => !reference.turnsAway(light, [...toneNormal], inWorld)));
    const read = engraver.at(place);
    const tones = { tone, unshadowed, shadows: 0, left: 1, full: 0, turned: 0, dark: 0 };
    return (
      1 -
      engraver.families.reduce((blank, family) => {
        const gradient = engraver.gradientAt(family, read);
        // The change on the triangle, as on the canvas: lines are no closer than the smooth surface allows.
        const [smooth, seen] = [read.smooth, read.triangle].map((map) => changePerPixel(gradient, map));
        const perPixel = Math.max(seen, LINE_CONSTANTS.LEAST_OF_SMOOTH * smooth);
        const measure = { ...engraver.measure(family, read, tones), perPixel };
        const value = engraver.valueAt(family, read);
        return blank * (1 - (measure.hand ? rowsDarkness(measure, measure.hand) : familyDarkness(measure, value)));
      }, 1)
    );
  };
}

/** The share of a pixel that a line covers, by the distance from its middle and half its width, as in `lineCoverage.glsl`. */
export const coverage = (away: number, half: number): number =>
  Math.min(Math.max(Math.max(half, 0.5) + 0.5 - away, 0), 1) * Math.min(2 * half, 1);

/** The darkness of the strokes of a hand in the rows of a family, where its function has a value. */
function rowsDarkness({ tone, octave, perPixel }: FamilyMeasure, hand: HandPlace): number {
  if (tone === 0) return 0;
  const rows = rowsFor(hand, tone, octave, perPixel);
  const step = 0.5 * rows.period;
  let blank = 1;
  for (let k = Math.floor(rows.value / step) - MOST_ROWS; k <= rows.value / step + MOST_ROWS; k++)
    for (const { shift, half } of strokesOnRow(rows, k * step))
      blank *= 1 - coverage(Math.abs((rows.value - k * step) / perPixel - shift), half);
  return 1 - blank;
}

/** The darkness of one family, where its function has a value: the sum over the lines that may touch the pixel. */
function familyDarkness({ tone, octave, perPixel, widths, strokes }: FamilyMeasure, value: number): number {
  if (tone === 0) return 0;
  const isCut = strokes?.technique === 'woodcut';
  const spaced = isCut ? strokes.cutOctave : octave;
  const spacing = powerOf2(spaced);
  const cut = isCut && cutFor(tone, strokes.along, strokes.repeat, spaced);
  const pen = strokes?.technique === 'pen' && penFor(tone, strokes.along, strokes.irregularity, strokes.repeat, spaced);
  const top = Math.ceil(spaced);
  const step = 2 ** (top - 1);
  let covered = 0;
  for (let k = Math.floor(value / step) - 3; k <= value / step + 4; k++) {
    const line = k * step;
    const room = roomOf(k % 2 === 0 ? top : top - 1, spaced);
    let [width, away] = [room * tone * handWidth(line, widths), value - line];
    if (cut) width = room * cutWidth(cut, line);
    if (pen) {
      const stroke = strokeAt(pen, room / spacing, line);
      width = spacing * stroke.width;
      away -= spacing * stroke.astray;
    }
    covered += coverage(Math.abs(away) / perPixel, (0.5 * width) / perPixel);
  }
  return isCut ? 1 - Math.min(covered, 1) : Math.min(covered, 1);
}
