import type { Vector2, Vector3 } from 'three';
import type { HatchingOwner } from '../../look/HatchingProperty.js';
import type { HatchingPropertyName } from '../../look/hatchingProperties.js';
import { defaultOf } from '../../look/presetParameters.js';
import { checkChoice, checkOwned, namesOfOwner, ownedEntries } from '../checkProperty.js';
import { accessorOf, fieldOf } from '../propertyAccessors.js';
import { toVector2, type Vector2Like } from '../propertyValues.js';

/** An object that holds those properties of the table that name it as their owner. The values are checked when set. */
export abstract class PropertyGroup {
  protected numbers = new Map<HatchingPropertyName, number | 'auto' | 'fit' | null>();
  protected focused: Vector3 | null = null;
  private readonly chosen = new Map<HatchingPropertyName, string | boolean>();

  /** @param onChoice called after a choice was set, which may need another program */
  constructor(
    private readonly owner: HatchingOwner,
    private readonly onChoice: () => void = () => {},
  ) {
    for (const name of namesOfOwner(owner)) {
      const field = fieldOf(name);
      if (field !== undefined) Object.assign(this, { [name]: field });
      else if (!(name in this)) Object.defineProperty(Object.getPrototypeOf(this), name, accessorOf(name));
    }
  }

  /**
   * Sets some of the properties by name.
   *
   * @throws TypeError, RangeError or Error for a value of the wrong kind or out of its range, before anything is set
   */
  protected assign(values: object): void {
    checkOwned(this.owner, values);
    const properties = this as unknown as Record<string, unknown>;
    for (const [name, value] of ownedEntries(this.owner, values)) {
      if (value === undefined) continue;
      if (isVector2(properties[name])) properties[name].copy(toVector2(value as Vector2Like));
      else properties[name] = value;
    }
  }

  protected choice(name: HatchingPropertyName): string | boolean {
    return this.chosen.get(name) ?? (defaultOf(name) as string | boolean);
  }

  protected choose(name: HatchingPropertyName, value: string | boolean): void {
    checkChoice(name, value);
    this.chosen.set(name, value);
    this.onChoice();
  }
}

const isVector2 = (value: unknown): value is Vector2 =>
  (value as Partial<Vector2> | null | undefined)?.isVector2 === true;
