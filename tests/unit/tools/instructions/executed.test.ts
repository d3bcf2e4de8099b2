import { expect, test } from 'vitest';
import { blockMean } from '../../../../tools/instructions/blockMeans.js';
import { readAmd } from '../../../../tools/instructions/compilers/readAmd.mjs';
import { readIntel } from '../../../../tools/instructions/compilers/readIntel.mjs';
import { withInstructions } from '../../../../tools/instructions/describeInstructions.mjs';
import { executed } from '../../../../tools/instructions/executed.mjs';

const [FIRST, SECOND] = [0xc788b840, 0xc788b8c0];

/** As Mesa 25 lists it: eight pixels, then sixteen, with a branch, a loop and a wait. */
const INTEL = `Native code for unnamed fragment shader GLSL3 (src_hash 0x1)
SIMD8 shader: 1 instructions. 0 loops.
add(8)          g1<1>F          g2<8,8,1>F      g3<8,8,1>F      { align1 1Q };
Native code for unnamed fragment shader GLSL3 (src_hash 0x1)
SIMD16 shader: 9 instructions. 1 loops.
   START B0 (12 cycles)
mul(16)         g4<1>F          g2<8,8,1>F      g3<8,8,1>F      { align1 1H compacted };
(+f0.0) if(16)  JIP:  LABEL1          UIP:  LABEL0              { align1 1H };
   END B0 ->B1 ->B2
add(16)         g101<1>F        (abs)g92<8,8,1>F 0xc788b840F  /* -70000.5F */ { align1 1H @3 };
math sqrt(16)   g71<1>F         g4<8,8,1>F      null<8,8,1>F    { align1 1H @2 $12 };
mad(16)         g53<1>F         g18<8,8,1>F     g24<8,8,1>F     g8<1,1,1>F { align1 1H @6 compacted };
endif(16)       JIP:  LABEL2                                    { align1 1H };
LABEL20:
(+f0.0) break(16) JIP:  LABEL17       UIP:  LABEL17             { align1 1H };
add(16)         g111<1>F        g67<8,8,1>F     0xc788b8c0F  /* -70001.5F */ { align1 1H };
sync nop(1)                     null<0,1,0>UB                   { align1 WE_all 1N $9.src };
while(16)       JIP:  LABEL20                                   { align1 1H };
SIMD32 shader inefficient
`;

test('Tiger Lake: the widest form, by region', () => {
  const listing = readIntel(INTEL, new Set([FIRST, SECOND]));
  expect(listing.width).toBe(16);
  // mul, if, mad, endif, break and while, two clocks each; marks count for nothing.
  expect(executed(listing)).toEqual({ cost: 12, math: 8 });
  const runs = new Map([
    [FIRST, 0.25],
    [SECOND, 3],
  ]);
  // The branch holds mad, the loop break and while.
  expect(executed(listing, runs)).toEqual({ cost: 2 + 2 + 0.25 * 2 + 2 + 3 * 4, math: 0.25 * 8 });
  expect(() => readIntel('')).toThrow('no fragment shader');
});

const AMD = `Pixel Shader:
Shader prolog disassembly:
 BB0:
	v_mov_b32_e32 v9, v8                                      ; 7e120308
Shader main disassembly:
 BB0:
	v_mul_f32_e32 v2, v3, v4                                  ; 10040903
	s_cbranch_execz BB2                                       ; bf880004
BB1:
	v_add_f32_e32 v2, 0xc788b840, v2                          ; 060404ff c788b840
	v_rcp_f32_e32 v2, v3                                      ; 7e045503
	s_branch BB3                                              ; bf820001
BB2:
	v_add_f32_e64 v2, 0xc788b8c0, |v2|                        ; d5030202 000204ff c788b8c0
	v_fma_f32 v2, v3, v4, v5                                  ; d54b0002 04160903
BB3:
	v_add_f32_e32 v2, v3, v4                                  ; 06040903
BB4:
	v_mul_lo_u32 v2, v3, v4                                   ; d5690002 00020903
	s_cbranch_vccnz BB4                                       ; bf87fffd
Shader epilog disassembly:
	v_mov_b32_e32 v9, v8                                      ; 7e120308
`;

test('RDNA 2: what a jump leaves out, and what one runs again', () => {
  const listing = readAmd(AMD, new Set([FIRST, SECOND]));
  expect(listing.regions).toHaveLength(3);
  expect(executed(listing)).toEqual({ cost: 1 + 4 + 1 + 1 + 4, math: 0 });
  const runs = new Map([
    [FIRST, 0.25],
    [SECOND, 0.5],
  ]);
  expect(executed(listing, runs).cost).toBe(1 + 0.25 * 4 + 0.5 * 1 + 1 + 4);
  expect(() => readAmd('')).toThrow('no fragment shader');
});

test('a branch that was copied runs its share in each copy', () => {
  const mark = (line: number) => ({ line, cost: 1, math: 0, bits: FIRST });
  const listing = {
    width: 16,
    instructions: [
      mark(1),
      { line: 2, cost: 10, math: 0, bits: null },
      mark(4),
      { line: 5, cost: 10, math: 0, bits: null },
    ],
    regions: [
      [1, 2],
      [4, 5],
    ] as [number, number][],
  };
  expect(executed(listing, new Map([[FIRST, 0.5]])).cost).toBe(5);
});

test('the first mark of a region is that of its branch; a shorter one within it has no jump', () => {
  const listing = {
    width: 16,
    instructions: [
      { line: 1, cost: 1, math: 0, bits: FIRST },
      { line: 2, cost: 1, math: 0, bits: SECOND },
      { line: 3, cost: 10, math: 0, bits: null },
    ],
    regions: [[1, 3]] as [number, number][],
  };
  const runs = (first: number, second: number) =>
    executed(
      listing,
      new Map([
        [FIRST, first],
        [SECOND, second],
      ]),
    ).cost;
  expect(runs(0.5, 0.1)).toBe(5);
  expect(runs(0.5, 0.9)).toBe(5);
});

test('a group of pixels runs a branch as often as the pixel that runs it most often', () => {
  const runs = [3, 1, 0, 0, 2, 0, 9, 0, 0, 0, 0, 0, 0, 0, 1, 0];
  const shown = [1, 1, 0, 0, 1, 1, 0, 0, 0, 0, 1, 1, 0, 0, 1, 1];
  // The upper left group runs it thrice, the lower right one once; the others show nothing.
  expect(blockMean(runs, shown, 4, [2, 2])).toBe(2);
  expect(blockMean(runs, shown, 4, [1, 1])).toBeCloseTo(7 / 8);
  expect(blockMean(runs, new Uint8Array(16), 4, [2, 2])).toBe(0);
});

const count = (compiled: number, ran: number) => ({ compiled, executed: ran, width: 16, registers: 32 });

test('figures are put between their lines as multiples of Phong', () => {
  const of = (compiled: number, ran: number) => ({ intel: count(compiled, ran), amd: count(compiled, ran) });
  const results = {
    commit: 'abc',
    date: '2026-01-01',
    model: 'torus',
    size: 64,
    cases: { phong: of(10, 10), pen: of(55, 22) },
  };
  const lines = ['before', '<!-- Written by npm run instructions. -->', 'old', '<!-- Until here. -->', 'after'];
  const text = withInstructions(lines.join('\n'), results);
  expect(text).toMatch(/\| `pen` +\| +5\.5 \| +2\.2 \|/);
  expect(text).not.toContain('old');
  expect(text.endsWith('after')).toBe(true);
  expect(withInstructions(text, results)).toBe(text);
  expect(() => withInstructions('nothing', results)).toThrow('lacks');
});
