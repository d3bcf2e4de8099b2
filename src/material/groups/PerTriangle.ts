import type { PerTriangleOptions, PerTriangleProperties } from './ownedProperties.js';
import { PropertyGroup } from './PropertyGroup.js';

/** The properties of `HatchingMaterial` that only the techniques of the paper by Suarez et al. read. */
// biome-ignore lint/suspicious/noUnsafeDeclarationMerging: the constructor defines every property of the table.
export class PerTriangle extends PropertyGroup {
  /** @internal */
  constructor(onChoice: () => void) {
    super('perTriangle', onChoice);
  }

  /**
   * Sets some of the properties by name.
   *
   * @throws TypeError, RangeError or Error for a value of the wrong kind or out of its range, before anything is set
   */
  setValues(values: Partial<PerTriangleOptions>): void {
    this.assign(values);
  }
}

export interface PerTriangle extends PerTriangleProperties {}
