import { Matrix4, Vector3 } from 'three';
import { runsAway } from '../../look/queries.js';
import type { Vec3 } from '../../look/vectors.js';
import type { HatchingMaterial } from '../../material/HatchingMaterial.js';
import type { TurnedLines } from '../DrawnScene.js';
import type { EngravedLook } from '../Engraver.js';
import { FIELD_NORMAL, type LineSurface, STRIDE } from '../LineSurface.js';
import { across, type Field, type FieldLamp, fieldLight, firstField } from '../shading/fieldAxis.js';
import { awayField } from '../shading/groundShadow.js';
import type { Lamp } from '../shading/radiance.js';
import { followsForm, type SurfaceFrame } from './surfaceFrame.js';

/** A surface, and how its lines are laid. */
export interface LaidSurface {
  engraved: EngravedLook;
  material: HatchingMaterial;
  frame: SurfaceFrame;
  surface: LineSurface;
}

/** Most lights whose shadows turn lines: each combination of them has lines of its own. */
const MOST_TURNING = 3;

/** The field of the first family of lines on a surface; null for lines that follow the form. */
export function fieldOf({ engraved, material, frame, surface }: LaidSurface, lamps: readonly Lamp[]): Field | null {
  const { direction } = engraved;
  if (followsForm(direction)) return null;
  const light = fieldLight(lampsIn(frame, lamps));
  if (runsAway(material)) return awayField(light.axis, leaningOf(surface));
  return firstField(direction, light, material.strokeAngle);
}

/** The sum of the normals' absolute components along each axis of the field. */
function leaningOf({ vertices }: LineSurface): Vec3 {
  const sums = [0, 1, 2].map((axis) => {
    let sum = 0;
    for (let o = FIELD_NORMAL + axis; o < vertices.length; o += STRIDE) sum += Math.abs(vertices[o]);
    return sum;
  });
  return [sums[0], sums[1], sums[2]];
}

/** Lamps in the field space of a surface. */
function lampsIn({ restToWorld, fieldOrigin, toField }: SurfaceFrame, lamps: readonly Lamp[]): FieldLamp[] {
  const toObject = new Matrix4().copy(restToWorld).invert();
  return lamps.map(({ at, isFar, luminance }) => {
    const way = new Vector3(...at);
    if (isFar) way.transformDirection(toObject);
    else way.applyMatrix4(toObject).sub(fieldOrigin);
    return { toLight: way.applyMatrix3(toField).toArray() as Vec3, luminance, isFar };
  });
}

/** Whether lines turn in shadows on a surface. */
const turns = ({ engraved: { direction }, material }: LaidSurface): boolean =>
  material.shadowStrokes === 'reorient' &&
  !runsAway(material) &&
  (followsForm(direction) || direction === 'light' || direction === 'towardsLight');

/** Whether the shadows of more lights would turn lines than are supported. */
export const hasTooManyTurns = (laid: LaidSurface, lamps: readonly Lamp[]): boolean =>
  turns(laid) && lamps.filter(({ castsShadow }) => castsShadow).length > MOST_TURNING;

/**
 * The lines of a surface in each shadow that turns them, from the lights that arrive. Where none does, lines of a field run across the
 * light, and lines along and across the form change places.
 */
export function turnedLinesOf(laid: LaidSurface, lamps: readonly Lamp[]): TurnedLines[] {
  const casting = lamps.flatMap(({ castsShadow }, i) => (castsShadow ? [i] : []));
  if (!turns(laid) || casting.length > MOST_TURNING) return [];
  const { engraved, material, frame } = laid;
  const { direction } = engraved;
  const isAll = (shadows: number): boolean => shadows === 2 ** lamps.length - 1;
  const turned: TurnedLines[] = [];
  for (let set = 1; set < 2 ** casting.length; set++) {
    const shadows = casting.reduce((bits, lamp, k) => bits | (((set >> k) & 1) << lamp), 0);
    if (followsForm(direction)) {
      const crossing = direction === 'form' ? 'acrossForm' : 'form';
      if (isAll(shadows)) turned.push({ shadows, engraved: { ...engraved, direction: crossing }, field: null });
      continue;
    }
    const arriving = lamps.filter((_, lamp) => ((shadows >> lamp) & 1) === 0);
    const light = isAll(shadows)
      ? { axis: across(fieldLight(lampsIn(frame, lamps)).axis), bend: 0 }
      : fieldLight(lampsIn(frame, arriving));
    turned.push({ shadows, engraved, field: firstField(direction, light, material.strokeAngle) });
  }
  return turned;
}
