import pixelmatch from 'pixelmatch';

/** A decoded picture: RGBA, top row first. */
export interface Picture {
  width: number;
  height: number;
  data: Uint8Array;
}

/** The result of the gate for a picture. Only `different` fails. */
export interface Verdict {
  verdict: 'identical' | 'close' | 'different';
  /** One line for the report. */
  text: string;
  /** The pixels that differ, in red on the faded golden; none where the pictures are identical or not of one size. */
  diff?: Picture;
}

/** pixelmatch's threshold, and the part of the pixels that may lie above it. */
const THRESHOLD = 0.1;
const ALLOWED_PIXELS = 0.001;
/** The largest difference of the whole ink, as a share of the golden's. */
const ALLOWED_INK = 0.0075;

/**
 * Compares a picture with its golden.
 *
 * Equal decoded pixels are what one rasteriser gives on every run. Where they are not equal (another processor or
 * rasteriser), two things must hold:
 *
 * - At most 0.1 % of the pixels differ by pixelmatch at 0.1, antialiased ones included: hatching is made of edges.
 * - The whole ink of the picture is that of the golden to within 0.75 %. Strokes that are 5 % too wide darken many pixels by
 *   less than pixelmatch sees (0.04 % of the pixels at most, where another rasteriser gives 0.11 %), but they add 3.2 to
 *   4.6 % of ink, and 2 % too wide adds 1.3 %; between SwiftShader and llvmpipe it differs by 0.22 % at most. Measured on
 *   the scenarios beside this file.
 */
export function compareWithGolden(actual: Picture, golden: Picture): Verdict {
  const { width, height } = golden;
  if (actual.width !== width || actual.height !== height) {
    return {
      verdict: 'different',
      text: `different: ${actual.width}×${actual.height} pixels, the golden has ${width}×${height}`,
    };
  }
  if (Buffer.compare(actual.data, golden.data) === 0) return { verdict: 'identical', text: 'identical' };

  const diff = { width, height, data: new Uint8Array(width * height * 4) };
  const count = pixelmatch(golden.data, actual.data, diff.data, width, height, {
    threshold: THRESHOLD,
    includeAA: true,
  });
  const pixels = count / (width * height);
  const ink = inkOf(actual) / inkOf(golden) - 1;
  const verdict = pixels <= ALLOWED_PIXELS && Math.abs(ink) <= ALLOWED_INK ? 'close' : 'different';
  return {
    verdict,
    text:
      `${verdict}: ${percent(pixels)} of the pixels differ (pixelmatch ${THRESHOLD}, ${percent(ALLOWED_PIXELS)} allowed), ` +
      `ink by ${percent(ink)} (${percent(ALLOWED_INK)} allowed)`,
    diff,
  };
}

/** The sum of the distances from white. Never 0, so that two blank pictures have a ratio. */
function inkOf({ data }: Picture): number {
  let ink = 1;
  for (let i = 0; i < data.length; i += 4) ink += 765 - data[i] - data[i + 1] - data[i + 2];
  return ink;
}

const percent = (part: number) => `${(100 * part).toFixed(3)} %`;

/** Whether every pixel has the same colour, as with a lost context, a missing model or a camera inside the model. */
export function isSingleColour({ data }: Picture): boolean {
  const words = new Uint32Array(data.slice().buffer);
  return words.every((word) => word === words[0]);
}
