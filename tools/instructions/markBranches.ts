/** A fragment shader in which every branch has a number. */
export interface MarkedShader {
  /** The source, with a call of a mark at the start of each branch. */
  source: string;
  /** What each branch is, as the source has it; the first is `main` itself. */
  branches: string[];
}

/** How three.js declares the colour of a fragment. */
export const OUTPUT = /layout\s*\(\s*location\s*=\s*0\s*\)\s*out\s+highp\s+vec4\s+pc_fragColor\s*;/;

export const MAIN = /\bvoid\s+main\s*\(\s*\)/;

/** Writes the statement of a mark, by the number of its branch; an empty one marks nothing. */
type Mark = (branch: number) => string;

const LONGEST_NAME = 80;

/** A statement that leaves the rest of its block out. */
const LEAVES = /\b(return|break|continue|discard)\b/;
const CONTROL = /\b(if|for|while)\b\s*\(/y;
const FUNCTION = /^[ \t]*(?:highp |mediump |lowp )?(?!else\b)\w+ (?!if\b)(\w+)\s*\([^;{}]*\)\s*\{/gm;

/**
 * Marks the branches of a fragment shader: `main`, every `if`, `else`, `for`, `while` and `do`, and what follows a statement that may leave
 * its block. Shorter choices (`?:`, `&&`) are not marked. Works on GLSL as three.js hands it to WebGL, with its `#if` left in.
 */
export function markBranches(glsl: string, mark: Mark): MarkedShader {
  const source = withoutComments(glsl);
  const branches: string[] = [];
  const insertions: { at: number; text: string }[] = [];
  const insert = (at: number, text: string): void => void insertions.push({ at, text });
  const next = (name: string): string =>
    mark(branches.push(name.replace(/\s+/g, ' ').trim().slice(0, LONGEST_NAME)) - 1);

  /** Marks the statement at a place. Returns its end. */
  function statement(start: number): number {
    const at = skipSpace(source, start);
    if (source[at] === '{') return block(at);
    if (/^do\b/.test(source.slice(at, at + 3))) {
      // Its condition ends like any statement.
      return endOfSimple(source, branch(at + 2, 'do'));
    }
    CONTROL.lastIndex = at;
    const control = CONTROL.exec(source);
    if (!control) return endOfSimple(source, at);
    const condition = closing(source, CONTROL.lastIndex - 1) + 1;
    const name = source.slice(at, condition);
    const end = branch(condition, name);
    const rest = skipSpace(source, end);
    const hasElse = control[1] === 'if' && /^else\b/.test(source.slice(rest, rest + 5));
    return hasElse ? branch(rest + 4, `else of ${name}`) : end;
  }

  /** Marks a branch and what it holds. Returns its end. */
  function branch(start: number, name: string): number {
    const at = skipSpace(source, start);
    const text = next(name);
    if (source[at] === '{') {
      insert(at + 1, text);
      return block(at);
    }
    insert(at, `{${text}`);
    const end = statement(at);
    insert(end, '}');
    return end;
  }

  /** Marks the statements of a block in braces. Returns its end. */
  function block(open: number): number {
    const end = closing(source, open);
    let at = skipSpace(source, open + 1);
    while (at < end) {
      const after = statement(at);
      const mayLeave = /^(if|for|while|do)\b/.test(source.slice(at, at + 6)) && LEAVES.test(source.slice(at, after));
      at = skipSpace(source, after);
      if (mayLeave && at < end) insert(after, next(`after ${source.slice(after - 40, after)}`));
    }
    return end + 1;
  }

  const all = [...source.matchAll(FUNCTION)].map(({ 0: text, 1: name, index }) => ({
    name,
    open: index + text.length - 1,
  }));
  // `main` is the first branch of all, and what it never calls has none.
  for (const { name, open } of calledFrom('main', all, source)) {
    if (name === 'main') insert(open + 1, next('main'));
    block(open);
  }
  return { source: inserted(source, insertions), branches };
}

/** A function, by its name and the place of the brace that opens it. */
interface ShaderFunction {
  name: string;
  open: number;
}

/** A function and those that it calls, directly or not. Functions of one name count as one. */
function calledFrom(name: string, all: readonly ShaderFunction[], source: string): ShaderFunction[] {
  const called = new Set([name]);
  for (const caller of called) {
    for (const { open } of all.filter((other) => other.name === caller)) {
      const body = source.slice(open, closing(source, open));
      for (const other of all) if (new RegExp(`\\b${other.name}\\s*\\(`).test(body)) called.add(other.name);
    }
  }
  return [...called].flatMap((caller) => all.filter((other) => other.name === caller));
}

/** Comments are blanked, so that all places stay. */
const withoutComments = (source: string): string =>
  source.replace(/\/\/[^\n]*|\/\*[\s\S]*?\*\//g, (comment) => comment.replace(/[^\n]/g, ' '));

/** The next place that holds neither space nor a line of the preprocessor. */
function skipSpace(source: string, start: number): number {
  const space = /(?:\s|#[^\n]*\n)*/y;
  space.lastIndex = start;
  space.exec(source);
  return space.lastIndex;
}

/** The place of the bracket that closes one. */
function closing(source: string, open: number): number {
  const [opener, closer] = source[open] === '(' ? ['(', ')'] : ['{', '}'];
  let depth = 0;
  for (let at = open; at < source.length; at++) {
    if (source[at] === opener) depth++;
    if (source[at] === closer && --depth === 0) return at;
  }
  throw new Error(`markBranches: no ${closer} closes "${source.slice(open, open + 40)}".`);
}

/** The end of a statement without branches. */
function endOfSimple(source: string, start: number): number {
  const end = source.indexOf(';', start);
  if (end < 0) throw new Error(`markBranches: no end of "${source.slice(start, start + 40)}".`);
  return end + 1;
}

/** A source with texts inserted, those at one place in the order in which they were found. */
function inserted(source: string, insertions: readonly { at: number; text: string }[]): string {
  const sorted = insertions.map((insertion, order) => ({ ...insertion, order }));
  sorted.sort((a, b) => a.at - b.at || a.order - b.order);
  let result = '';
  let from = 0;
  for (const { at, text } of sorted) {
    result += source.slice(from, at) + text;
    from = at;
  }
  return result + source.slice(from);
}
