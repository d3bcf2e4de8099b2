const IDENTIFIER = /(?<!\w)[a-z_]\w*/gi;

/** Everything in code that could be a name in a shader. */
export const wordsIn = (code: string): string[] => code.match(IDENTIFIER) ?? [];

const LETTERS = [...'abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ'];

/** What declares a name that shaders share: functions, macros, structures, their members and varyings. */
const DECLARATIONS = [
  /^\w+ (\w+)\(/gm,
  /^#define (\w+)/gm,
  /^struct (\w+)/gm,
  /\bvarying(?: \w+)+ (\w+)/g,
  /\b(?:float|u?int|bool|[ui]?vec[234]|mat[234]|[A-Z]\w+) (\w+)(?=[=;,)[])/g,
];
const STRUCTURE = /^struct \w+\{([^}]*)\}/gm;
const MEMBER = / (\w+);/g;

/** What others give or read by its name: values of materials and of vertices. */
const GIVEN = /\b(?:uniform|attribute)(?: \w+)+ (\w+)/g;

/**
 * Short names for those that shaders declare and nothing else knows, the shortest for the most frequent: an underscore, which keeps them apart
 * from names of users, and letters.
 *
 * @param shaders all of them, without comments, with single spaces
 * @param known names that stay as they are
 */
export function shortNames(shaders: readonly string[], known: ReadonlySet<string>): ReadonlyMap<string, string> {
  const all = shaders.join('\n');
  const declared = new Set(DECLARATIONS.flatMap((pattern) => [...all.matchAll(pattern)].map(([, name]) => name)));
  for (const [, members] of all.matchAll(STRUCTURE))
    for (const [, name] of ` ${members}`.matchAll(MEMBER)) declared.add(name);
  for (const [, name] of all.matchAll(GIVEN)) declared.delete(name);
  const counts = new Map<string, number>();
  for (const [name] of all.matchAll(IDENTIFIER)) counts.set(name, (counts.get(name) ?? 0) + 1);
  const weight = (name: string): number => counts.get(name)! * name.length;
  return new Map(
    [...declared]
      .filter((name) => name.length > 3 && !known.has(name))
      .sort((a, b) => weight(b) - weight(a) || (a < b ? -1 : 1))
      .map((name, i) => [name, shortName(i)]),
  );
}

function shortName(i: number): string {
  const { length } = LETTERS;
  return `_${i < length ? '' : LETTERS[Math.floor(i / length) - 1]}${LETTERS[i % length]}`;
}

/** The text with short names. Names of files to include stay as they are. */
export const withShortNames = (text: string, short: ReadonlyMap<string, string>): string =>
  text.replace(/^#include.*|(?<!\w)[a-z_]\w*/gim, (name) => short.get(name) ?? name);
