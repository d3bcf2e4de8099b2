import { describe, expect, it } from 'vitest';
import { blurToroidal } from '../../../src/strokes/blurToroidal.js';
import type { Hand, HandNumbers, HandStroke } from '../../../src/strokes/hand/Hand.js';
import { learnHand } from '../../../src/strokes/hand/learnHand.js';
import { halfTurn, placeStrokes } from '../../../src/strokes/placeStrokes.js';
import { profileAt, type Stroke, strokeOffset } from '../../../src/strokes/Stroke.js';
import { checkHatchImages } from '../../../src/strokes/tamImages/checkHatchImages.js';
import { generateHatchImages, resolveHatchImageOptions } from '../../../src/strokes/tamImages/generateHatchImages.js';
import { generateThresholds } from '../../../src/strokes/tamImages/generateThresholds.js';
import { type MapDrawing, resolveMapDrawing } from '../../../src/strokes/tamImages/hatchImageOptions.js';
import { cases } from '../../selection.mjs';
import { drawStrokes, finish, hatchImages, requestOf } from './draw.js';
import { drawSwatch, type SwatchDrawing } from './hand/drawSwatch.js';

const hand = (...drawings: Partial<SwatchDrawing>[]): Hand => learnHand(drawings.flatMap(drawSwatch));

const PEN: Partial<SwatchDrawing> = {
  rows: 30,
  length: 14,
  lengthSpread: 0.15,
  width: 0.4,
  taperStart: 0.12,
  taperEnd: 0.3,
  wobble: 0.06,
  spacingSpread: 0.15,
  angleSpread: 1.5,
  curvature: 0.03,
};

const crossed = learnHand([
  ...drawSwatch({ rows: 12, spacing: 1.2 }),
  // Turned about the middle of the first layer, which is at (50, 26.6).
  ...drawSwatch({ rows: 12, spacing: 1.2, seed: 2 }).map((stroke) => turnedAbout(stroke, 50, 26.6, 65)),
]);

const HANDS: Record<string, Hand> = {
  pen: hand(PEN),
  brush: hand({
    ...PEN,
    length: 18,
    width: 1,
    spacing: 2.4,
    widthSpread: 0.2,
    taperStart: 0.3,
    taperEnd: 0.55,
    angleSpread: 4,
    curvature: 0.1,
    wobble: 0.1,
  }),
  flicks: hand({
    rows: 14,
    columns: 8,
    length: 2.2,
    lengthSpread: 0.2,
    width: 0.5,
    taperEnd: 0.8,
    angleSpread: 10,
    spacingSpread: 0.3,
    overlap: -0.4,
  }),
  crossed,
  five: hand({ ...PEN, rows: 5 }),
};

describe.each(Object.entries(HANDS).slice(0, cases(1, 5)))('the map of a hand: %s', { tags: ['more'] }, (_, own) => {
  const { size, tones, style } = resolveHatchImageOptions(requestOf({ hand: own }));
  let known: ReturnType<typeof checkHatchImages> | undefined;
  const report = () => {
    known ??= checkHatchImages(hatchImages(requestOf({ hand: own })));
    return known;
  };

  it('has the mean ink of its tone, to 0.01, and to 0.02 on the level of 16 texels', () => {
    for (const [tone, row] of report().means.entries()) {
      for (const [level, mean] of row.entries()) {
        const side = size >> level;
        expect(Math.abs(mean - (style.maxInk * tone) / (tones - 1))).toBeLessThanOrEqual(side > 16 ? 0.01 : 0.02);
      }
    }
  });

  it('nests in tone and level', () => {
    expect(report().consistent).toBe(true);
  });

  it('is the same for the same hand, from JSON too, and another for another seed', () => {
    const draw = (from: Hand, seed: number) =>
      finish(generateHatchImages(requestOf({ hand: from, size: 64, tones: 4, seed }))).images;
    expect(draw(JSON.parse(JSON.stringify(own)), 5)).toEqual(draw(own, 5));
    expect(draw(own, 5)).not.toEqual(draw(own, 6));
  });

  it('has thresholds that look the same upside down', () => {
    const [{ thresholds }] = finish(generateThresholds(requestOf({ hand: own, size: 64, levels: 1 })));
    for (let i = 0; i < thresholds.length; i++) expect(thresholds[thresholds.length - 1 - i]).toBe(thresholds[i]);
  });

  it('has strokes with the numbers of the hand, within 15 %', () => {
    const drawn = numbersOfMap({ hand: own });
    expectNear(drawn, own.numbers, ['length', 'width', 'curvature', 'taperStart', 'taperEnd', 'wobble']);
    expectNear(drawn, own.numbers, ['lengthSpread', 'angleSpread', 'widthSpread']);
  });

  it('does not repeat more visibly than hatching', () => {
    expect(repetition({ hand: own })).toBeLessThanOrEqual(repetition({ style: 'hatching' }));
  });
});

describe('numbers that were changed since they were learnt', () => {
  const { pen } = HANDS;
  const changed = (numbers: Partial<HandNumbers>): Hand => ({ ...pen, numbers: { ...pen.numbers, ...numbers } });

  const changes: Partial<HandNumbers>[] = [
    { length: 7 },
    { length: 22 },
    { lengthSpread: 0.3 },
    { curvature: -0.08 },
    { taperStart: 0.4 },
    { taperEnd: 0.1 },
    { wobble: 0.15 },
    { angleSpread: 6 },
    { widthSpread: 0.2 },
  ];

  it.each(changes.slice(0, cases(1, 9)))(
    '%o are those of the strokes, and the others stay',
    { tags: ['more'] },
    (numbers) => {
      const own = changed(numbers);
      const drawn = numbersOfMap({ hand: own });
      expectNear(drawn, own.numbers, [
        'length',
        'lengthSpread',
        'width',
        'taperStart',
        'taperEnd',
        'wobble',
        'angleSpread',
      ]);
      if (numbers.widthSpread) expectNear(drawn, own.numbers, ['widthSpread']);
      if (numbers.curvature) expectNear(drawn, own.numbers, ['curvature']);
    },
  );

  it('width scales everything else', () => {
    const [narrow, wide] = [0.2, 0.8].map(
      (width) => resolveHatchImageOptions(requestOf({ hand: changed({ width }) })).style,
    );
    expect(narrow.length[1] / wide.length[1]).toBeCloseTo(4);
    expect(narrow.width).toBe(wide.width);
  });

  it('more random spacing makes strokes more uneven', () => {
    const spreads = [0, 0.5, 1].map(
      (spacingSpread) => numbersOfMap({ hand: changed({ spacingSpread }) }).spacingSpread,
    );
    expect(spreads[1]).toBeGreaterThan(1.1 * spreads[0]);
    expect(spreads[2]).toBeGreaterThan(1.1 * spreads[1]);
  });

  it('clustering makes bundles', () => {
    const [even, grouped] = [0, 0.5].map((clustering) => numbersOfMap({ hand: changed({ clustering }) }));
    expect(grouped.spacingSpread).toBeGreaterThan(1.2 * even.spacingSpread);
  });

  it('a longer stroke than the tile holds is cut', () => {
    const { style } = resolveHatchImageOptions(requestOf({ hand: changed({ length: 1000 }) }));
    expect(style.length[1]).toBeLessThanOrEqual(1.5);
  });
});

describe('crossing', () => {
  it.each([
    [30, false],
    [-30, false],
    [65, true],
    [-65, true],
    [90, true],
  ])('at %s degrees runs in that direction', (crossingAngle, across) => {
    const own: Hand = { ...crossed, numbers: { ...crossed.numbers, crossingAngle } };
    const { layers } = resolveHatchImageOptions(requestOf({ hand: own })).style;
    expect(layers[1].across).toBe(across);
    const strokes = finish(placeStrokes(resolveHatchImageOptions(requestOf({ hand: own, size: 64 }))));
    // Seen as the sheet is seen, where y goes down: the direction of a straight stroke from end to end.
    const angles = strokes
      .filter(({ layer }) => layer === 1)
      .map(({ slope }) => ((across ? Math.atan2(-1, slope) : Math.atan2(-slope, 1)) * 180) / Math.PI);
    for (const angle of angles) {
      const off = (((angle - crossingAngle) % 180) + 270) % 180;
      expect(Math.abs(off - 90)).toBeLessThan(0.5);
    }
    expect(angles.length).toBeGreaterThan(5);
  });

  it('begins at its tone', () => {
    const own: Hand = { ...crossed, numbers: { ...crossed.numbers, crossingFrom: 0.6 } };
    const strokes = finish(placeStrokes(resolveHatchImageOptions(requestOf({ hand: own, size: 64, tones: 11 }))));
    expect(Math.min(...strokes.filter(({ layer }) => layer === 1).map(({ tone }) => tone))).toBe(7);
  });
});

describe('a stroke with a profile', () => {
  const own = hand({ ...PEN, curvature: 0.12, rows: 3 });
  const stroke: Stroke = finish(
    placeStrokes(resolveHatchImageOptions(requestOf({ hand: own, size: 64, tones: 4 }))),
  )[0];

  it('bulges on the map to the side to which it bulges on the sheet', () => {
    // On the sheet to the right-hand side of the direction of drawing, which is down; v goes up.
    expect(own.numbers.curvature).toBeGreaterThan(0.1);
    const flat = { ...stroke, slope: 0 };
    expect(strokeOffset(flat, 0) / flat.length).toBeLessThan(-0.08);
  });

  it('is the same image after a half turn of both', () => {
    const one = { ...stroke, u: 0.25, v: 0.375 };
    const [image, turned] = [drawStrokes([one], 64), drawStrokes([halfTurn(one)], 64)];
    expect(turned).toEqual(image.toReversed());
    expect(image).not.toEqual(image.toReversed());
  });

  it('has no seams: it is the same wherever the tile begins', () => {
    const at = (u: number, v: number) => drawStrokes([{ ...stroke, u, v }], 64);
    const [inside, wrapped] = [at(0.5, 0.5), at(0, 0)];
    for (let row = 0; row < 64; row++) {
      for (let column = 0; column < 64; column++) {
        expect(wrapped[((row + 32) & 63) * 64 + ((column + 32) & 63)]).toBe(inside[row * 64 + column]);
      }
    }
  });
});

describe('errors for bad hands', () => {
  const { pen } = HANDS;
  it.each<[MapDrawing, string]>([
    [{ hand: pen, style: 'ruled' }, 'style is ruled, but must be left out beside a hand'],
    [{ hand: 'mine' as never }, 'hand is mine, but must be { version, strokes, numbers }; learnHand makes one'],
    [{ hand: pen, strokeTexels: 4 }, 'strokeTexels is 4, but must be a number from 1.2 to 2.6 texels for a hand'],
    [{ hand: { ...pen, version: 3 as 1 } }, 'hand.version is 3, but must be 1'],
    [{ hand: { ...pen, numbers: { ...pen.numbers, length: -1 } } }, 'hand.numbers.length is -1'],
    [{ hand: { ...pen, strokes: [{ points: [0, 0, 0, 0], widths: [1, 1] }] } }, 'all strokes are dots'],
  ])('%#', (options, sentence) => {
    // Slow checks run when the strokes are prepared.
    expect(() => {
      resolveMapDrawing(options);
      requestOf(options);
    }).toThrow(sentence);
  });
});

/** The numbers of the strokes of the lightest tones of the finest level, in millimetres of the hand. */
function numbersOfMap(drawing: MapDrawing & { hand: Hand }): HandNumbers {
  const request = resolveHatchImageOptions(requestOf(drawing));
  const scale = (request.size * drawing.hand.numbers.width) / request.style.width;
  const strokes = finish(placeStrokes(request))
    .filter(({ tone, layer }) => tone <= 3 && layer === 0)
    .slice(0, 2000);
  return learnHand(
    strokes.map((stroke) => sheetStroke(stroke, scale, drawing.hand.numbers.width / request.style.width)),
  ).numbers;
}

function sheetStroke(stroke: Stroke, tile: number, texel: number): HandStroke {
  const points: number[] = [];
  const widths: number[] = [];
  for (let i = 0; i <= 48; i++) {
    const x = (2 * i) / 48 - 1;
    points.push(tile * (stroke.u + 0.5 * stroke.length * x), -tile * (stroke.v + strokeOffset(stroke, x)));
    widths.push(texel * stroke.width * profileAt(stroke.profile!.width, x));
  }
  return { points, widths };
}

/** Expects numbers within 15 %, or to be hardly there in both. */
function expectNear(drawn: HandNumbers, wanted: HandNumbers, names: (keyof HandNumbers)[]): void {
  const least: Partial<HandNumbers> = {
    lengthSpread: 0.07,
    angleSpread: 0.3,
    widthSpread: 0.03,
    taperStart: 0.02,
    taperEnd: 0.02,
    curvature: 0.01,
    wobble: 0.01 * wanted.length,
  };
  for (const name of names) {
    const tolerance = Math.max(0.15 * Math.abs(wanted[name]), least[name] ?? 0);
    expect(Math.abs(drawn[name] - wanted[name]), `${name}: ${drawn[name]} for ${wanted[name]}`).toBeLessThanOrEqual(
      tolerance,
    );
  }
}

/**
 * How visibly the tile repeats: the share of the variance that is left when the eye, some way off, no longer sees single strokes. Four
 * tiles side by side repeat all of it. The mean of all tones but paper and the darkest.
 */
function repetition(drawing: MapDrawing): number {
  const { images, size } = hatchImages(requestOf(drawing));
  const tones = images.slice(1, -1);
  const variance = (field: Float32Array): number => {
    const mean = field.reduce((sum, value) => sum + value, 0) / field.length;
    return field.reduce((sum, value) => sum + (value - mean) ** 2, 0) / field.length;
  };
  const shares = tones.map(([image]) => {
    const field = Float32Array.from(image);
    return variance(blurToroidal(field, size, 8)) / variance(field);
  });
  return shares.reduce((sum, share) => sum + share, 0) / shares.length;
}

function turnedAbout(stroke: HandStroke, x: number, y: number, degrees: number): HandStroke {
  const [cosine, sine] = [Math.cos((degrees * Math.PI) / 180), Math.sin((degrees * Math.PI) / 180)];
  const points = stroke.widths.flatMap((_, i) => {
    const [dx, dy] = [stroke.points[2 * i] - x, stroke.points[2 * i + 1] - y];
    return [x + dx * cosine - dy * sine, y + dx * sine + dy * cosine];
  });
  return { ...stroke, points };
}
