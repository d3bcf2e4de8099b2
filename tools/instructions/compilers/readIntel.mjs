/**
 * @typedef {object} Instruction
 * @property {number} line
 * @property {number} cost - clocks of the arithmetic pipe for a group of pixels, or instructions issued
 * @property {number} math - clocks of the pipe for roots, powers and the like, where it works beside the other
 * @property {number | null} bits - of the number that marks a branch
 */

/**
 * @typedef {object} Listing
 * @property {number} width - pixels that are shaded as one group
 * @property {Instruction[]} instructions
 * @property {[from: number, to: number][]} regions - lines that a jump may leave out or run again
 */

/** An instruction with its name and width, whatever its predicate. */
const INSTRUCTION = /^(?:\([^)]*\) )?([a-z]\w*)[\w.]*(?: \w+)?\((\d+)\)/;
const NUMBER = /0x([0-9a-f]{8})F/;
const SENDS = ['send', 'sendc', 'sends'];
const HEAD = /SIMD(\d+) shader: \d+ instructions\./;

/** Lanes of the arithmetic pipe, and clocks of eight pixels in the other by operation. */
const LANES = 8;
const POWER = 8;
const INTEGER = 26;
const ROOT = 4;

/**
 * Reads what Mesa's `INTEL_DEBUG=fs` prints of a fragment shader, in the widest form that was compiled.
 *
 * @param {string} text
 * @param {ReadonlySet<number>} marks - the bits of the numbers that mark branches
 * @returns {Listing}
 */
export function readIntel(text, marks = new Set()) {
  const variants = text.split(/^Native code for unnamed /m).flatMap((part) => {
    const head = part.startsWith('fragment') ? HEAD.exec(part) : null;
    return head ? [{ width: Number(head[1]), part }] : [];
  });
  const widest = variants.toSorted((a, b) => b.width - a.width)[0];
  if (!widest) throw new Error('readIntel: the listing holds no fragment shader.');
  return { width: widest.width, ...readLines(widest.part.split('\n'), marks) };
}

function readLines(lines, marks) {
  const instructions = [];
  const regions = [];
  /** The lines at which branches begin that have not ended yet. */
  const open = [];
  const labels = new Map();
  for (const [line, text] of lines.entries()) {
    if (line > 1 && /^(NIR|====|VS Output|SIMD\d+ shader)/.test(text)) break;
    const label = /^(LABEL\d+):/.exec(text);
    if (label) labels.set(label[1], line);
    const found = INSTRUCTION.exec(text);
    if (!found) continue;
    const [, name, width] = found;
    if (name === 'else' || name === 'endif') regions.push([open.pop() + 1, line - 1]);
    if (name === 'if' || name === 'else') open.push(line);
    const start = name === 'while' ? labels.get(/JIP:\s+(LABEL\d+)/.exec(text)?.[1]) : undefined;
    if (start !== undefined) regions.push([start, line]);
    instructions.push(instructionOf(line, name, Number(width), text, marks));
  }
  return { instructions, regions };
}

/** Waits take no time of a pipe, and messages to other units none of these. */
function instructionOf(line, name, width, text, marks) {
  const number = NUMBER.exec(text);
  const bits = number && marks.has(Number.parseInt(number[1], 16)) ? Number.parseInt(number[1], 16) : null;
  const groups = Math.max(width / LANES, 1);
  if (name === 'math') {
    const clocks = text.includes('math pow') ? POWER : text.includes('math int') ? INTEGER : ROOT;
    return { line, cost: 0, math: clocks * groups, bits };
  }
  return { line, cost: name === 'sync' || SENDS.includes(name) ? 0 : groups, math: 0, bits };
}
