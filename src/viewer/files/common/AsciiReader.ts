const SPACE = 0x20;
const MINUS = 0x2d;
const PLUS = 0x2b;
const DOT = 0x2e;
const HASH = 0x23;
const ZERO = 0x30;
const NINE = 0x39;
const LINE_FEED = 0x0a;
const CARRIAGE_RETURN = 0x0d;
/** Integers below this are exact as doubles, and so is their product or quotient with a power of ten of the table. */
const MAX_EXACT = 2 ** 53;
const POWERS_OF_TEN = Array.from({ length: 23 }, (_, i) => 10 ** i);

const isLineEnd = (byte: number): boolean => byte === LINE_FEED || byte === CARRIAGE_RETURN;

/** Reads words and numbers separated by white space, without creating a string per number. */
export class AsciiReader {
  private readonly decoder = new TextDecoder('latin1');

  /** @param at the byte offset to begin at */
  constructor(
    private readonly bytes: Uint8Array,
    private at = 0,
  ) {}

  /** Skips white space. @returns whether the end is reached */
  get isAtEnd(): boolean {
    while (this.at < this.bytes.length && this.bytes[this.at] <= SPACE) this.at++;
    return this.at >= this.bytes.length;
  }

  /** Skips blanks within the line. @returns whether the line ends here, or continues with a comment after "#" */
  get isAtLineEnd(): boolean {
    const { bytes } = this;
    while (this.at < bytes.length && bytes[this.at] <= SPACE && !isLineEnd(bytes[this.at])) this.at++;
    return this.at >= bytes.length || isLineEnd(bytes[this.at]) || bytes[this.at] === HASH;
  }

  /** The number of bytes left. */
  get bytesLeft(): number {
    return this.bytes.length - this.at;
  }

  /** The next word, or '' at the end. */
  word(): string {
    if (this.isAtEnd) return '';
    const start = this.at;
    this.skipWord();
    return this.decoder.decode(this.bytes.subarray(start, this.at));
  }

  /** The next word, without consuming it. */
  peekWord(): string {
    const word = this.word();
    this.at -= word.length;
    return word;
  }

  /** Skips so many bytes. */
  skip(bytes: number): void {
    this.at += bytes;
  }

  /** Reads the next word as a number; NaN if it is none. */
  number(): number {
    if (this.isAtEnd) return NaN;
    const { bytes } = this;
    const start = this.at;
    let at = start;
    const isNegative = bytes[at] === MINUS;
    if (isNegative || bytes[at] === PLUS) at++;
    let digits = 0;
    let digitCount = 0;
    let decimals = -1;
    for (; at < bytes.length; at++) {
      const byte = bytes[at];
      if (byte >= ZERO && byte <= NINE) {
        digits = 10 * digits + byte - ZERO;
        digitCount++;
        if (decimals >= 0) decimals++;
      } else if (byte === DOT && decimals < 0) decimals = 0;
      else break;
    }
    const isPlain = at >= bytes.length || bytes[at] <= SPACE;
    if (isPlain && digits < MAX_EXACT && decimals < POWERS_OF_TEN.length && digitCount > 0) {
      this.at = at;
      const value = decimals > 0 ? digits / POWERS_OF_TEN[decimals] : digits;
      return isNegative ? -value : value;
    }
    return Number(this.word());
  }

  /** Skips the rest of the line. */
  skipLine(): void {
    const { bytes } = this;
    while (this.at < bytes.length && !isLineEnd(bytes[this.at])) this.at++;
  }

  /** Whether the next word begins with an ASCII text. */
  isAt(text: string): boolean {
    if (this.isAtEnd) return false;
    for (let i = 0; i < text.length; i++) if (this.bytes[this.at + i] !== text.charCodeAt(i)) return false;
    return true;
  }

  private skipWord(): void {
    while (this.at < this.bytes.length && this.bytes[this.at] > SPACE) this.at++;
  }
}

/** The number of bytes examined to detect UTF-16 without a byte order mark. */
const SAMPLE_BYTES = 64;

/** Converts UTF-16, with or without a byte order mark, to UTF-8, and removes the mark of UTF-8. Other bytes are returned as they are. */
export function toUtf8(bytes: Uint8Array): Uint8Array {
  const encoding = utf16Encoding(bytes);
  if (encoding) return new TextEncoder().encode(new TextDecoder(encoding).decode(bytes));
  const isMarked = bytes[0] === 0xef && bytes[1] === 0xbb && bytes[2] === 0xbf;
  return isMarked ? bytes.subarray(3) : bytes;
}

function utf16Encoding(bytes: Uint8Array): 'utf-16le' | 'utf-16be' | undefined {
  if (bytes[0] === 0xff && bytes[1] === 0xfe) return 'utf-16le';
  if (bytes[0] === 0xfe && bytes[1] === 0xff) return 'utf-16be';
  // UTF-16 without a mark is recognised by its Latin letters, one byte of which is zero.
  const sample = bytes.subarray(0, SAMPLE_BYTES);
  const isText = (first: number): boolean => {
    for (let i = 0; i + 1 < sample.length; i += 2) {
      if (sample[i + 1 - first] !== 0) return false;
      const letter = sample[i + first];
      if (letter === 0 || letter > 126) return false;
    }
    return sample.length >= 8;
  };
  if (isText(0)) return 'utf-16le';
  if (isText(1)) return 'utf-16be';
  return undefined;
}
