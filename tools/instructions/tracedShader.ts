import { MAIN, markBranches, OUTPUT } from './markBranches.js';

/** The numbers that mark branches in compiled code begin here. They are exact in 32 bits, and no shader uses them. */
const FIRST = 70_000.5;

/**
 * A fragment shader whose branches can be found in compiled code: each takes a number of its own from a trace, which is a part of the
 * colour far too small to be seen. It begins with a uniform, and its amount is
 * taken, so that compilers cannot work it out or join two numbers into one.
 */
export function tracedShader(glsl: string): { source: string; branches: string[] } {
  const { source, branches } = markBranches(
    glsl,
    (branch) => `branchTrace = abs(branchTrace - ${(FIRST + branch).toFixed(1)});`,
  );
  const traced = source
    .replace(OUTPUT, (output) => `${output} uniform highp float branchSeed; highp float branchTrace;`)
    .replace(MAIN, 'void drawnMain()');
  return {
    source: `${traced}
void main() {
  branchTrace = branchSeed;
  drawnMain();
  pc_fragColor.r += 1e-20 * branchTrace;
}
`,
    branches,
  };
}

/** The bits of what a branch adds to the trace, by which a listing shows it. */
export const traceBits = (branch: number): number => new Uint32Array(new Float32Array([-FIRST - branch]).buffer)[0];
