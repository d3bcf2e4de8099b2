import { Color } from 'three';
import { colorWriter } from '../../material/exposure/pixelColors.js';
import type { SurfaceSamples } from '../../material/exposure/surfaceSamples.js';
import type { HatchingMaterial } from '../../material/HatchingMaterial.js';
import type { Pen } from '../plot/pens.js';
import type { DetailSource } from './readSurface.js';

type Rgb = readonly [r: number, g: number, b: number];

/** A paler colour than this absorbs no light in particular: it is drawn as grey. */
const LEAST = 0.05;

/** The light that an ink or a surface absorbs, sRGB. */
function absorbedBy({ r, g, b }: { r: number; g: number; b: number }): Rgb {
  const absorbed = [1 - r, 1 - g, 1 - b] as const;
  return Math.hypot(...absorbed) < LEAST ? [1, 1, 1] : absorbed;
}

/** The cosine between two colours as the light that they absorb: 1 where one is a tint of the other on white paper. */
function likeness(a: Rgb, b: Rgb): number {
  return (a[0] * b[0] + a[1] * b[1] + a[2] * b[2]) / (Math.hypot(...a) * Math.hypot(...b));
}

/** Triangles of a part that one pen draws. */
export interface PenTriangles {
  /** The colour of the pen; null for the ink of the material, where no pens are listed. */
  ink: string | null;
  /** Vertices of corners. */
  corners: Uint32Array;
}

/** Triangles per step. */
const CHUNK = 4096;

/**
 * Matches colours to the pens of a plotter. Ink on white paper is a tint, so the pen is taken that absorbs the same light in the most similar shares: grey goes
 * to the most neutral pen, and pink to a red one.
 */
export class PenMatcher {
  private readonly absorbed: readonly Rgb[];
  /** The pen of each colour that was asked for, by its rounded numbers. */
  private readonly known = new Map<number, number>();

  constructor(private readonly pens: readonly Pen[]) {
    this.absorbed = pens.map(({ ink }) => absorbedBy(sRgb(new Color(ink))));
  }

  /** The ink itself where no pens are listed. @param ink such as `#1c1a17` */
  inkFor(ink: string): string {
    if (this.pens.length === 0) return ink;
    const { r, g, b } = sRgb(new Color(ink));
    return this.pens[this.matching(r, g, b)].ink;
  }

  /** Divides the triangles of a part among the pens, by the colours of material, vertices and map in their middles. Yields its progress. */
  *divide(source: DetailSource, corners: Uint32Array): Generator<number, PenTriangles[], void> {
    const { pens } = this;
    if (pens.length === 0) return [{ ink: null, corners }];
    const chosen = yield* this.pensOf(source, corners);
    const counts = new Uint32Array(pens.length);
    for (const pen of chosen) counts[pen]++;
    const parts = pens.map(({ ink }, i) => ({ ink, corners: new Uint32Array(3 * counts[i]) }));
    const lengths = new Uint32Array(pens.length);
    for (const [triangle, pen] of chosen.entries())
      for (let k = 0; k < 3; k++) parts[pen].corners[lengths[pen]++] = corners[3 * triangle + k];
    return parts.filter((part) => part.corners.length > 0);
  }

  private *pensOf({ mesh, copy, material }: DetailSource, corners: Uint32Array): Generator<number, Uint8Array, void> {
    const { color, uv } = mesh.geometry.attributes;
    const count = corners.length / 3;
    const colors = color ? new Float32Array(3 * count) : undefined;
    const places = uv ? new Float32Array(2 * count) : undefined;
    for (let t = 0; t < count; t++) {
      for (const vertex of corners.subarray(3 * t, 3 * t + 3)) {
        for (let k = 0; colors && k < 3; k++) colors[3 * t + k] += color.getComponent(vertex, k) / 3;
        for (let k = 0; places && k < 2; k++) places[2 * t + k] += uv.getComponent(vertex, k) / 3;
      }
      if (t % CHUNK === CHUNK - 1) yield (0.5 * t) / count;
    }
    const write = colorWriter(material as HatchingMaterial, { colors, places } as SurfaceSamples);
    const rgb = new Float64Array(3);
    const mixed = new Color();
    const chosen = new Uint8Array(count);
    for (let t = 0; t < count; t++) {
      if (t % CHUNK === CHUNK - 1) yield 0.5 + (0.5 * t) / count;
      write(t, rgb);
      for (let k = 0; copy.tint && k < 3; k++) rgb[k] *= copy.tint[k];
      const { r, g, b } = mixed.setRGB(rgb[0], rgb[1], rgb[2]).convertLinearToSRGB();
      chosen[t] = this.matching(r, g, b);
    }
    return chosen;
  }

  /** The index of the pen for a colour, sRGB. */
  private matching(...rgb: Rgb): number {
    const [r, g, b] = rgb.map((value) => Math.round(63 * Math.min(Math.max(value, 0), 1)));
    const key = (r * 64 + g) * 64 + b;
    const before = this.known.get(key);
    if (before !== undefined) return before;
    const wanted = absorbedBy({ r: r / 63, g: g / 63, b: b / 63 });
    const alike = this.absorbed.map((absorbed) => likeness(absorbed, wanted));
    const best = alike.indexOf(Math.max(...alike));
    this.known.set(key, best);
    return best;
  }
}

const sRgb = (color: Color): Color => color.convertLinearToSRGB();
