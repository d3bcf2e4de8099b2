import type { BufferGeometry } from 'three';
import { formLayout } from '../../mesh/bake/attributeLayouts.js';
import { identityOf } from './identityOf.js';

/** Whether a geometry was prepared with `form`. Allocates nothing. */
export const isFormed = ({ attributes }: BufferGeometry): boolean => attributes[formLayout.value.name] !== undefined;

/** The identities of geometries that are drawn without a form until another geometry, with a form, replaces them. */
const expecting = new WeakSet<object>();

/** Declares that a geometry lacks a form only for a while, so that no warning is due. */
export const expectForm = (geometry: BufferGeometry): void => void expecting.add(identityOf(geometry));

/** Whether `expectForm` was called for a geometry. */
export const isFormExpected = (geometry: BufferGeometry): boolean => expecting.has(identityOf(geometry));
