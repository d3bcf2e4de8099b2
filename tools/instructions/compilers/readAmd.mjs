/**
 * @typedef {import('./readIntel.mjs').Listing} Listing
 */

const LABEL = /^\s*(BB\d+):/;
const JUMP = /^\s+s_c?branch\w*\s+(BB\d+)/;
const INSTRUCTION = /^\s+([a-z]\w+)/;
const NUMBER = /0x([0-9a-f]{8})/;
const TRANSCENDENTAL = /^v_(rcp|rsq|sqrt|exp|log|sin|cos)_/;
const SLOW_INTEGER = /^v_(mul_lo|mul_hi|mad_u64|mad_i64)_/;

/** Roots, powers and products of 32-bit integers are issued at a quarter of the rate. */
const SLOW = 4;

/**
 * Reads what Mesa's `AMD_DEBUG=useaco,ps,asm` prints of a fragment shader: vector instructions as they are issued.
 *
 * @param {string} text
 * @param {ReadonlySet<number>} marks - the bits of the numbers that mark branches
 * @returns {Omit<Listing, 'width'>}
 */
export function readAmd(text, marks = new Set()) {
  const main = text
    .split(/^(?=Shader (?:prolog|main|epilog) disassembly:)/m)
    .find((part) => part.startsWith('Shader main'));
  if (!main) throw new Error('readAmd: the listing holds no fragment shader.');
  const lines = main.split('\n');
  const labels = new Map(lines.flatMap((text, line) => (LABEL.test(text) ? [[LABEL.exec(text)[1], line]] : [])));
  const regions = [];
  const instructions = [];
  for (const [line, text] of lines.entries()) {
    const target = labels.get(JUMP.exec(text)?.[1]);
    if (target !== undefined) regions.push(target > line ? [line + 1, target - 1] : [target, line]);
    const name = INSTRUCTION.exec(text)?.[1];
    if (!name?.startsWith('v_')) continue;
    const number = NUMBER.exec(text);
    const bits = number && marks.has(Number.parseInt(number[1], 16)) ? Number.parseInt(number[1], 16) : null;
    const isSlow = TRANSCENDENTAL.test(name) || SLOW_INTEGER.test(name);
    instructions.push({ line, cost: isSlow ? SLOW : 1, math: 0, bits });
  }
  return { instructions, regions };
}
