import { describe } from './describe.js';
import type { PropertyRow } from './PropertyRow.js';

const START = '<!-- Written by `npm run properties` from tools/properties/table.ts. -->';
const END = '<!-- end of the properties -->';

/**
 * docs/material.md with the table of properties as it is now.
 *
 * @throws Error if the page has no place for it
 */
export function writePropertyDocs(page: string, table: Readonly<Record<string, PropertyRow>>): string {
  const [start, end] = [page.indexOf(START), page.indexOf(END)];
  if (start === -1 || end < start) {
    throw new Error(`writePropertyDocs: docs/material.md needs the lines ${START} and ${END}.`);
  }
  return `${page.slice(0, start)}${START}\n\n${propertyTable(table)}\n\n${page.slice(end)}`;
}

function propertyTable(table: Readonly<Record<string, PropertyRow>>): string {
  const lines = ['| property | default | unit and range | counts for | meaning |', '| --- | --- | --- | --- | --- |'];
  let group = '';
  for (const [name, row] of Object.entries(table)) {
    if (row.group !== group) {
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
