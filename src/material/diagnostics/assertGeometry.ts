import type { BufferGeometry } from 'three';

/**
 * Checks that a value is a BufferGeometry and has the properties that every geometry has. The data of its attributes is not
 * checked; see `checkGeometry`.
 *
 * @throws TypeError that names the caller and the fault
 */
export function assertGeometry(geometry: BufferGeometry, caller: string): void {
  if (!geometry?.isBufferGeometry) {
    const kind = kindOf(geometry);
    const remedy = kind === 'Promise' ? 'Write await before it.' : 'For a mesh pass mesh.geometry.';
    throw new TypeError(`${caller}: expected a THREE.BufferGeometry, got ${kind}. ${remedy}`);
  }
  const { attributes, morphAttributes, groups, drawRange } = geometry;
  for (const [name, value] of Object.entries({ attributes, morphAttributes, drawRange })) {
    if (typeof value === 'object' && value !== null) continue;
    throw new TypeError(
      `${labelOf(geometry, caller)}: ${name} is ${kindOf(value)}. Keep the object that three.js has created, and change its content.`,
    );
  }
  if (Array.isArray(groups) && groups.every((group) => typeof group === 'object' && group !== null)) return;
  throw new TypeError(
    `${labelOf(geometry, caller)}: its groups are not an array of groups. Use addGroup() and clearGroups().`,
  );
}

/** The beginning of an error message: the caller, and the name of the geometry. */
export const labelOf = ({ name }: BufferGeometry, caller: string): string =>
  `${caller}: the geometry${name ? ` "${name}"` : ''}`;

/** The kind of a value, in one word. */
export function kindOf(value: unknown): string {
  if (value === null || typeof value !== 'object') return String(value);
  return (value as { type?: string }).type ?? value.constructor?.name ?? 'an object';
}
