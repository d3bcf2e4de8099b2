import { BufferAttribute, type BufferGeometry, InterleavedBuffer, InterleavedBufferAttribute } from 'three';
import { formLayout, GRADIENTS_STRIDE } from '../../mesh/bake/formLayout.js';
import type { PackedForm } from '../../mesh/bake/packForm.js';

/** Sets the attributes of lines that follow the form, if they were baked. */
export function setForm(geometry: BufferGeometry, form: PackedForm | null): void {
  if (form === null) return;
  const { value, slope, crossing } = formLayout;
  geometry.setAttribute(value.name, new BufferAttribute(form.values, value.itemSize));
  const gradients = new InterleavedBuffer(form.gradients, GRADIENTS_STRIDE);
  const gradient = ({ itemSize }: { itemSize: number }, offset: number) =>
    new InterleavedBufferAttribute(gradients, itemSize, offset, true);
  geometry.setAttribute(slope.name, gradient(slope, 0));
  geometry.setAttribute(crossing.name, gradient(crossing, slope.itemSize));
}
