import { FIELD_CONSTANTS, LINE_CONSTANTS } from '../look/constants/lineConstants.js';
import { combined, lengthOf, type Vec3 } from '../look/vectors.js';
import type { StrokeProfiles } from '../strokes/strokeProfiles.js';
import type { SurfacePlace } from './LineSurface.js';
import type { FamilyMeasure, HandPlace, LineTechnique, StrokePlace } from './lineMarks.js';
import type { Projection } from './Projection.js';
import type { PosedMaps } from './paint/PaintLook.js';
import { rowOctaves } from './shading/carving.js';
import { KEPT_BY_PEN, leftOf, otherShare, sharedByTwo, THIRD_FROM, takenOf } from './shading/crossedTones.js';
import type { CutDirection, Field } from './shading/fieldAxis.js';
import { handTone } from './shading/hand.js';
import { cellsAlongAxes, cellsAlongForm, type FunctionAt } from './shading/handStrokes.js';
import {
  COARSEST_OCTAVES,
  type CutFamilies,
  type CutReading,
  cutFamilies,
  type FormAt,
  familyGradient,
  familyValue,
  type Lean,
  readCut,
  readForm,
} from './shading/lineFunctions.js';
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
import type { Tones } from './ToneReader.js';

/** The properties of engraved lines on a surface. */
export interface EngravedLook {
  direction: CutDirection | 'form' | 'acrossForm';
  technique: LineTechnique;
  /** Length of the strokes of a pen or a gouge: pixels, or 256ths of a tile. */
  strokeLength: number;
  spacing: LineSpacing;
  /** Tone above which lines cross, and the angle, radians; below 0 for those of a hand that cross to the other side. */
  crossFrom: number;
  crossAngle: number;
  /** From 0, lines as by a ruling machine, to 1. */
  irregularity: number;
  /** Whether shadows are drawn by families of their own. */
  crossesInShadows: boolean;
  /** The strokes that a hand draws in rows; null where none does. */
  hand: StrokeProfiles | null;
}

/**
 * The families of lines: the first; two that cross it in the darks; two of a pen that lean back across those in the deepest darks; and two
 * that lean back in shadows.
 */
const FAMILIES = ['first', 'crossB', 'crossC', 'thirdB', 'thirdC', 'shadowB', 'shadowC'] as const;
export type FamilyName = (typeof FAMILIES)[number];

const { ANY_OCTAVE } = FIELD_CONSTANTS;
const { LEAST_TONE } = LINE_CONSTANTS;

/** How the families of a surface share the tone at one place. */
interface Shares {
  /** Of the hand. */
  pressure: number;
  /** The share to which the first family has lines here, and the share of side B in what crosses. */
  firstShare: number;
  shareB: number;
}

/** How a family is laid at one place. */
interface Reading extends Shares {
  value: number;
  gradient: Vec3;
  rise: number;
  coarsest: number;
}

/** A place, as far as all families share what is computed for it. Screen maps of its triangle are computed when they are asked for. */
export class EngravedPlace {
  readonly smooth: ScreenMap;
  /** What was read here so far, of families and of the two functions of the form. */
  readonly readings: Partial<Record<FamilyName, Reading>> = {};
  readonly forms: [FormReading?, FormReading?] = [];
  private knownFlat: ScreenMap | null = null;
  private knownTriangle: ScreenMap | null = null;

  /**
   * @param cut null for lines that follow the form
   * @param maps from view to field
   */
  constructor(
    readonly place: SurfacePlace,
    readonly cut: CutReading | null,
    private readonly maps: PosedMaps,
    private readonly seen: SeenPlace,
  ) {
    this.smooth = screenMap(place.fieldNormal, maps.smooth, seen);
  }

  /** View units per pixel. */
  get unitsPerPixel(): number {
    return this.seen.unitsPerPixel;
  }

  get flat(): ScreenMap {
    this.knownFlat ??= screenMap(this.place.flatNormal, this.maps.flat, this.seen, true);
    return this.knownFlat;
  }

  /** The screen map of the flat triangle, with the same limit at grazing angles as the smooth one. */
  get triangle(): ScreenMap {
    this.knownTriangle ??= screenMap(this.place.flatNormal, this.maps.flat, this.seen);
    return this.knownTriangle;
  }
}

/** One of the two functions of the form, and the pressure of the hand. */
type FormReading = FunctionAt & { pressure: number };

/** Computes the lines of one surface: the functions whose level sets they are, and their widths. */
export class Engraver {
  /** The families that the surface may have. */
  readonly families: readonly FamilyName[];

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
    const { crossAngle } = look;
    const across = { cosine: Math.cos(crossAngle), sine: Math.sin(crossAngle) };
    // Other families lean back: they halve the wider angle between the first family and those that cross it, so that 60° gives −60°.
    const half = Math.abs(crossAngle) / 2;
    const back = { cosine: Math.sin(half), sine: crossAngle < 0 ? Math.cos(half) : -Math.cos(half) };
    const [crossB, thirdB] = [across, back].map((lean): Lean => ({ ...lean, side: 'B' }));
    const [crossC, thirdC] = [across, back].map((lean): Lean => ({ ...lean, side: 'C' }));
    const first: Lean = { cosine: 1, sine: 0, side: null };
    this.leans = { first, crossB, crossC, thirdB, thirdC, shadowB: thirdB, shadowC: thirdC };
    this.families = FAMILIES.filter((family) => this.mayHave(family));
  }

  /** Whether values jump across seams, so that vertices at one place may have several. */
  get hasSeams(): boolean {
    return this.cut === null;
  }

  get technique(): LineTechnique {
    return this.look.technique;
  }

  /** Whether lines are rows of strokes of a hand. */
  get hasRows(): boolean {
    return this.look.hand !== null;
  }

  private mayHave(family: FamilyName): boolean {
    const { crossFrom, crossesInShadows, technique } = this.look;
    if (family === 'first') return true;
    // Only one family crosses lines that follow the form.
    if (this.cut === null && family.endsWith('C')) return false;
    if (family.startsWith('shadow')) return crossesInShadows;
    if (family.startsWith('third') && technique !== 'pen') return false;
    // Where the first family has no lines, others take its tone.
    return crossFrom < 1 || this.cut !== null;
  }

  /** Computes what all families share at a place. */
  at(place: SurfacePlace): EngravedPlace {
    const { projection, viewToField, cut, look } = this;
    const unitsPerPixel = projection.unitsPerPixel(-place.view[2]);
    const seen: SeenPlace = { view: place.view, isOrthographic: projection.isOrthographic, unitsPerPixel };
    const maps = place.posed ?? { smooth: viewToField, flat: viewToField };
    return new EngravedPlace(place, cut && readCut(cut, place.field, place.fieldNormal, look.irregularity), maps, seen);
  }

  valueAt(family: FamilyName, at: EngravedPlace): number {
    return this.read(family, at).value;
  }

  gradientAt(family: FamilyName, at: EngravedPlace): Vec3 {
    return at.readings[family]?.gradient ?? this.gradientOf(family, at);
  }

  /** The tone that a family prints at a place. */
  toneAt(family: FamilyName, at: EngravedPlace, tones: Tones): number {
    const shares = at.cut ?? this.sharesOfForm(at);
    return handTone(shares.pressure, this.toneOf(family, shares, tones));
  }

  /** The change of a function per pixel on a flat triangle of a surface that does not deform. view: the place, view space. */
  changeOn(flatNormal: Vec3, gradient: Vec3, view: Vec3): number {
    const { projection, viewToField } = this;
    const unitsPerPixel = projection.unitsPerPixel(-view[2]);
    const seen: SeenPlace = { view, isOrthographic: projection.isOrthographic, unitsPerPixel };
    return changePerPixel(gradient, screenMap(flatNormal, viewToField, seen, true));
  }

  measure(family: FamilyName, at: EngravedPlace, tones: Tones): FamilyMeasure {
    const reading = this.read(family, at);
    const { spacing, technique, irregularity, hand } = this.look;
    const { smooth, flat, triangle } = at;
    const { gradient, rise, coarsest } = reading;
    const tone = this.toneAt(family, at, tones);
    const spaced = spacedBy(changePerPixel(gradient, smooth), changePerPixel(gradient, triangle));
    const octave = octaveOf(spacing, rise, spaced, coarsest);
    const cutOctave = Math.min(octave + rowOctaves(Math.max(tone, tones.full)), coarsest);
    return {
      tone,
      octave,
      coarsest,
      perPixel: changePerPixel(gradient, flat),
      widths: this.cut === null ? 0 : irregularity,
      // Lines that follow the form have other numbers on the other side of a seam, so they cannot dissolve one by one.
      left: this.cut === null ? 1 : tones.left,
      isEven: this.cut !== null && technique === 'engraving',
      strokes: technique === 'engraving' || hand ? null : this.strokesAt(technique, at, reading, cutOctave),
      hand: hand && this.handAt(hand, at, reading),
    };
  }

  /** The tone that a family prints, before the pressure of the hand. */
  private toneOf(family: FamilyName, { firstShare, shareB }: Shares, tones: Tones): number {
    const { crossFrom, crossesInShadows, technique } = this.look;
    const isPen = technique === 'pen';
    const taken = (tone: number, from: number) => (isPen ? takenOf(tone, from, KEPT_BY_PEN) : takenOf(tone, from));
    const own = crossesInShadows ? tones.unshadowed : tones.tone;
    const first = firstShare * taken(own, crossFrom);
    if (family === 'first') return first;
    const others = leftOf(own, first);
    const second = isPen ? taken(others, THIRD_FROM) : others;
    const isShadow = family.startsWith('shadow');
    let left = second;
    if (isShadow) left = leftOf(tones.tone, tones.unshadowed);
    // Two families cross at a slant and would leave rows of rhombs open in the darks: the third leans back.
    else if (family.startsWith('third')) left = leftOf(others, second);
    const leansOther = this.leans[family].sine < 0;
    const tone = sharedByTwo(left, leansOther ? otherShare(shareB, firstShare) : shareB)[family.endsWith('B') ? 0 : 1];
    // Negligible tones have no lines.
    return tone <= LEAST_TONE ? 0 : tone;
  }

  private strokesAt(
    technique: StrokePlace['technique'],
    { place: { field, fieldNormal }, smooth, flat }: EngravedPlace,
    { gradient, value, coarsest }: Reading,
    cutOctave: number,
  ): StrokePlace {
    const { strokeLength, spacing, irregularity } = this.look;
    const { screenSpaceShare } = spacing;
    return {
      along: alongLines(field, fieldNormal, gradient, smooth, { strokeLength, screenSpaceShare }),
      uphill: uphillOnPicture(gradient, flat),
      repeat: this.cut === null ? powerOf2(coarsest) : Infinity,
      ...{ technique, irregularity, value, cutOctave },
    };
  }

  private handAt(profiles: StrokeProfiles, at: EngravedPlace, reading: Reading): HandPlace {
    const { place, smooth, flat, unitsPerPixel } = at;
    const { gradient, value, coarsest } = reading;
    const { strokeLength, spacing } = this.look;
    const seen = { map: smooth, unitsPerPixel };
    const hasLanes = profiles.laneOffset > 0;
    const length = { strokeLength, screenSpaceShare: spacing.screenSpaceShare, hasLanes };
    const isFirst = value === this.valueAt('first', at);
    const isCut = this.cut !== null;
    return {
      profiles,
      cells: isCut
        ? cellsAlongAxes(gradient, place.field, place.fieldNormal, seen, length)
        : cellsAlongForm(gradient, this.formAt(isFirst ? 1 : 0, at), seen, length),
      value,
      repeat: isCut ? Infinity : powerOf2(coarsest),
      isDark: isFirst ? 0 : 1,
      uphill: uphillOnPicture(gradient, flat),
    };
  }

  private read(family: FamilyName, at: EngravedPlace): Reading {
    at.readings[family] ??= this.readingOf(family, at);
    return at.readings[family];
  }

  private readingOf(family: FamilyName, at: EngravedPlace): Reading {
    const gradient = this.gradientOf(family, at);
    const reading = at.cut;
    if (this.cut !== null && reading !== null) {
      const { pressure, firstShare, shareB, slope } = reading;
      const value = familyValue(this.cut, reading, this.leans[family]);
      const rise = family === 'first' ? riseOf(slope) : 1;
      return { value, gradient, rise, coarsest: ANY_OCTAVE, pressure, firstShare, shareB };
    }
    const shares = this.sharesOfForm(at);
    const first = this.formAt(0, at);
    if (family === 'first') return { ...first, gradient, ...shares };
    const other = this.formAt(1, at);
    if (this.leans[family].sine >= 0) return { ...other, gradient, ...shares };
    // The difference of the two functions is whole across seams too, and its lines lean the other way.
    const [value, coarsest] = [first.value - other.value, Math.min(first.coarsest, other.coarsest)];
    return { value, gradient, rise: other.rise, coarsest, ...shares };
  }

  private gradientOf(family: FamilyName, { cut, place }: EngravedPlace): Vec3 {
    if (this.cut !== null && cut !== null) return familyGradient(this.cut, cut, this.leans[family]);
    if (family === 'first') return this.formOf(0, place).gradient;
    const other = this.formOf(1, place).gradient;
    return this.leans[family].sine >= 0 ? other : combined(1, this.formOf(0, place).gradient, -1, other);
  }

  private sharesOfForm(at: EngravedPlace): Shares {
    return { pressure: this.formAt(0, at).pressure, firstShare: 1, shareB: 1 };
  }

  /** One of the two functions of the form: the first family's, or the one that crosses it. */
  private formAt(which: 0 | 1, at: EngravedPlace): FormReading {
    at.forms[which] ??= this.readFunction(which, at.place);
    return at.forms[which];
  }

  private readFunction(which: 0 | 1, place: SurfacePlace): FormReading {
    const { irregularity, technique } = this.look;
    const read = this.formOf(which, place);
    const { value, pressure } = readForm(read, place.field, irregularity, technique === 'engraving');
    const coarsest = COARSEST_OCTAVES[read === place.form ? 0 : 1];
    return { value, pressure, gradient: read.gradient, rise: lengthOf(read.gradient), coarsest };
  }

  /** One of the two functions as it is baked: with lines across the form they change places. */
  private formOf(which: 0 | 1, { form, formCrossing }: SurfacePlace): FormAt {
    return (which === 1) === (this.look.direction === 'acrossForm') ? form : formCrossing;
  }
}
