import {
  AdditiveBlending,
  AlwaysDepth,
  BufferAttribute,
  BufferGeometry,
  DecrementStencilOp,
  EqualDepth,
  EqualStencilFunc,
  GreaterDepth,
  GreaterStencilFunc,
  IncrementStencilOp,
  InvertStencilOp,
  KeepStencilOp,
  LessEqualDepth,
  type MaterialParameters,
  MeshBasicMaterial,
  NeverDepth,
  NotEqualStencilFunc,
  ReplaceStencilOp,
} from 'three';
import { describe, expect, test } from 'vitest';
import { HatchingOutlineMaterial } from '../../../../src/material/outlines/HatchingOutlineMaterial.js';
import {
  copyDrawState,
  type DrawState,
  isShown,
  looksAlike,
  opacityOf,
  takeDrawState,
} from '../../../../src/material/outlines/surfaceRules.js';

const surface = (parameters: MaterialParameters = {}) => new MeshBasicMaterial(parameters);

test.each<[MaterialParameters, number]>([
  [{}, 1],
  [{ opacity: 0.3 }, 1],
  [{ opacity: 0.3, transparent: true }, 0.3],
  [{ opacity: 0, transparent: true }, 0],
  [{ opacity: -1, transparent: true }, 0],
  [{ opacity: 3, transparent: true }, 1],
  [{ opacity: 0.3, alphaHash: true }, 0.3],
  [{ opacity: 0.3, alphaToCoverage: true }, 0.3],
  [{ opacity: 0.3, blending: AdditiveBlending }, 0.3],
  [{ opacity: 0.3, alphaTest: 0.5 }, 0],
  [{ opacity: 0.6, alphaTest: 0.5 }, 1],
])('of a material with %o outlines have the share %d of their ink', (parameters, share) => {
  expect(opacityOf(surface(parameters))).toBe(share);
});

test('vertex colours with alpha count if they fade their material: the most opaque one', () => {
  const geometry = new BufferGeometry();
  const color = new BufferAttribute(Float32Array.of(1, 1, 1, 0.2, 1, 1, 1, 0.5), 4);
  geometry.setAttribute('color', color);
  const faded = surface({ transparent: true, opacity: 0.5, vertexColors: true });
  expect(opacityOf(faded, geometry)).toBe(0.25);
  expect(opacityOf(surface({ transparent: true, opacity: 0.5 }), geometry)).toBe(0.5);
  expect(opacityOf(surface({ vertexColors: true }), geometry)).toBe(1);
  color.setW(1, 0).setW(0, 0).needsUpdate = true;
  expect(isShown(faded, geometry)).toBe(false);
  geometry.setAttribute('color', new BufferAttribute(new Float32Array(6), 3));
  expect(opacityOf(faded, geometry)).toBe(0.5);
});

test('a material that is invisible, writes no colour, is fully transparent or passes no test is not shown', () => {
  expect(isShown(surface())).toBe(true);
  const unseen = [
    { visible: false },
    { colorWrite: false },
    { opacity: 0, transparent: true },
    { depthFunc: NeverDepth },
  ];
  for (const parameters of unseen) expect(isShown(surface(parameters as MaterialParameters))).toBe(false);
});

describe('outlines take from a surface', () => {
  test('nothing, if its state is the default', () => {
    const material = new HatchingOutlineMaterial();
    expect(takeDrawState(material, surface({ opacity: 0.5, side: 2 }), null, {})).toBe(false);
  });

  test('its opacity, unless their own is less, and restore theirs', () => {
    const material = new HatchingOutlineMaterial({ opacity: 0.5 });
    const before: Partial<DrawState> = {};
    expect(takeDrawState(material, surface({ transparent: true, opacity: 0.4 }), null, before)).toBe(true);
    expect(material.opacity).toBe(0.4);
    copyDrawState(before as DrawState, material);
    expect(material.opacity).toBe(0.5);
    const fresh: Partial<DrawState> = {};
    copyDrawState(new HatchingOutlineMaterial({ opacity: 0.5 }), fresh);
    expect(before).toEqual(fresh);
  });

  test.each<[MaterialParameters, MaterialParameters]>([
    [{ depthTest: false }, { depthTest: false }],
    [{ depthFunc: GreaterDepth }, { depthFunc: GreaterDepth }],
    [{ depthFunc: AlwaysDepth }, { depthFunc: AlwaysDepth }],
    [{ depthFunc: EqualDepth }, { depthFunc: LessEqualDepth }],
    [
      { polygonOffset: true, polygonOffsetFactor: -2, polygonOffsetUnits: -3 },
      { polygonOffset: true, polygonOffsetFactor: -2, polygonOffsetUnits: -3 },
    ],
  ])('the tests of %o: %o', (parameters, expected) => {
    const material = new HatchingOutlineMaterial();
    takeDrawState(material, surface(parameters), null, {});
    expect(material).toMatchObject(expected);
    expect(material.depthWrite).toBe(false);
  });

  test('its stencil, without writing to it', () => {
    const material = new HatchingOutlineMaterial();
    const stencil = { stencilWrite: true, stencilFunc: EqualStencilFunc, stencilRef: 3, stencilFuncMask: 7 };
    takeDrawState(material, surface({ ...stencil, stencilZPass: ReplaceStencilOp }), null, {});
    expect(material).toMatchObject(stencil);
    expect(material.stencilZPass).not.toBe(ReplaceStencilOp);
  });

  // Whether a surface passes its stencil test at unmarked pixels, and fails it where it has marked them.
  test.each<[boolean, MaterialParameters]>([
    [true, { stencilRef: 1, stencilFunc: NotEqualStencilFunc, stencilZPass: ReplaceStencilOp }],
    [true, { stencilRef: 3, stencilFunc: GreaterStencilFunc, stencilZPass: ReplaceStencilOp }],
    [true, { stencilRef: 0, stencilFunc: EqualStencilFunc, stencilZPass: IncrementStencilOp }],
    [true, { stencilRef: 8, stencilFuncMask: 7, stencilFunc: EqualStencilFunc, stencilZPass: InvertStencilOp }],
    // The caps of clipped solids, which are drawn where other objects have marked the stencil.
    [false, { stencilRef: 0, stencilFunc: NotEqualStencilFunc, stencilZPass: ReplaceStencilOp }],
    [false, { stencilRef: 1, stencilFunc: EqualStencilFunc, stencilZPass: IncrementStencilOp }],
    [false, { stencilRef: 1, stencilFunc: NotEqualStencilFunc }],
    [false, { stencilRef: 1, stencilFunc: NotEqualStencilFunc, stencilZPass: ReplaceStencilOp, stencilWriteMask: 0 }],
    [false, { stencilRef: 0, stencilFunc: EqualStencilFunc, stencilZPass: DecrementStencilOp }],
  ])('no stencil by which it is drawn once to a pixel, or else this: %s for %o', (isDrawnOnce, parameters) => {
    const material = new HatchingOutlineMaterial();
    takeDrawState(material, surface({ stencilWrite: true, ...parameters }), null, {});
    expect(material.stencilWrite).toBe(!isDrawnOnce);
    expect(
      looksAlike(
        surface({ stencilWrite: true, ...parameters }),
        surface({ stencilWrite: true, ...parameters, stencilZPass: KeepStencilOp }),
      ),
    ).toBe(!isDrawnOnce);
  });

  test('nothing that replaces their own stencil, offset and depth test', () => {
    const own = { stencilWrite: true, stencilRef: 9, polygonOffset: true, polygonOffsetUnits: 5, depthTest: false };
    const material = new HatchingOutlineMaterial(own);
    takeDrawState(
      material,
      surface({ stencilWrite: true, stencilRef: 3, polygonOffset: true, polygonOffsetUnits: 1 }),
      null,
      {},
    );
    expect(material).toMatchObject(own);
  });
});

test('outlines of materials look alike, whatever their colours, unless opacity or tests differ', () => {
  expect(looksAlike(surface(), new MeshBasicMaterial({ color: 'red' }))).toBe(true);
  expect(looksAlike(surface(), surface({ transparent: true, opacity: 0.5 }))).toBe(false);
  expect(looksAlike(surface(), surface({ depthTest: false }))).toBe(false);
  expect(looksAlike(surface({ stencilWrite: true, opacity: 0.4 }), surface({ stencilWrite: true }))).toBe(true);
});
