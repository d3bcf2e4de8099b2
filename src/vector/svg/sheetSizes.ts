/** Sheets of paper by name, upright: width and height in millimetres, after ISO 216 and ANSI/ASME Y14.1. */
export const SHEET_SIZES = {
  A0: [841, 1189],
  A1: [594, 841],
  A2: [420, 594],
  A3: [297, 420],
  A4: [210, 297],
  A5: [148, 210],
  A6: [105, 148],
  Letter: [215.9, 279.4],
  Legal: [215.9, 355.6],
  Tabloid: [279.4, 431.8],
} as const satisfies Record<string, readonly [width: number, height: number]>;

export type SheetName = keyof typeof SHEET_SIZES;

/** A sheet of paper. Lengths are in millimetres. */
export interface Sheet {
  size: readonly [width: number, height: number];
  /** Whether it is turned to suit the picture: neither its name nor its size has an orientation. */
  suits: boolean;
}

export const MILLIMETRES_PER_INCH = 25.4;

/** The shortest and the longest side of a sheet, millimetres. */
const SHORTEST = 1;
const LONGEST = 5000;

const SIZE = /^(\d+(?:\.\d+)?|\.\d+)\s*(mm|in)?\s*[x×]\s*(\d+(?:\.\d+)?|\.\d+)\s*(mm|in)?$/;

/**
 * The sheet that a text names: `A4`, `Letter landscape`, or `WxH` in millimetres or inches, as `200x150` and `8.5x11in`.
 *
 * @returns undefined if it names none
 */
export function sheetNamed(text: string): Sheet | undefined {
  const plain = text.trim().toLowerCase();
  const [name, turn = 'suited', ...rest] = plain.split(/[\s-]+/);
  const known = Object.entries(SHEET_SIZES).find(([one]) => one.toLowerCase() === name)?.[1];
  if (known && rest.length === 0) {
    if (turn === 'suited') return { size: known, suits: true };
    if (turn === 'portrait') return { size: known, suits: false };
    return turn === 'landscape' ? { size: turned(known), suits: false } : undefined;
  }
  const [, width, unit, height, lastUnit] = SIZE.exec(plain) ?? [];
  // A unit after the height applies to both.
  const isMixed = unit !== undefined && unit !== lastUnit;
  if (width === undefined || isMixed) return undefined;
  const factor = lastUnit === 'in' ? MILLIMETRES_PER_INCH : 1;
  const size = [Number(width) * factor, Number(height) * factor] as const;
  return size.every(isSide) ? { size, suits: false } : undefined;
}

/** Whether a value is the side of a sheet that can be drawn on, millimetres. */
export const isSide = (value: unknown): value is number =>
  typeof value === 'number' && value >= SHORTEST && value <= LONGEST;

/** The valid sheets, for messages. */
export const SHEET_WORDS = `${Object.keys(SHEET_SIZES).join(', ')}, one of them with portrait or landscape after it, or a size as 200x150 in millimetres or 8.5x11in, with sides from ${SHORTEST} to ${LONGEST} mm`;

/** The size of a sheet, turned to suit the picture. isWide: whether the picture is wider than high. */
export const lyingSize = ({ size, suits }: Sheet, isWide: boolean): readonly [number, number] =>
  suits && isWide ? turned(size) : size;

const turned = ([width, height]: readonly [number, number]): readonly [number, number] => [height, width];
