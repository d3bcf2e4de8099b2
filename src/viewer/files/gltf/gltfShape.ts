import { ModelError } from '../common/ModelError.js';

/** The context of a check. */
export interface ShapeContext {
  /** The file name, for messages. */
  name: string;
  /** The lengths of the document's lists by name, for index checks. */
  lengths: Readonly<Record<string, number>>;
  /** Paths of optional values that were left out because of a wrong type. */
  leftOut: string[];
}

/** Checks a JSON value against a type, and returns it typed. @throws ModelError if it has another type */
export type Shape<Type> = (value: unknown, at: string, context: ShapeContext) => Type;

const LONGEST_QUOTE = 40;

function damaged(value: unknown, expected: string, at: string, { name }: ShapeContext): ModelError {
  const text = value === null || value === undefined ? 'missing' : JSON.stringify(value);
  const quote = text.length > LONGEST_QUOTE ? `${text.slice(0, LONGEST_QUOTE)}…` : text;
  return new ModelError(`${name} is damaged: ${at} is ${quote}, not ${expected}.`);
}

const simple =
  <Type>(expected: string, isRight: (value: unknown) => boolean): Shape<Type> =>
  (value, at, context) => {
    if (!isRight(value)) throw damaged(value, expected, at, context);
    return value as Type;
  };

const isObject = (value: unknown): value is Record<string, unknown> =>
  typeof value === 'object' && value !== null && !Array.isArray(value);

export const text = simple<string>('a text', (value) => typeof value === 'string');
export const flag = simple<boolean>('true or false', (value) => typeof value === 'boolean');
/** A finite number: JSON can encode infinity as `1e999`. */
export const real = simple<number>('a number', Number.isFinite);
export const whole = simple<number>(
  'a whole number from 0 on',
  (value) => Number.isSafeInteger(value) && (value as number) >= 0,
);

export const oneOf = <Value extends string | number>(...values: readonly Value[]): Shape<Value> =>
  simple<Value>(`one of ${values.join(', ')}`, (value) => values.includes(value as Value));

/** An index into one of the document's lists. */
export const indexIn =
  (list: string): Shape<number> =>
  (value, at, context) => {
    const length = context.lengths[list] ?? 0;
    if (!Number.isInteger(value) || (value as number) < 0 || (value as number) >= length) {
      throw damaged(value, `one of its ${length} ${list}`, at, context);
    }
    return value as number;
  };

export const listOf =
  <Item>(item: Shape<Item>): Shape<Item[]> =>
  (value, at, context) => {
    if (!Array.isArray(value)) throw damaged(value, 'a list', at, context);
    return value.map((one, i) => item(one, `${at}[${i}]`, context));
  };

/** A list with a fixed number of numbers. */
export const reals = (length: number): Shape<number[]> =>
  simple<number[]>(
    `${length} numbers`,
    (value) => Array.isArray(value) && value.length === length && value.every(Number.isFinite),
  );

/** An object with arbitrary keys, and values of one shape. */
export const mapOf =
  <Value>(item: Shape<Value>): Shape<Record<string, Value>> =>
  (value, at, context) => {
    if (!isObject(value)) throw damaged(value, 'an object', at, context);
    return Object.fromEntries(Object.entries(value).map(([key, one]) => [key, item(one, `${at}.${key}`, context)]));
  };

/** The type that a shape returns. */
export type TypeOf<Read> = Read extends Shape<infer Type> ? Type : never;

interface RequiredShape<Type> extends Shape<Type> {
  isRequired: true;
}

/** A field that must be present. */
export const required = <Type>(shape: Shape<Type>): RequiredShape<Type> =>
  Object.assign((...given: Parameters<Shape<Type>>) => shape(...given), { isRequired: true as const });

type Fields = Record<string, Shape<unknown>>;
type RecordOf<All extends Fields> = {
  [Key in keyof All as All[Key] extends RequiredShape<unknown> ? Key : never]: TypeOf<All[Key]>;
} & { [Key in keyof All as All[Key] extends RequiredShape<unknown> ? never : Key]?: TypeOf<All[Key]> | undefined };

/** An object with these fields. Null counts as missing; unknown fields are left out. */
export const record =
  <All extends Fields>(fields: All): Shape<RecordOf<All>> =>
  (value, at, context) => {
    if (!isObject(value)) throw damaged(value, 'an object', at, context);
    const result: Record<string, unknown> = {};
    for (const [key, shape] of Object.entries(fields)) {
      const field = Object.hasOwn(value, key) ? (value[key] ?? undefined) : undefined;
      if (field === undefined && !('isRequired' in shape)) continue;
      const read = shape(field, at === '' ? key : `${at}.${key}`, context);
      if (read !== undefined) result[key] = read;
    }
    return result as RecordOf<All>;
  };

/** An optional value: left out if it has the wrong type. */
export const orNothing =
  <Type>(shape: Shape<Type>): Shape<Type | undefined> =>
  (value, at, context) => {
    try {
      return shape(value, at, context);
    } catch (error) {
      if (!(error instanceof ModelError)) throw error;
      context.leftOut.push(at);
      return undefined;
    }
  };
