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

/** The names of values, and in their place those of the values in a plain object: `weights.creases`. */
export const namesIn = (values: object): string[] =>
  Object.entries(values).flatMap(([name, value]) =>
    isGroup(value) ? namesIn(value).map((inner) => `${name}.${inner}`) : name,
  );

const isGroup = (value: unknown): value is object =>
  typeof value === 'object' && value !== null && Object.getPrototypeOf(value) === Object.prototype;

type Values = Record<string, unknown>;

/** The object that holds a value of a material, and its name there. */
function placeOf(material: object, name: string): [holder: Values, key: string] {
  const values = material as unknown as Values;
  const [group, key] = name.split('.');
  return key === undefined ? [values, name] : [values[group] as Values, key];
}

/** The values that a material or a composition was given. Other values that it has are edits of the user. */
export class GivenValues {
  private readonly values: Values = {};

  constructor(
    material: object,
    private readonly names: readonly string[],
  ) {
    for (const name of names) this.note(material, name);
  }

  /** Sets a property, unless it was edited. */
  give(material: object, name: string, value: unknown): void {
    const [target, key] = placeOf(material, name);
    if (!isSame(target[key], this.values[name])) return;
    set(target, key, value);
    this.note(material, name);
  }

  /** Copies the edits of a material to another one. @param except names of properties that stay */
  copyEdits(from: object, to: object, except: readonly string[] = []): void {
    for (const name of this.names) {
      const [source, key] = placeOf(from, name);
      const value = source[key];
      if (except.includes(name) || value === undefined || isSame(value, this.values[name])) continue;
      set(placeOf(to, name)[0], key, value);
    }
  }

  private note(material: object, name: string): void {
    const [source, key] = placeOf(material, name);
    const value = source[key];
    this.values[name] = isCopied(value) ? value.clone() : value;
  }
}

function set(target: Values, name: string, value: unknown): void {
  const present = target[name];
  if (isCopied(present) && isCopied(value)) present.copy(value);
  else target[name] = value;
}
