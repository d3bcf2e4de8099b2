import { UsageError } from './UsageError.js';

/** Sheets of paper (ISO 216), upright, in millimetres. */
const SHEETS: Readonly<Record<string, readonly [number, number]>> = {
  a2: [420, 594],
  a3: [297, 420],
  a4: [210, 297],
  a5: [148, 210],
  a6: [105, 148],
};

/** The longest side of a sheet, in millimetres. */
const LONGEST = 5000;

/**
 * The size of a sheet in millimetres: `A4`, `A4 landscape`, or `200x150`.
 *
 * @throws UsageError for anything else
 */
export function sheetOf(text: string): readonly [width: number, height: number] {
  const [name, turn = 'portrait', ...rest] = text
    .trim()
    .toLowerCase()
    .split(/[\s-]+/);
  if (Object.hasOwn(SHEETS, name) && rest.length === 0 && ['portrait', 'landscape'].includes(turn)) {
    const [short, long] = SHEETS[name];
    return turn === 'landscape' ? [long, short] : [short, long];
  }
  const [width, height] = (/^([\d.]+)\s*[x×]\s*([\d.]+)$/i.exec(text.trim()) ?? []).slice(1).map(Number);
  if (width > 0 && height > 0 && width <= LONGEST && height <= LONGEST) return [width, height];
  throw new UsageError(
    `--sheet is ${text}, but must be ${Object.keys(SHEETS).join(', ').toUpperCase()}, one of them with landscape after it, or a size in millimetres as 200x150.`,
  );
}
