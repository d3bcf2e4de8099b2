import type { Material } from 'three';

/** A value that is copied, not assigned: a colour or a vector. */
interface Copied {
  equals(other: unknown): boolean;
  clone(): Copied;
  copy(other: unknown): void;
}

const isCopied = (value: unknown): value is Copied =>
  typeof value === 'object' && value !== null && 'equals' in value && 'copy' in value;

const isSame = (a: unknown, b: unknown): boolean =>
  a === b || Object.is(a, b) || (isCopied(a) && isCopied(b) && a.equals(b));

/** The values that a material was given. Other values that it has are edits of the user. */
export class GivenValues {
  private readonly values: Record<string, unknown> = {};

  constructor(
    material: Material,
    private readonly names: readonly string[],
  ) {
    for (const name of names) this.note(material, name);
  }

  /** Sets a property, unless it was edited. */
  give(material: Material, name: string, value: unknown): void {
    const target = material as unknown as Record<string, unknown>;
    if (!isSame(target[name], this.values[name])) return;
    set(target, name, value);
    this.note(material, name);
  }

  /** Copies the edits of a material to another one. @param except names of properties that stay */
  copyEdits(from: Material, to: Material, except: readonly string[] = []): void {
    const source = from as unknown as Record<string, unknown>;
    for (const name of this.names) {
      const value = source[name];
      if (except.includes(name) || value === undefined || isSame(value, this.values[name])) continue;
      set(to as unknown as Record<string, unknown>, name, value);
    }
  }

  private note(material: Material, name: string): void {
    const value = (material as unknown as Record<string, unknown>)[name];
    this.values[name] = isCopied(value) ? value.clone() : value;
  }
}

function set(target: Record<string, unknown>, name: string, value: unknown): void {
  const present = target[name];
  if (isCopied(present) && isCopied(value)) present.copy(value);
  else target[name] = value;
}
