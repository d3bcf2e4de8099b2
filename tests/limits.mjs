/**
 * `npm run test:limits -- npm system`: sets the numbers that two runs have compared with limits side by side, and says which of them have less than a
 * third of their room left. Each run was begun with HATCH_LIMITS=<name>, and for instance another HATCH_CHROMIUM.
 */
import { readdirSync, readFileSync } from 'node:fs';
import { roomLeft } from './roomLeft.mjs';

const [first, second] = process.argv.slice(2);
if (!first || !second)
  throw new Error('limits: give the names of two records, as in "npm run test:limits -- npm system".');

/** @returns {Map<string, import('./browser/recordLimits.js').LimitRecord>} */
function read(name) {
  const folder = new URL(`output/limits/${name}/`, import.meta.url);
  const lines = readdirSync(folder).flatMap((file) => readFileSync(new URL(file, folder), 'utf8').trim().split('\n'));
  return new Map(lines.map((line) => JSON.parse(line)).map((entry) => [entry.key, entry]));
}

const [a, b] = [read(first), read(second)];
const shared = [...a.values()].filter(({ key }) => b.has(key));
const differing = shared.filter(({ key, value }) => b.get(key)?.value !== value);
const near = differing
  .map((entry) => ({ entry, other: b.get(entry.key), room: Math.min(roomLeft(entry), roomLeft(b.get(entry.key))) }))
  .filter(({ room }) => room < 1 / 3)
  .sort((x, y) => x.room - y.room);

console.log(
  `${shared.length} numbers were compared with a limit in both; ${a.size + b.size - 2 * shared.length} in one alone.`,
);
console.log(`${differing.length} of them differ; of these ${near.length} have less than a third of their room left:`);
for (const { entry, other, room } of near)
  console.log(
    `${Math.round(100 * room)} % left: ${entry.key} ${entry.matcher} ${entry.limit}: ${entry.value} and ${other.value}`,
  );
