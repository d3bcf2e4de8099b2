import type { Texture, Vector2 } from 'three';
import type { HatchingMaterialParameters } from './HatchingMaterialParameters.js';
import type { HatchingProperty } from './HatchingProperty.js';
import { HATCHING_PROPERTIES, type HatchingPropertyName } from './hatchingProperties.js';

/** @throws TypeError naming the first texture or vector that is none. It would fail only when a frame is drawn. */
export function checkValueTypes(parameters: HatchingMaterialParameters): void {
  for (const name of Object.keys(parameters)) {
    if (!Object.hasOwn(HATCHING_PROPERTIES, name)) continue;
    const { kind }: HatchingProperty = HATCHING_PROPERTIES[name as HatchingPropertyName];
    const value: unknown = parameters[name as HatchingPropertyName];
    // three.js warns of it, and keeps what it has.
    if (value === undefined) continue;
    if (kind === 'texture' && value !== null && !(value as Partial<Texture>).isTexture) {
      throw new TypeError(`HatchingMaterial.${name}: expected a THREE.Texture or null.`);
    }
    if (kind === 'vector2' && !isVector(value)) {
      throw new TypeError(`HatchingMaterial.${name}: expected a THREE.Vector2 of finite numbers.`);
    }
  }
}

function isVector(value: unknown): boolean {
  const { x, y } = (value ?? {}) as Partial<Vector2>;
  return Number.isFinite(x) && Number.isFinite(y);
}
