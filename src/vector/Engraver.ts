import { FIELD_CONSTANTS, LINE_CONSTANTS } from '../look/constants/engravedConstants.js';
import { combined, lengthOf, type Vec3 } from '../look/vectors.js';
import type { SurfacePlace } from './LineSurface.js';
import type { FamilyMeasure, LineMedium, StrokePlace } from './marks/lineMarks.js';
import type { Projection } from './Projection.js';
import { rowOctaves } from './shading/carving.js';
import { KEPT_BY_PEN, leftOf, otherShare, sharedByTwo, THIRD_FROM, takenOf } from './shading/crossedTones.js';
import type { CutField, Field } from './shading/fieldAxis.js';
import { handTone } from './shading/hand.js';
import {
  type CutFamilies,
  type CutReading,
  cutFamilies,
  familyGradient,
  familyValue,
  type Lean,
  readCut,
} from './shading/readCut.js';
import { COARSEST_OCTAVES, readForm } from './shading/readForm.js';
import { type LineSpacing, octaveOf, powerOf2, riseOf, spacedBy } from './shading/ruledLines.js';
import {
  changePerPixel,
  type Mat3,
  type ScreenMap,
  type SeenPlace,
  screenMap,
  uphillOnPicture,
} from './shading/screenGradient.js';
import { alongLines } from './shading/strokeLengths.js';
import type { Tones } from './Toner.js';

/** How the lines of a surface are laid. */
export interface EngravedLook {
  lineField: CutField | 'form' | 'acrossForm';
  medium: LineMedium;
  /** Of media that draw in strokes: pixels, or 256ths of a tile. */
  strokeLength: number;
  spacing: LineSpacing;
  /** Tone above which lines cross, and the angle at which, radians. */
  crossFrom: number;
  crossAngle: number;
  /** From 0, a ruling machine, to 1. */
  handmade: number;
  /** Whether families of their own draw what shadows take. */
  crossesInShadows: boolean;
}

/**
 * The families: the first, two that cross it in the darks, two that cross a pen's in the deepest and lean the other way, and two that do so in
 * shadows.
 */
const FAMILIES = ['first', 'crossB', 'crossC', 'thirdB', 'thirdC', 'shadowB', 'shadowC'] as const;
export type FamilyName = (typeof FAMILIES)[number];

const { ANY_OCTAVE } = FIELD_CONSTANTS;
const { LEAST_TONE } = LINE_CONSTANTS;

/** One way in which the families of a surface are read. */
interface Reading {
  value: number;
  gradient: Vec3;
  rise: number;
  coarsest: number;
  pressure: number;
  /** The share of the first family, and of side B, of what there is to print. */
  has: number;
  shareB: number;
}

/** A place as far as all families read it alike. */
export interface EngravedPlace {
  place: SurfacePlace;
  /** Null for lines that follow the form. */
  cut: CutReading | null;
  smooth: ScreenMap;
  flat: ScreenMap;
  /** That of the flat triangle, held back where it leans away as the smooth one is. */
  triangle: ScreenMap;
}

/** Works out the lines of one surface: the values that they are level sets of, and how wide each is where. */
export class Engraver {
  private readonly cut: CutFamilies | null;
  private readonly leans: Readonly<Record<FamilyName, Lean>>;

  /** @param field of the first family; null for lines that follow the form */
  constructor(
    private readonly look: EngravedLook,
    field: Field | null,
    private readonly viewToField: Mat3,
    private readonly projection: Projection,
  ) {
    this.cut = field && cutFamilies(field);
    const [cosine, sine] = [Math.cos(look.crossAngle), Math.sin(look.crossAngle)];
    // Others halve the wider angle between the first and those that cross it: they lean the other way by 60° if that is theirs.
    const other = { cosine: Math.sin(look.crossAngle / 2), sine: -Math.cos(look.crossAngle / 2) };
    this.leans = {
      first: { cosine: 1, sine: 0, side: null },
      crossB: { cosine, sine, side: 'B' },
      crossC: { cosine, sine, side: 'C' },
      thirdB: { ...other, side: 'B' },
      thirdC: { ...other, side: 'C' },
      shadowB: { ...other, side: 'B' },
      shadowC: { ...other, side: 'C' },
    };
  }

  /** Whether values jump across seams, so that vertices at one place may have several. */
  get hasSeams(): boolean {
    return this.cut === null;
  }

  get medium(): LineMedium {
    return this.look.medium;
  }

  /** The families that the surface may have. */
  get families(): readonly FamilyName[] {
    const { crossFrom, crossesInShadows, medium } = this.look;
    return FAMILIES.filter((name) => {
      if (name === 'first') return true;
      // One family alone crosses those that follow the form.
      if (this.cut === null && name.endsWith('C')) return false;
      if (name.startsWith('shadow')) return crossesInShadows;
      if (name.startsWith('third') && medium !== 'pen') return false;
      // Where the first has no lines, others take its tone.
      return crossFrom < 1 || this.cut !== null;
    });
  }

  /** Reads a place for all families. */
  at(place: SurfacePlace): EngravedPlace {
    const { projection, viewToField, cut, look } = this;
    const unitsPerPixel = projection.unitsPerPixel(-place.view[2]);
    const seen: SeenPlace = { view: place.view, isOrthographic: projection.isOrthographic, unitsPerPixel };
    const { smooth, flat } = place.posed ?? { smooth: viewToField, flat: viewToField };
    return {
      place,
      cut: cut && readCut(cut, place.field, place.fieldNormal, look.handmade),
      smooth: screenMap(place.fieldNormal, smooth, seen),
      flat: screenMap(place.flatNormal, flat, seen, true),
      triangle: screenMap(place.flatNormal, flat, seen),
    };
  }

  valueAt(family: FamilyName, at: EngravedPlace): number {
    return this.read(family, at).value;
  }

  gradientAt(family: FamilyName, at: EngravedPlace): Vec3 {
    return this.read(family, at).gradient;
  }

  /** How much a function changes per pixel on a flat triangle of a surface that does not deform. view: the place, view space. */
  changeOn(flatNormal: Vec3, gradient: Vec3, view: Vec3): number {
    const { projection, viewToField } = this;
    const unitsPerPixel = projection.unitsPerPixel(-view[2]);
    const seen: SeenPlace = { view, isOrthographic: projection.isOrthographic, unitsPerPixel };
    return changePerPixel(gradient, screenMap(flatNormal, viewToField, seen, true));
  }

  measure(family: FamilyName, at: EngravedPlace, tones: Tones): FamilyMeasure {
    const reading = this.read(family, at);
    const { spacing, medium, handmade } = this.look;
    const { place, smooth, flat, triangle } = at;
    const { gradient, rise, coarsest, pressure } = reading;
    const tone = handTone(pressure, this.toneOf(family, reading, tones));
    const spaced = spacedBy(changePerPixel(gradient, smooth), changePerPixel(gradient, triangle));
    const octave = octaveOf(spacing, rise, spaced, coarsest);
    return {
      tone,
      octave,
      coarsest,
      perPixel: changePerPixel(gradient, flat),
      widths: this.cut === null ? 0 : handmade,
      // Those that follow the form have other numbers on the other side of a seam.
      left: this.cut === null ? 1 : tones.left,
      isEven: this.cut !== null && medium === 'ink',
      strokes:
        medium === 'ink'
          ? null
          : this.strokesAt(
              medium,
              place,
              reading,
              { smooth, flat },
              Math.min(octave + rowOctaves(Math.max(tone, tones.full)), coarsest),
            ),
    };
  }

  /** What a family prints, before the hand presses. */
  private toneOf(family: FamilyName, { has, shareB }: Reading, tones: Tones): number {
    const { crossFrom, crossesInShadows, medium } = this.look;
    const isPen = medium === 'pen';
    const taken = (tone: number, from: number) => (isPen ? takenOf(tone, from, KEPT_BY_PEN) : takenOf(tone, from));
    const own = crossesInShadows ? tones.unshadowed : tones.tone;
    const first = has * taken(own, crossFrom);
    if (family === 'first') return first;
    const others = leftOf(own, first);
    const second = isPen ? taken(others, THIRD_FROM) : others;
    const isShadow = family.startsWith('shadow');
    let left = second;
    if (isShadow) left = leftOf(tones.tone, tones.unshadowed);
    // Strokes cross at a slant, which alone would leave rows of rhombs open in the darks: others lean the other way there.
    else if (family.startsWith('third')) left = leftOf(others, second);
    const leansOther = isShadow || family.startsWith('third');
    const tone = sharedByTwo(left, leansOther ? otherShare(shareB, has) : shareB)[family.endsWith('B') ? 0 : 1];
    // What is as good as nothing has no lines.
    return tone <= LEAST_TONE ? 0 : tone;
  }

  private strokesAt(
    medium: StrokePlace['medium'],
    { field, fieldNormal }: SurfacePlace,
    { gradient, value, coarsest }: Reading,
    { smooth, flat }: { smooth: ScreenMap; flat: ScreenMap },
    cutOctave: number,
  ): StrokePlace {
    const { strokeLength, spacing, handmade } = this.look;
    const { sizedOnScreen } = spacing;
    return {
      along: alongLines(field, fieldNormal, gradient, smooth, { strokeLength, sizedOnScreen }),
      uphill: uphillOnPicture(gradient, flat),
      repeat: this.cut === null ? powerOf2(coarsest) : Infinity,
      ...{ medium, handmade, value, cutOctave },
    };
  }

  private read(family: FamilyName, { cut: reading, place: { field, form, formCrossing } }: EngravedPlace): Reading {
    const { handmade, lineField, medium } = this.look;
    if (this.cut !== null && reading !== null) {
      const lean = this.leans[family];
      return {
        value: familyValue(this.cut, reading, lean),
        gradient: familyGradient(this.cut, reading, lean),
        rise: family === 'first' ? riseOf(reading.slope) : 1,
        coarsest: ANY_OCTAVE,
        pressure: reading.pressure,
        has: reading.has,
        shareB: reading.shareB,
      };
    }
    const isAcross = lineField === 'acrossForm';
    const [first, other] = isAcross ? [formCrossing, form] : [form, formCrossing];
    const coarsest = isAcross ? COARSEST_OCTAVES.toReversed() : COARSEST_OCTAVES;
    const a = readForm(first, field, handmade, medium === 'ink');
    const rest = { pressure: a.pressure, has: 1, shareB: 1 };
    if (family === 'first') {
      return {
        value: a.value,
        gradient: first.gradient,
        rise: lengthOf(first.gradient),
        coarsest: coarsest[0],
        ...rest,
      };
    }
    const b = readForm(other, field, handmade, medium === 'ink');
    const rise = lengthOf(other.gradient);
    if (family === 'crossB') return { value: b.value, gradient: other.gradient, rise, coarsest: coarsest[1], ...rest };
    // The difference of the two functions is whole across seams too, and its lines lean the other way.
    const gradient = combined(1, first.gradient, -1, other.gradient);
    return { value: a.value - b.value, gradient, rise, coarsest: Math.min(...coarsest), ...rest };
  }
}
