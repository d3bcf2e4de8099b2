import type { HatchingCondition } from '../../src/look/HatchingProperty.js';
import { describeRange } from '../../src/material/checkNumber.js';
import { measureWords } from './measures.js';
import type { PropertyRow } from './PropertyRow.js';

/** A property in words, in parts that JSDoc and documentation put together each in their own way. */
export interface PropertyDescription {
  sentence: string;
  /** The value as source code. */
  default: string;
  /** Unit and range, as in `radians in (0, π]`; empty for what is no number. */
  measure: string;
  /** The techniques, as in `'triangle'`, `'adjacency'`; empty for all. */
  techniques: string;
  /** The conditions on other properties, as in `medium: 'dry'`; empty without any. */
  when: string;
  /** Whether another value may need another program. */
  isDefine: boolean;
}

export function describe(row: PropertyRow): PropertyDescription {
  return {
    sentence: row.sentence,
    default: describeDefault(row),
    measure: describeMeasure(row),
    techniques: (row.techniques ?? []).map((name) => `\`'${name}'\``).join(', '),
    when: describeConditions(row.when ?? []),
    isDefine: row.kind === 'choice' || row.kind === 'switch' || row.kind === 'curve',
  };
}

function describeDefault(row: PropertyRow): string {
  switch (row.kind) {
    case 'number': {
      const words = (value: number | null | 'auto'): string =>
        value === Math.PI / 2 ? 'Math.PI / 2' : value === 'auto' ? `'auto'` : `${value}`;
      return withOthers(row.defaultSource ?? words(row.default), row.defaultFor, words);
    }
    case 'vector2':
      return `\`(${row.default.join(', ')})\``;
    case 'color':
      return row.defaultWords;
    case 'choice':
    case 'curve':
      return withOthers(`'${row.default}'`, row.defaultFor, (value) => `'${value}'`);
    case 'tonalArtMap':
      return `\`'${row.default}'\``;
    default:
      return `\`${row.default}\``;
  }
}

/** A default, and those that techniques have in its place. */
function withOthers<Value>(
  fallback: string,
  others: Readonly<Record<string, Value>> = {},
  words: (value: Value) => string,
): string {
  const named = Object.entries(others).map(([name, value]) => [name, words(value)] as const);
  const different = named.filter(([, value]) => value !== fallback);
  return [`\`${fallback}\``, ...different.map(([name, value]) => `for \`'${name}'\` \`${value}\``)].join(', ');
}

function describeMeasure(row: PropertyRow): string {
  if (row.kind !== 'number' && row.kind !== 'vector2' && row.kind !== 'point') return '';
  const measure = measureWords(row.measure, row.kind === 'number' ? row.measureOnScreen : undefined);
  if (row.kind !== 'number') return measure;
  const range =
    row.range &&
    `in ${describeRange(row.range)
      .replace(`${Math.PI / 2}`, 'π/2')
      .replace(`${Math.PI}`, 'π')}`;
  const number = [measure, range].filter(Boolean).join(' ');
  return row.kind === 'number' && row.isAuto ? `${number}, or \`'auto'\`` : number;
}

const describeConditions = (when: HatchingCondition | readonly HatchingCondition[]): string =>
  [when].flat().map(describeCondition).join(', or ');

function describeCondition(condition: HatchingCondition): string {
  const parts = Object.entries(condition).map(([name, values]) =>
    'not' in values ? `\`${name}\` other than ${inCode(values.not)}` : `\`${name}\` ${values.map(inCode).join(' or ')}`,
  );
  return parts.join(' and ');
}

const inCode = (value: unknown): string => `\`${typeof value === 'string' ? `'${value}'` : value}\``;
