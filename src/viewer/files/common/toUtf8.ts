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
