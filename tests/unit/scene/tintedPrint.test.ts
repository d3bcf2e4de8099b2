import { Color } from 'three';
import { type PresetName, presets } from 'three-hatching';
import { expect, test } from 'vitest';

/** The colour fill up to which strokes are legible on any colour, as in docs/presets.md. */
const READABLE = 0.75;

const luminanceOf = ({ r, g, b }: Color): number => 0.2126 * r + 0.7152 * g + 0.0722 * b;

/** The contrast of two colours by WCAG 2, from 1 to 21. */
function contrast(a: Color, b: Color): number {
  const [dark, light] = [luminanceOf(a), luminanceOf(b)].sort((x, y) => x - y);
  return (light + 0.05) / (dark + 0.05);
}

/** The printed colour below the strokes, as in `filledColor` and `printedColor` in GLSL. */
const printed = (paper: Color, color: Color, fill: number): Color =>
  new Color(1, 1, 1).lerp(color, fill).multiply(paper);

test.each(Object.keys(presets) as PresetName[])(
  'ink keeps a contrast of 3 : 1 against the fill of any colour: %s',
  (name) => {
    const { ink, paper } = presets[name].material;
    const steps = Array.from({ length: 9 }, (_, i) => i / 8);
    for (const fill of [0, 0.4, READABLE]) {
      for (const r of steps) {
        for (const g of steps) {
          for (const b of steps) {
            const ground = printed(new Color(paper), new Color().setRGB(r, g, b), fill);
            expect(contrast(new Color(ink), ground), `${r}, ${g}, ${b} at ${fill}`).toBeGreaterThanOrEqual(3);
          }
        }
      }
    }
  },
);
