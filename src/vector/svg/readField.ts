import { Matrix4, Vector3 } from 'three';
import { runsAway } from '../../look/queries.js';
import type { Vec3 } from '../../look/vectors.js';
import type { HatchingMaterial } from '../../material/HatchingMaterial.js';
import type { TurnedLines } from '../DrawnScene.js';
import type { EngravedLook } from '../Engraver.js';
import { FIELD_NORMAL, type LineSurface, STRIDE } from '../LineSurface.js';
import { across, type Field, firstField } from '../shading/fieldAxis.js';
import { awayField } from '../shading/groundShadow.js';
import { type FieldLamp, fieldLight } from '../shading/lightField.js';
import type { Lamp } from '../shading/radiance.js';
import type { SurfaceFrame } from './surfaceFrame.js';

/** A surface whose lines are laid, and how. */
export interface LaidSurface {
  engraved: EngravedLook;
  material: HatchingMaterial;
  frame: SurfaceFrame;
  surface: LineSurface;
}

/** Lines turn in the shadows of so many lights at most: each set of them asks for lines of its own. */
const MOST_TURNING = 3;

type LineField = EngravedLook['lineField'];
const followsForm = (lineField: LineField): lineField is 'form' | 'acrossForm' =>
  lineField === 'form' || lineField === 'acrossForm';

/** The field of the first family of lines on a surface; null for those that follow the form. */
export function fieldOf({ engraved, material, frame, surface }: LaidSurface, lamps: readonly Lamp[]): Field | null {
  const { lineField } = engraved;
  if (followsForm(lineField)) return null;
  const light = fieldLight(lampsIn(frame, lamps));
  if (runsAway(material)) return awayField(light.axis, leaningOf(surface));
  return firstField(lineField, light, material.strokeRotation);
}

/** How much the normals of a surface lean along each axis of its field, all together. */
function leaningOf({ vertices }: LineSurface): Vec3 {
  const sums = [0, 1, 2].map((axis) => {
    let sum = 0;
    for (let o = FIELD_NORMAL + axis; o < vertices.length; o += STRIDE) sum += Math.abs(vertices[o]);
    return sum;
  });
  return [sums[0], sums[1], sums[2]];
}

/** Lamps as the field of a surface sees them. */
function lampsIn({ restToWorld, fieldOrigin, toField }: SurfaceFrame, lamps: readonly Lamp[]): FieldLamp[] {
  const toObject = new Matrix4().copy(restToWorld).invert();
  return lamps.map(({ at, isFar, luminance }) => {
    const way = new Vector3(...at);
    if (isFar) way.transformDirection(toObject);
    else way.applyMatrix4(toObject).sub(fieldOrigin);
    return { toLight: way.applyMatrix3(toField).toArray() as Vec3, luminance, isFar };
  });
}

/** Whether lines turn in shadows that fall on a surface. */
const turns = ({ engraved: { lineField }, material }: LaidSurface): boolean =>
  material.shadowStrokes === 'reorient' &&
  !runsAway(material) &&
  (followsForm(lineField) || lineField === 'light' || lineField === 'towards');

/** Whether lines would turn in the shadows of more lights than can be told apart. */
export const hasTooManyTurns = (laid: LaidSurface, lamps: readonly Lamp[]): boolean =>
  turns(laid) && lamps.filter(({ castsShadow }) => castsShadow).length > MOST_TURNING;

/**
 * The lines of a surface in each shadow that turns them: as if there were only the lights that arrive. Where none does, they lie across the light,
 * and those along a form change places with those that cross them.
 */
export function turnedLinesOf(laid: LaidSurface, lamps: readonly Lamp[]): TurnedLines[] {
  const casting = lamps.flatMap(({ castsShadow }, i) => (castsShadow ? [i] : []));
  if (!turns(laid) || casting.length > MOST_TURNING) return [];
  const { engraved, material, frame } = laid;
  const { lineField } = engraved;
  const isAll = (shadows: number): boolean => shadows === 2 ** lamps.length - 1;
  const turned: TurnedLines[] = [];
  for (let set = 1; set < 2 ** casting.length; set++) {
    const shadows = casting.reduce((bits, lamp, k) => bits | (((set >> k) & 1) << lamp), 0);
    if (followsForm(lineField)) {
      const crossing = lineField === 'form' ? 'acrossForm' : 'form';
      if (isAll(shadows)) turned.push({ shadows, engraved: { ...engraved, lineField: crossing }, field: null });
      continue;
    }
    const arriving = lamps.filter((_, lamp) => ((shadows >> lamp) & 1) === 0);
    const light = isAll(shadows)
      ? { axis: across(fieldLight(lampsIn(frame, lamps)).axis), bend: 0 }
      : fieldLight(lampsIn(frame, arriving));
    turned.push({ shadows, engraved, field: firstField(lineField, light, material.strokeRotation) });
  }
  return turned;
}
