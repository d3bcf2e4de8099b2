import { MAIN, markBranches, OUTPUT } from './markBranches.js';

/** The branches that one picture counts: one byte each of four words, the first that of `main`. */
export const BRANCHES_PER_PICTURE = 15;

/** The most that a byte counts. */
const FULL = 255;

/**
 * A fragment shader that writes, in place of the colour, how often it has run some of its branches: `main` in the first byte of an
 * RGBA32UI target, then those from `first` on.
 */
export function countedShader(glsl: string, first: number): string {
  const { source } = markBranches(glsl, (branch) => {
    const place = branch === 0 ? 0 : branch - first + 1;
    const isCounted = branch === 0 || (place >= 1 && place <= BRANCHES_PER_PICTURE);
    return isCounted ? `branchRuns[${place}] = min(branchRuns[${place}] + 1u, ${FULL}u);` : '';
  });
  if (!OUTPUT.test(source)) throw new Error('countedShader: the shader has no pc_fragColor.');
  const counted = source
    .replace(
      OUTPUT,
      `layout(location = 0) out highp uvec4 pc_runs; highp vec4 pc_fragColor; highp uint branchRuns[${BRANCHES_PER_PICTURE + 1}];`,
    )
    .replace(MAIN, 'void drawnMain()');
  const words = [0, 1, 2, 3].map((word) =>
    [0, 1, 2, 3].map((byte) => `(branchRuns[${4 * word + byte}] << ${8 * byte}u)`).join(' | '),
  );
  return `${counted}
void main() {
  for (int i = 0; i <= ${BRANCHES_PER_PICTURE}; i++) branchRuns[i] = 0u;
  drawnMain();
  pc_runs = uvec4(${words.join(', ')});
}
`;
}
