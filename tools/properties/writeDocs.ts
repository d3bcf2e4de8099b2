import type { HatchingOwner } from '../../src/look/HatchingProperty.js';
import { describe } from './describe.js';
import type { PropertyRow } from './PropertyRow.js';

const START = '<!-- Written by `npm run properties` from tools/properties/table.ts. -->';
const END = '<!-- end of the properties -->';

/** The owners of properties beside `HatchingMaterial`, with the text above their tables. */
const OWNERS: Readonly<Record<HatchingOwner, string>> = {
  composition: `## Properties of \`composition\`

What counts for a whole picture, not for one surface. \`composition\` is a \`HatchingComposition\`, which materials may share, as three's
materials share the fog of their scene: \`applyHatching\` gives all materials of a scene one ([composition.md](composition.md)).`,
  perTriangle: `## Properties of \`perTriangle\`

Only the techniques of [the paper by Suarez et al.](research/paper.md), \`triangle\` and \`adjacency\`, read these. The others draw as if
they were not there.`,
  shadowMaterial: `## Properties of HatchingShadowMaterial

A \`HatchingShadowMaterial\` shows the shadows that fall on it, and nothing else, as three's \`ShadowMaterial\` does
([shadows.md](shadows.md)). It has these beside all others.`,
};

/**
 * docs/material.md with the tables of properties as they are now.
 *
 * @throws Error if the page has no place for them
 */
export function writePropertyDocs(page: string, table: Readonly<Record<string, PropertyRow>>): string {
  const [start, end] = [page.indexOf(START), page.indexOf(END)];
  if (start === -1 || end < start) {
    throw new Error(`writePropertyDocs: docs/material.md needs the lines ${START} and ${END}.`);
  }
  const rowsOf = (owner?: HatchingOwner) => Object.entries(table).filter(([, row]) => row.owner === owner);
  const owned = Object.entries(OWNERS).map(
    ([owner, words]) => `${words}\n\n${propertyTable(rowsOf(owner as HatchingOwner))}`,
  );
  const tables = [propertyTable(rowsOf()), ...owned].join('\n\n');
  return `${page.slice(0, start)}${START}\n\n${tables}\n\n${page.slice(end)}`;
}

function propertyTable(rows: readonly (readonly [string, PropertyRow])[]): string {
  const lines = ['| property | default | unit and range | counts for | meaning |', '| --- | --- | --- | --- | --- |'];
  let group = '';
  for (const [name, row] of rows) {
    if (row.group !== group && row.owner === undefined) {
      group = row.group;
      lines.push(`| **${group}** | | | | |`);
    }
    const { sentence, default: fallback, measure, techniques, when, isDefine } = describe(row);
    const choices =
      row.kind === 'choice'
        ? Object.entries(row.choices).map(([choice, meaning]) => `<br>\`'${choice}'\`: ${meaning}`)
        : [];
    const meaning = `${sentence}${choices.join('')}`;
    lines.push(
      `| \`${name}\`${isDefine ? ' ●' : ''} | ${fallback} | ${measure} | ${techniques || 'all'}${when && `, with ${when}`} | ${meaning} |`,
    );
  }
  return lines.join('\n');
}
