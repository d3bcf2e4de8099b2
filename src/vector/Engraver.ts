import { leftOf, sharedByTwo, takenOf } from '../engraving/crossedTones.js';
import type { CutField, Field } from '../engraving/fieldAxis.js';
import { handTone, handWidth } from '../engraving/hand.js';
import {
  type CutFamilies,
  cutFamilies,
  familyGradient,
  familyValue,
  type Lean,
  readCut,
} from '../engraving/readCut.js';
import { COARSEST_OCTAVES, readForm } from '../engraving/readForm.js';
import { type LineSpacing, octaveOf, penMargin, riseOf, roomOf } from '../engraving/ruledLines.js';
import { changePerPixel, type Mat3, type SeenPlace, screenMap } from '../engraving/screenGradient.js';
import { combined, lengthOf, type Vec3 } from '../engraving/vectors.js';
import type { SurfacePlace } from './LineSurface.js';
import type { Projection } from './Projection.js';
import type { Tones } from './Toner.js';

/** How the lines of a surface are laid. */
export interface EngravedLook {
  lineField: CutField | 'form' | 'acrossForm';
  spacing: LineSpacing;
  /** Tone above which lines cross, and the angle at which, radians. */
  crossFrom: number;
  crossAngle: number;
  /** From 0, a ruling machine, to 1. */
  handmade: number;
  /** Whether families of their own draw what shadows take. */
  crossesInShadows: boolean;
}

/** The families: the first, two that cross it in the darks, and two that cross in shadows and lean the other way. */
export const FAMILIES = ['first', 'crossB', 'crossC', 'shadowB', 'shadowC'] as const;
export type FamilyName = (typeof FAMILIES)[number];

/** Lines may lie as far apart as they like. */
const ANY_OCTAVE = 100;

/** A family at a place. */
export interface FamilyMeasure {
  /** What the family prints. */
  tone: number;
  /** Of the distance between lines. */
  octave: number;
  coarsest: number;
  /** Units of the function per pixel on the flat triangle, where the lines lie as they lie. */
  perPixel: number;
}

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
    this.leans = {
      first: { cosine: 1, sine: 0, side: null },
      crossB: { cosine, sine, side: 'B' },
      crossC: { cosine, sine, side: 'C' },
      shadowB: { cosine, sine: -sine, side: 'B' },
      shadowC: { cosine, sine: -sine, side: 'C' },
    };
  }

  /** Whether values jump across seams, so that vertices at one place may have several. */
  get hasSeams(): boolean {
    return this.cut === null;
  }

  /** The families that the surface may have. */
  get families(): readonly FamilyName[] {
    const { crossFrom, crossesInShadows } = this.look;
    return FAMILIES.filter((name) => {
      if (name === 'first') return true;
      // One family alone crosses those that follow the form.
      if (this.cut === null && name.endsWith('C')) return false;
      return name.startsWith('shadow') ? crossesInShadows : crossFrom < 1;
    });
  }

  valueAt(family: FamilyName, place: SurfacePlace): number {
    return this.read(family, place).value;
  }

  measure(family: FamilyName, place: SurfacePlace, tones: Tones): FamilyMeasure {
    const reading = this.read(family, place);
    const { crossFrom, crossesInShadows, spacing } = this.look;
    const own = crossesInShadows ? tones.unshadowed : tones.tone;
    const first = reading.has * takenOf(own, crossFrom);
    let tone = first;
    if (family !== 'first') {
      const left = family.startsWith('shadow') ? leftOf(tones.tone, tones.unshadowed) : leftOf(own, first);
      tone = sharedByTwo(left, reading.shareB)[family.endsWith('B') ? 0 : 1];
      // What is as good as nothing has no lines.
      if (tone <= 1e-4) tone = 0;
    }
    const { projection, viewToField } = this;
    const { isOrthographic } = projection;
    const unitsPerPixel = projection.unitsPerPixel(-place.view[2]);
    const seen: SeenPlace = { view: place.view, isOrthographic, unitsPerPixel };
    const { smooth: ofSmooth, flat: ofFlat } = place.posed ?? { smooth: viewToField, flat: viewToField };
    const smooth = changePerPixel(reading.gradient, screenMap(place.fieldNormal, ofSmooth, seen));
    const flat = changePerPixel(reading.gradient, screenMap(place.flatNormal, ofFlat, seen, true));
    const { rise, coarsest, pressure } = reading;
    return {
      tone: handTone(pressure, tone),
      octave: octaveOf(spacing, rise, smooth, coarsest),
      coarsest,
      perPixel: flat,
    };
  }

  /** Half the width that a line has at a place, in pixels. rank: the power of two in its value. */
  halfWidth({ tone, octave, perPixel }: FamilyMeasure, line: number, rank: number): number {
    const hand = this.cut === null ? 1 : handWidth(line, this.look.handmade);
    // Wider than all its room it would cover nothing more.
    return (0.5 * roomOf(rank, octave) * Math.min(tone * hand, 1)) / perPixel;
  }

  /** Where this is above 0, a pen of one width draws a line. pen: its width, pixels. */
  penMargin({ tone, perPixel, coarsest }: FamilyMeasure, rank: number, index: number, pen: number): number {
    if (tone <= LEAST_PEN_TONE) return tone - LEAST_PEN_TONE;
    return penMargin(rank, index, (pen / Math.min(tone, MOST_PEN_TONE)) * perPixel, coarsest);
  }

  /** The octave of the finest lines that a pen may need at a place. */
  penOctave({ tone, perPixel, coarsest }: FamilyMeasure, pen: number): number {
    const asked = Math.min(Math.max(tone, LEAST_PEN_TONE), MOST_PEN_TONE);
    // Half an octave to spare, for tones between the corners of a triangle.
    return Math.min(Math.log2((pen / asked) * perPixel) - 0.5, coarsest);
  }

  private read(family: FamilyName, { field, fieldNormal, form, formCrossing }: SurfacePlace): Reading {
    const { handmade, lineField } = this.look;
    if (this.cut !== null) {
      const reading = readCut(this.cut, field, fieldNormal, handmade);
      const lean = this.leans[family];
      return {
        value: familyValue(this.cut, reading, lean),
        gradient: familyGradient(this.cut, reading, lean),
        rise: family === 'first' ? riseOf(reading.slope) : 1,
        coarsest: ANY_OCTAVE,
        ...{ pressure: reading.pressure, has: reading.has, shareB: reading.shareB },
      };
    }
    const isAcross = lineField === 'acrossForm';
    const [first, other] = isAcross ? [formCrossing, form] : [form, formCrossing];
    const coarsest = isAcross ? COARSEST_OCTAVES.toReversed() : COARSEST_OCTAVES;
    const a = readForm(first, field, handmade);
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
    const b = readForm(other, field, handmade);
    const rise = lengthOf(other.gradient);
    if (family === 'crossB') return { value: b.value, gradient: other.gradient, rise, coarsest: coarsest[1], ...rest };
    // The difference of the two functions is whole across seams too, and its lines lean the other way.
    const gradient = combined(1, first.gradient, -1, other.gradient);
    return { value: a.value - b.value, gradient, rise, coarsest: Math.min(...coarsest), ...rest };
  }
}

/** A pen of one width draws no line below the first tone, which would stand alone, and lays them no closer than for the second. */
export const LEAST_PEN_TONE = 0.07;
const MOST_PEN_TONE = 0.95;
