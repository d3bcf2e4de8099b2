/** Words that stand before a name without being its type. */
const NO_TYPES = new Set('return else in out inout const if do while define undef ifdef ifndef if elif'.split(' '));

const IDENTIFIER = /(?<![.\w])[a-z_]\w*/gi;

const identifiersIn = (text: string): string[] => text.match(IDENTIFIER) ?? [];

/**
 * The names that functions of a program may share with what lies in other files: those that macros mention, and those of uniforms,
 * attributes and varyings.
 */
export function sharedNames(texts: readonly string[]): ReadonlySet<string> {
  const lines = texts.flatMap((text) => text.match(/^\s*(#define|(flat )?(uniform|attribute|varying)) .*/gm) ?? []);
  return new Set(lines.flatMap(identifiersIn));
}

/**
 * Names the parameters and variables of functions by single letters. A function that includes other files keeps its names, since those may
 * know them; so does everything in the set.
 *
 * @param text without comments, with single spaces
 */
export function withShortLocals(text: string, shared: ReadonlySet<string>): string {
  let short = '';
  let end = 0;
  for (const { index } of text.matchAll(/^\w+ \w+\(/gm)) {
    if (index < end) continue;
    const body = text.indexOf('{', index);
    // A macro, or a declaration without a body.
    if (body < 0 || /[;#]/.test(text.slice(index, body))) continue;
    const after = closing(text, body) + 1;
    short += text.slice(end, index) + renamed(text.slice(index, after), shared);
    end = after;
  }
  return short + text.slice(end);
}

/** The index of the brace that closes the one at an index. */
function closing(text: string, open: number): number {
  let depth = 0;
  let at = open;
  do {
    if (text[at] === '{') depth++;
    if (text[at] === '}') depth--;
  } while (depth > 0 && ++at < text.length);
  return at;
}

function renamed(code: string, shared: ReadonlySet<string>): string {
  if (code.includes('#include')) return code;
  const used = new Set([...identifiersIn(code), ...shared]);
  const letters = [...'abcdefghijklmnopqrstuvwxyz'].filter((letter) => !used.has(letter));
  const names = new Map<string, string>();
  for (const [, type, name] of code.slice(code.indexOf('(')).matchAll(/(?<![.\w])(\w+) (\w+)(?=[=;,)[])/g)) {
    if (NO_TYPES.has(type) || name.length === 1 || names.has(name) || shared.has(name) || isCalled(code, name))
      continue;
    const letter = letters.shift();
    if (letter) names.set(name, letter);
  }
  return code.replace(IDENTIFIER, (name) => names.get(name) ?? name);
}

const isCalled = (code: string, name: string): boolean => new RegExp(`\\b${name}\\(`).test(code);
