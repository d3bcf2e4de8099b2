import { BufferAttribute, type BufferGeometry } from 'three';
import { formLayout } from '../bake/formLayout.js';
import type { PackedForm } from '../bake/packForm.js';

/** Sets the attributes of lines that follow the form, if they were baked. */
export function setForm(geometry: BufferGeometry, form: PackedForm | null): void {
  if (form === null) return;
  const { value, slope, crossing } = formLayout;
  geometry.setAttribute(value.name, new BufferAttribute(form.values, value.itemSize));
  geometry.setAttribute(slope.name, new BufferAttribute(form.slopes, slope.itemSize, true));
  geometry.setAttribute(crossing.name, new BufferAttribute(form.crossings, crossing.itemSize, true));
}
