import { describe } from './describe.js';
import type { PropertyRow } from './PropertyRow.js';
import { TECHNIQUES } from './techniques.js';

const START = '<!-- Written by `npm run properties` from tools/properties/table.ts. -->';
const END = '<!-- end of the properties -->';

/** The text above the table of properties that only the paper's techniques read. */
const PAPER = `## Properties of \`triangle\` and \`adjacency\`

Only the techniques of [the paper by Suarez et al.](research/paper.md) read these. The others draw as if they were not there.`;

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
  const rows = Object.entries(table);
  const ofPaper = rows.filter(([, row]) => isOfPaper(row));
  const others = rows.filter(([, row]) => !isOfPaper(row));
  const tables = `${propertyTable(others)}\n\n${PAPER}\n\n${propertyTable(ofPaper)}`;
  return `${page.slice(0, start)}${START}\n\n${tables}\n\n${page.slice(end)}`;
}

/** Whether only the techniques of the paper by Suarez et al. read a property. */
const isOfPaper = ({ techniques }: PropertyRow): boolean =>
  techniques?.every((name) => TECHNIQUES[name as keyof typeof TECHNIQUES].family === 'perTriangle') ?? false;

function propertyTable(rows: readonly (readonly [string, PropertyRow])[]): string {
  const lines = ['| property | default | unit and range | counts for | meaning |', '| --- | --- | --- | --- | --- |'];
  let group = '';
  for (const [name, row] of rows) {
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
