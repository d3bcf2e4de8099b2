import type { BufferGeometry } from 'three';
import { formLayout } from '../../mesh/bake/attributeLayouts.js';
import { identityOf } from './identityOf.js';

/** Whether a geometry was prepared with `form`. Allocates nothing. */
export const isFormed = ({ attributes }: BufferGeometry): boolean => attributes[formLayout.value.name] !== undefined;

/** The identities of geometries that are drawn without a form until one that has it takes their place. */
const expecting = new WeakSet<object>();

/** Says that a geometry is drawn without a form for a while, so that this is no mistake. */
export const expectForm = (geometry: BufferGeometry): void => void expecting.add(identityOf(geometry));

/** Whether `expectForm` was called for a geometry. */
export const isFormExpected = (geometry: BufferGeometry): boolean => expecting.has(identityOf(geometry));
