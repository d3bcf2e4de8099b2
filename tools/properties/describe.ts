import type { HatchingCondition, TechniqueFamily } from '../../src/look/HatchingProperty.js';
import { describeRange } from '../../src/material/checkNumber.js';
import { measureWords } from './measures.js';
import { inFamilies } from './ofTechniques.js';
import type { PropertyRow } from './PropertyRow.js';
import { TECHNIQUES } from './techniques.js';

/** A property in words, in parts that JSDoc and documentation put together each in their own way. */
export interface PropertyDescription {
  sentence: string;
  /** The value as source code. */
  default: string;
  /** Unit and range, as in `radians in (0, π]`; empty for what is no number. */
  measure: string;
  /** The techniques, as in `'triangle'`, `'adjacency'`, or all but a few; empty for all. */
  techniques: string;
  /** The conditions on other properties, as in `toneModel: 'toon'`; empty without any. */
  when: string;
  /** Whether another value may need another program. */
  isDefine: boolean;
}

export function describe(row: PropertyRow): PropertyDescription {
  return {
    sentence: row.sentence,
    default: describeDefault(row),
    measure: describeMeasure(row),
    techniques: row.techniques ? describeTechniques(row.techniques) : '',
    when: describeConditions(row.when ?? []),
    isDefine: row.kind === 'choice' || row.kind === 'switch' || row.kind === 'curve',
  };
}

/** Names of techniques; where most are meant, those that are not. */
function describeTechniques(techniques: readonly string[]): string {
  const others = Object.keys(TECHNIQUES).filter((name) => !techniques.includes(name));
  const names = (some: readonly string[]): string => some.map((name) => inCode(name)).join(', ');
  return others.length < 3 ? `all but ${names(others)}` : names(techniques);
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

/** A default, and those that families of techniques have in its place. */
function withOthers<Value>(
  fallback: string,
  others: Readonly<Partial<Record<TechniqueFamily, Value>>> = {},
  words: (value: Value) => string,
): string {
  const named = (Object.entries(others) as [TechniqueFamily, Value][]).map(
    ([name, value]) => [name, words(value)] as const,
  );
  const different = new Set(named.map(([, value]) => value).filter((value) => value !== fallback));
  const parts = [...different].map((value) => {
    const families = named.filter(([, other]) => other === value).map(([name]) => name);
    return `for ${describeTechniques(inFamilies(...families))} \`${value}\``;
  });
  return [`\`${fallback}\``, ...parts].join(', ');
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
  return row.kind === 'number' && row.words ? `${number}, or ${row.words.map(inCode).join(' or ')}` : number;
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
