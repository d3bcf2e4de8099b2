import { describeRange } from '../../src/material/checkNumber.js';
import { measureWords } from './measures.js';
import type { PropertyRow } from './PropertyRow.js';

/** A property in words, in parts that JSDoc and documentation put together each in their own way. */
export interface PropertyDescription {
  sentence: string;
  /** As one would write it in source. */
  default: string;
  /** Unit and range, as in `radians in (0, π]`; empty for what is no number. */
  measure: string;
  /** As in `'triangle'`, `'adjacency'`; empty if it counts for all techniques. */
  techniques: string;
  /** Whether another value may need another program. */
  isDefine: boolean;
}

export function describe(row: PropertyRow): PropertyDescription {
  return {
    sentence: row.sentence,
    default: describeDefault(row),
    measure: describeMeasure(row),
    techniques: (row.techniques ?? []).map((name) => `\`'${name}'\``).join(', '),
    isDefine: row.kind === 'choice' || row.kind === 'switch' || row.kind === 'curve',
  };
}

function describeDefault(row: PropertyRow): string {
  switch (row.kind) {
    case 'number':
      return `\`${row.defaultSource ?? row.default}\``;
    case 'vector2':
      return `\`(${row.default.join(', ')})\``;
    case 'color':
      return row.defaultWords;
    case 'choice': {
      const others = Object.entries(row.defaultFor ?? {}).filter(([, value]) => value !== row.default);
      return [`\`'${row.default}'\``, ...others.map(([name, value]) => `for \`'${name}'\` \`'${value}'\``)].join(', ');
    }
    case 'curve':
      return `\`'${row.default}'\``;
    default:
      return `\`${row.default}\``;
  }
}

function describeMeasure(row: PropertyRow): string {
  if (row.kind !== 'number' && row.kind !== 'vector2') return '';
  const measure = row.measure && measureWords(row.measure, row.kind === 'number' ? row.measureOnScreen : undefined);
  if (row.kind === 'vector2') return measure ?? '';
  const range = row.range && `in ${describeRange(row.range).replace(`${Math.PI}`, 'π')}`;
  return [measure, range].filter(Boolean).join(' ');
}
