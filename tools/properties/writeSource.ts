import { constantCase, type HatchingOwner, type NumberRange } from '../../src/look/HatchingProperty.js';
import { describe } from './describe.js';
import type { PropertyRow } from './PropertyRow.js';
import type { TechniqueRow } from './techniques.js';

type Table = Readonly<Record<string, PropertyRow>>;

/** Width of the text of a comment: with indent and asterisk, lines are as long as those of code. */
const LINE_LENGTH = 115;

const HEADER = '// Written by `npm run properties` from tools/properties/table.ts. Change that, not this.\n';

/** src/look/hatchingProperties.ts: what is needed at run time, and the types of the choices. */
export function writePropertyData(table: Table, techniques: Readonly<Record<string, TechniqueRow>>): string {
  const rows = Object.entries(table);
  const types = rows.flatMap(([, row]) => (row.kind === 'choice' ? [choiceType(row)] : []));
  return `${HEADER}import type { HatchingOwner, HatchingProperty, HatchingTechniqueData } from './HatchingProperty.js';

${types.join('\n')}
/** Every property by name: of \`HatchingMaterial\`, and of the owners that some rows name. */
export const HATCHING_PROPERTIES = {
${rows.map(([name, row]) => `${name}: { ${runtimeFields(name, row).join(', ')} },`).join('\n')}
} as const satisfies Record<string, HatchingProperty>;

export type HatchingPropertyName = keyof typeof HATCHING_PROPERTIES;

/** The names of the properties of an owner; \`undefined\` stands for \`HatchingMaterial\` itself. */
export type PropertyNameOf<Owner extends HatchingOwner | undefined> = {
  [Name in HatchingPropertyName]: OwnerOf<(typeof HATCHING_PROPERTIES)[Name]> extends Owner ? Name : never;
}[HatchingPropertyName];

type OwnerOf<Property> = Property extends { owner: infer Owner } ? Owner : undefined;

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

/** Units and conditions of the properties that have any. */
export const HATCHING_FACTS: Readonly<Partial<Record<HatchingPropertyName, HatchingFacts>>> = {
${facts.join('\n')}
};
`;
}

/** src/material/HatchingMaterialProperties.ts: the material's properties and its parameters as types, with their documentation. */
export function writePropertyTypes(table: Table): string {
  const rows = Object.entries(table);
  const types = rows.flatMap(([, row]) => (row.kind === 'choice' && row.owner === undefined ? [row.type] : [])).sort();
  return `${HEADER}import type { Color, ColorRepresentation, ShaderMaterial, Texture, Vector2 } from 'three';
import type { ${types.join(', ')} } from '../look/hatchingProperties.js';
import type { Hand } from '../strokes/hand/Hand.js';
import type { ToneCurve } from './fitToneCurve.js';
import type { HatchingComposition } from './groups/HatchingComposition.js';
import type { HatchingCompositionOptions, PerTriangleOptions } from './groups/ownedProperties.js';
import type { PerTriangle } from './groups/PerTriangle.js';
import type { HatchingMap, Vector2Like } from './propertyValues.js';

/** The parameters of a HatchingMaterial, besides those of three's own \`Material\`. */
export interface HatchingMaterialOptions {
${optionsOf(table)}
${COMPOSITION_DOC}
composition: HatchingComposition | Partial<HatchingCompositionOptions>;
${PER_TRIANGLE_DOC}
perTriangle: Partial<PerTriangleOptions>;
}

/** The properties of \`HatchingMaterial\`. */
export interface HatchingMaterialProperties extends ShaderMaterial {
${fieldsOf(table)}
${COMPOSITION_DOC}
get composition(): HatchingComposition;
set composition(value: HatchingComposition | Partial<HatchingCompositionOptions>);
${PER_TRIANGLE_DOC}
get perTriangle(): PerTriangle;
set perTriangle(value: Partial<PerTriangleOptions>);
}
`;
}

/** src/material/groups/ownedProperties.ts: the same of the objects that own properties. */
export function writeOwnedTypes(table: Table): string {
  return `${HEADER}import type { Vector2, Vector3 } from 'three';
import type { LevelRule, ShadowDirection } from '../../look/hatchingProperties.js';
import type { Vector2Like, Vector3Like } from '../propertyValues.js';

/** The parameters of a \`HatchingComposition\`. */
export interface HatchingCompositionOptions {
${optionsOf(table, 'composition')}
}

/** The properties of \`HatchingComposition\`. */
export interface HatchingCompositionProperties {
${fieldsOf(table, 'composition')}
}

/** The parameters of \`HatchingMaterial.perTriangle\`. */
export interface PerTriangleOptions {
${optionsOf(table, 'perTriangle')}
}

/** The properties of \`HatchingMaterial.perTriangle\`. */
export interface PerTriangleProperties {
${fieldsOf(table, 'perTriangle')}
}

/** The parameters that a \`HatchingShadowMaterial\` has beside those of a \`HatchingMaterial\`. */
export interface HatchingShadowOptions {
${optionsOf(table, 'shadowMaterial')}
}

/** The properties that \`HatchingShadowMaterial\` has beside those of \`HatchingMaterial\`. */
export interface HatchingShadowProperties {
${fieldsOf(table, 'shadowMaterial')}
}
`;
}

const COMPOSITION_DOC = comment(
  wrapped(
    'What counts for a whole picture: exposure, depth fade, focus and vignette. Materials may share one, as the materials of a scene that `applyHatching` hatched do; a new material has its own. A plain object sets numbers of the one that the material has.',
  ),
);

const PER_TRIANGLE_DOC = comment(
  wrapped(
    'What only the techniques of the paper by Suarez et al. read. Set them one by one, or some of them by a plain object.',
  ),
);

const rowsOf = (table: Table, owner?: HatchingOwner): [string, PropertyRow][] =>
  Object.entries(table).filter(([, row]) => row.owner === owner);

/** The properties of an owner as parameters. */
const optionsOf = (table: Table, owner?: HatchingOwner): string =>
  rowsOf(table, owner)
    .map(([name, row]) => `${jsDoc(row)}\n${name}: ${row.kind === 'color' ? 'ColorRepresentation' : setType(row)};`)
    .join('\n');

/** The properties of an owner as fields. */
const fieldsOf = (table: Table, owner?: HatchingOwner): string =>
  rowsOf(table, owner)
    .map(([name, row]) => `${jsDoc(row)}\n${field(name, row)}`)
    .join('\n');

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
  if (row.owner) fields.push(`owner: '${row.owner}'`);
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
    if (row.words) fields.push(`words: ${list(row.words)}`);
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
      if (row.words) return ['number', ...row.words.map((word) => `'${word}'`)].join(' | ');
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
    case 'hand':
      return 'Hand | null';
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
