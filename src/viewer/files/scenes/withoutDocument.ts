import { DataTextureLoader, FileLoader, ImageLoader, Texture } from 'three';
import type { PictureLink } from '../pictures/WantedPicture.js';
import { XmlParser } from './XmlElement.js';

/**
 * Runs one of three's loaders without a document, as in a worker, and without loading anything: every texture gets a {@link PictureLink}.
 * Until it returns, it replaces the image and file loaders, which need a document and would fetch files that were not dropped; blob URLs,
 * which some pages forbid; the XML parser and the window size, which workers lack; Float32Array, which is too coarse for map coordinates;
 * and the console, where loaders report what the user cannot change.
 *
 * @param parse must be synchronous
 * @param Parser of XML
 */
export function withoutDocument<Result>(parse: () => Result, Parser: new () => XmlParser = XmlParser): Result {
  const blobs = new Map<string, Blob>();
  const link = (url: string): PictureLink => ({ url, content: blobs.get(url), width: 1, height: 1 });
  // A page's own window cannot be replaced.
  const isPage = 'window' in globalThis;
  const restore = [
    replace(ImageLoader.prototype, {
      load: (url: string, onLoad?: (picture: PictureLink) => void) => {
        const picture = link(url);
        onLoad?.(picture);
        return picture;
      },
    }),
    replace(DataTextureLoader.prototype, { load: (url: string) => new Texture(link(url)) }),
    replace(FileLoader.prototype, { load: () => undefined }),
    replace(URL, {
      createObjectURL: (blob: Blob) => {
        const url = `blob:${blobs.size}`;
        blobs.set(url, blob);
        return url;
      },
    }),
    replace(console, { debug: () => {}, log: () => {}, info: () => {}, warn: () => {}, error: () => {} }),
    replace(globalThis, {
      Float32Array: DOUBLES,
      DOMParser: Parser,
      ...(isPage ? {} : { window: { innerWidth: 1, innerHeight: 1 } }),
    }),
  ];
  try {
    return parse();
  } finally {
    for (const undo of restore) undo();
  }
}

/** Creates double-precision arrays in place of single-precision ones, except for views of buffers. */
const DOUBLES = new Proxy(Float32Array, {
  construct: (single, given) =>
    given[0] instanceof ArrayBuffer ? Reflect.construct(single, given) : new Float64Array(given[0]),
});

/** Replaces properties of an object. @returns a function that restores them */
export function replace(target: object, values: Readonly<Record<string, unknown>>): () => void {
  const former = Object.keys(values).map((key) => [key, Object.getOwnPropertyDescriptor(target, key)] as const);
  for (const [key, value] of Object.entries(values)) {
    Object.defineProperty(target, key, { value, configurable: true, writable: true });
  }
  return () => {
    for (const [key, descriptor] of former) {
      if (descriptor) Object.defineProperty(target, key, descriptor);
      else Reflect.deleteProperty(target, key);
    }
  };
}
