/** Width and height in pixels, from the header of a PNG, JPEG, WebP, BMP or GIF image. Undefined for anything else. */
export function imageSize(bytes: Uint8Array): [width: number, height: number] | undefined {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const text = (at: number): string => String.fromCharCode(...bytes.subarray(at, at + 4));
  if (bytes.length < 30) return undefined;
  if (text(1) === 'PNG\r') return [view.getUint32(16), view.getUint32(20)];
  if (text(0) === 'RIFF' && text(8) === 'WEBP') return webpSize(view, text(12));
  if (view.getUint16(0) === 0xffd8) return jpegSize(view);
  if (text(0).startsWith('BM')) return positive(view.getInt32(18, true), Math.abs(view.getInt32(22, true)));
  if (text(0) === 'GIF8') return positive(view.getUint16(6, true), view.getUint16(8, true));
  return undefined;
}

const positive = (width: number, height: number): [number, number] | undefined =>
  width > 0 && height > 0 ? [width, height] : undefined;

function webpSize(view: DataView, kind: string): [number, number] | undefined {
  const u24 = (at: number): number => view.getUint16(at, true) | (view.getUint8(at + 2) << 16);
  if (kind === 'VP8X') return [u24(24) + 1, u24(27) + 1];
  if (kind === 'VP8 ') return [view.getUint16(26, true) & 0x3fff, view.getUint16(28, true) & 0x3fff];
  if (kind !== 'VP8L') return undefined;
  const bits = view.getUint32(21, true);
  return [(bits & 0x3fff) + 1, ((bits >>> 14) & 0x3fff) + 1];
}

/** Skips JPEG markers up to the start of a frame. */
function jpegSize(view: DataView): [number, number] | undefined {
  for (let at = 2; at + 9 < view.byteLength; ) {
    const marker = view.getUint16(at);
    const startsFrame = marker >= 0xffc0 && marker <= 0xffcf && ![0xffc4, 0xffc8, 0xffcc].includes(marker);
    if (startsFrame) return [view.getUint16(at + 7), view.getUint16(at + 5)];
    if (marker < 0xff00) return undefined;
    // Any number of fill bytes may precede a marker.
    at += marker === 0xffff ? 1 : 2 + view.getUint16(at + 2);
  }
  return undefined;
}
