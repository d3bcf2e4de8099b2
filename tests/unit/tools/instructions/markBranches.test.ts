import { expect, test } from 'vitest';
import { countedShader } from '../../../../tools/instructions/countedShader.js';
import { markBranches } from '../../../../tools/instructions/markBranches.js';
import { traceBits, tracedShader } from '../../../../tools/instructions/tracedShader.js';

const marked = (glsl: string) => markBranches(glsl, (branch) => `M${branch};`);
const packed = (text: string): string => text.replace(/\s+/g, '');

test('every branch has a mark, with or without braces', () => {
  const { source, branches } = marked(`void main() {
    if (a < b(1.0)) x = 1.0; else if (c) { x = 2.0; } else x = 3.0;
    for (int i = 0; i < 3; i++) x += 1.0;
  }`);
  expect(branches).toEqual([
    'main',
    'if (a < b(1.0))',
    'else of if (a < b(1.0))',
    'if (c)',
    'else of if (c)',
    'for (int i = 0; i < 3; i++)',
  ]);
  expect(packed(source)).toBe(
    packed(`void main() {M0;
      if (a < b(1.0)) {M1; x = 1.0;} else {M2; if (c) {M3; x = 2.0; } else {M4; x = 3.0;}}
      for (int i = 0; i < 3; i++) {M5; x += 1.0;}
    }`),
  );
});

test('what follows a statement that may leave its block is a branch', () => {
  const { source, branches } = marked(`float f(float x) {
    if (x < 0.0) return 0.0;
    return sqrt(x);
  }
  void main() { y = f(x); }`);
  expect(branches).toHaveLength(3);
  expect(packed(source)).toContain(packed('if (x < 0.0) {M1; return 0.0;}M2; return sqrt(x);'));
});

test('a loop with its condition at the end is a branch, with what it holds', () => {
  const { source } = marked('void main() { if (a) do { if (b) break; i++; } while (i < 2.0); c; }');
  expect(packed(source)).toBe(
    packed('void main() {M0; if (a) {M1; do {M2; if (b) {M3; break;} M4; i++; } while (i < 2.0);} M5; c; }'),
  );
});

test('functions that main never calls, comments and the preprocessor are left alone', () => {
  const { branches } = marked(`float unused(float x) { if (x < 0.0) return 0.0; return x; }
  float used(float x) {
    // if (x) { a brace that closes nothing
    #if defined(A)
      if (x > 1.0) x = 1.0;
    #endif
    return x;
  }
  void main() { y = used(x); }`);
  expect(branches).toEqual(['main', 'if (x > 1.0)']);
});

test('a brace that is missing is named', () => {
  expect(() => marked('void main() { if (a) { b;')).toThrow('no } closes');
});

const SHADER = `layout(location = 0) out highp vec4 pc_fragColor;
void main() { if (x > 0.0) pc_fragColor = vec4(1.0); }`;

test('a picture counts main and the branches that it is asked for', () => {
  const second = countedShader(SHADER, 1);
  expect(second).toContain('branchRuns[0] = min(branchRuns[0] + 1u');
  expect(second).toContain('branchRuns[1] = min(branchRuns[1] + 1u');
  const third = countedShader(SHADER, 2);
  expect(third).not.toContain('branchRuns[1] = min');
  expect(() => countedShader('void main() {}', 1)).toThrow('no pc_fragColor');
});

test('what a branch adds to the trace is exact in 32 bits', () => {
  const { source, branches } = tracedShader(SHADER);
  for (const branch of branches.keys()) {
    const [number] = new Float32Array(new Uint32Array([traceBits(branch)]).buffer);
    expect(source).toContain(`branchTrace - ${(-number).toFixed(1)}`);
  }
});
