import { constantCase, type NumberRange } from '../../src/look/HatchingProperty.js';
import { describe } from './describe.js';
import type { PropertyRow } from './PropertyRow.js';
import type { TechniqueRow } from './techniques.js';

type Table = Readonly<Record<string, PropertyRow>>;

const HEADER = '// Written by `npm run properties` from tools/properties/table.ts. Change that, not this.\n';

/** src/look/hatchingProperties.ts: what is needed at run time, and the types of the choices. */
export function writePropertyData(table: Table, techniques: Readonly<Record<string, TechniqueRow>>): string {
  const rows = Object.entries(table);
  const types = rows.flatMap(([, row]) => (row.kind === 'choice' ? [choiceType(row)] : []));
  return `${HEADER}import type { HatchingProperty, HatchingTechniqueData } from './HatchingProperty.js';

${types.join('\n')}
/** Every property of \`HatchingMaterial\`, by name. */
export const HATCHING_PROPERTIES = {
${rows.map(([name, row]) => `${name}: { ${runtimeFields(name, row).join(', ')} },`).join('\n')}
} as const satisfies Record<string, HatchingProperty>;

export type HatchingPropertyName = keyof typeof HATCHING_PROPERTIES;

/** The default of every property; colours as 0xrrggbb. */
export const HATCHING_DEFAULTS = /* @__PURE__ */ defaults();

function defaults(): { readonly [Name in HatchingPropertyName]: (typeof HATCHING_PROPERTIES)[Name]['default'] } {
  const entries = Object.entries(HATCHING_PROPERTIES).map(([name, property]) => [name, property.default]);
  return Object.fromEntries(entries);
}

/** Facts of every technique. */
export const HATCHING_TECHNIQUES = {
${Object.entries(techniques)
  .map(([name, { family, map }]) => `${name}: { family: '${family}', map: '${map}' },`)
  .join('\n')}
} as const satisfies Record<HatchingTechnique, HatchingTechniqueData>;
`;
}

/** src/look/hatchingFacts.ts: what numbers measure and what properties count with, which drawing alone does not need. */
export function writePropertyFacts(table: Table): string {
  const facts = Object.entries(table).flatMap(([name, row]) => {
    const measure = 'measure' in row ? row.measure : undefined;
    const measureOnScreen = row.kind === 'number' ? row.measureOnScreen : undefined;
    const known = JSON.stringify({ measure, measureOnScreen, when: row.when });
    return known === '{}' ? [] : [`${name}: ${known},`];
  });
  return `${HEADER}import type { HatchingFacts } from './HatchingProperty.js';
import type { HatchingPropertyName } from './hatchingProperties.js';

/** Units and conditions of the properties of \`HatchingMaterial\` that have any. */
export const HATCHING_FACTS: Readonly<Partial<Record<HatchingPropertyName, HatchingFacts>>> = {
${facts.join('\n')}
};
`;
}

/** src/material/HatchingMaterialProperties.ts: the material's properties and its parameters as types, with their documentation. */
export function writePropertyTypes(table: Table): string {
  const rows = Object.entries(table);
  const types = rows.flatMap(([, row]) => (row.kind === 'choice' ? [row.type] : [])).sort();
  return `${HEADER}import type { Color, ColorRepresentation, ShaderMaterial, Texture, Vector2, Vector3 } from 'three';
import type { ${types.join(', ')} } from '../look/hatchingProperties.js';
import type { ToneCurve } from './fitToneCurve.js';
import type { HatchingMap, Vector2Like, Vector3Like } from './propertyValues.js';

/** The parameters of a HatchingMaterial, besides those of three's own \`Material\`. */
export interface HatchingMaterialOptions {
${rows.map(([name, row]) => `${jsDoc(row)}\n${name}: ${row.kind === 'color' ? 'ColorRepresentation' : setType(row)};`).join('\n')}
}

/** The properties of \`HatchingMaterial\`. */
export interface HatchingMaterialProperties extends ShaderMaterial {
${rows.map(([name, row]) => `${jsDoc(row)}\n${field(name, row)}`).join('\n')}
}
`;
}

function choiceType({ type, typeSentence, choices }: Extract<PropertyRow, { kind: 'choice' }>): string {
  const items = Object.entries(choices).flatMap(([name, sentence]) => {
    const [first, ...rest] = wrapped(`\`${name}\`: ${plain(sentence)}`);
    return [`- ${first}`, ...rest.map((line) => `  ${line}`)];
  });
  return `${comment([typeSentence, ...items])}
export type ${type} = ${Object.keys(choices)
    .map((name) => `'${name}'`)
    .join(' | ')};
`;
}

function runtimeFields(name: string, row: PropertyRow): string[] {
  const fields = [`kind: '${row.kind}'`, `default: ${defaultSource(row)}`];
  if (row.kind === 'color') fields.push(`uniform: '${row.uniform ?? name}'`);
  if (row.kind === 'texture' || ((row.kind === 'number' || row.kind === 'vector2') && row.uniform !== false))
    fields.push(`uniform: '${name}'`);
  if (row.kind === 'texture') fields.push(`transform: '${name}Transform'`);
  if (row.kind === 'switch' || row.kind === 'choice') fields.push(`define: '${constantCase(name)}'`);
  if (row.kind === 'choice') {
    fields.push(`choices: ${list(Object.keys(row.choices))}`);
    if (row.choicesFor) fields.push(`choicesFor: ${JSON.stringify(row.choicesFor)}`);
  }
  if ('defaultFor' in row && row.defaultFor) fields.push(`defaultFor: ${defaultForSource(row.defaultFor)}`);
  if (row.kind === 'number') {
    if (row.range) fields.push(`range: ${rangeSource(row.range)}`);
    if (row.isAuto) fields.push('isAuto: true');
  }
  if (row.techniques) fields.push(`techniques: ${list(row.techniques)}`);
  return fields;
}

const defaultForSource = (defaults: Readonly<Record<string, unknown>>): string =>
  JSON.stringify(defaults).replaceAll(`${Math.PI / 2}`, 'Math.PI / 2');

const rangeSource = (range: NumberRange): string => JSON.stringify(range).replace(`${Math.PI}`, 'Math.PI');

const list = (names: readonly string[]): string => `[${names.map((name) => `'${name}'`).join(', ')}]`;

function defaultSource(row: PropertyRow): string {
  switch (row.kind) {
    case 'number':
      return row.defaultSource ?? JSON.stringify(row.default);
    case 'color':
      return `0x${row.default.toString(16).padStart(6, '0')}`;
    default:
      return JSON.stringify(row.default);
  }
}

function valueType(row: PropertyRow): string {
  switch (row.kind) {
    case 'number':
      if (row.isAuto) return "number | 'auto'";
      return typeof row.default === 'number' ? 'number' : `number | ${JSON.stringify(row.default)}`;
    case 'color':
      return 'Color';
    case 'vector2':
      return 'Vector2';
    case 'point':
      return 'Vector3 | null';
    case 'texture':
      return 'Texture | null';
    case 'tonalArtMap':
      return 'HatchingMap';
    case 'choice':
      return row.type;
    case 'switch':
      return 'boolean';
    case 'curve':
      return 'ToneCurve';
  }
}

/** Types of values that may be set, where these are wider than those that are read. */
function setType(row: PropertyRow): string {
  if (row.kind === 'vector2') return 'Vector2Like';
  if (row.kind === 'point') return 'Vector3Like | null';
  return row.kind === 'choice' && row.defaultFor ? `${valueType(row)} | 'auto'` : valueType(row);
}

function field(name: string, row: PropertyRow): string {
  if (row.kind === 'color' || row.kind === 'vector2') return `readonly ${name}: ${valueType(row)};`;
  if (setType(row) === valueType(row)) return `${name}: ${valueType(row)};`;
  return `get ${name}(): ${valueType(row)};\nset ${name}(value: ${setType(row)});`;
}

/** Width of the text of a comment: with indent and asterisk, lines are as long as those of code. */
const LINE_LENGTH = 115;

function jsDoc(row: PropertyRow): string {
  const { sentence, default: fallback, measure, techniques, when, isDefine } = describe(row);
  const words = [plain(sentence)];
  if (measure) words.push(`${measure.charAt(0).toUpperCase()}${measure.slice(1)}.`);
  words.push(`Default ${fallback}.`);
  if (techniques || when) {
    const only = techniques.startsWith('all but') ? 'For' : 'Only';
    words.push(`${only} ${[techniques, when && `with ${when}`].filter(Boolean).join(', ')}.`);
  }
  if (isDefine && row.kind !== 'curve') words.push('Another value builds another program.');
  return comment(wrapped(words.join(' ')));
}

function comment(lines: readonly string[]): string {
  return lines.length === 1 ? `/** ${lines[0]} */` : `/**\n${lines.map((line) => ` * ${line}`).join('\n')}\n */`;
}

function wrapped(text: string): string[] {
  const lines = [''];
  for (const word of text.split(' ')) {
    const last = lines[lines.length - 1];
    if (last && last.length + 1 + word.length > LINE_LENGTH) lines.push(word);
    else lines[lines.length - 1] = last ? `${last} ${word}` : word;
  }
  return lines;
}

/** Removes links to other pages of the documentation, which an editor cannot follow. */
const plain = (markdown: string): string => markdown.replace(/ \(\[[^\]]*\]\([^)]*\)\)/g, '');
