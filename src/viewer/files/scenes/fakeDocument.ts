import { DataTextureLoader, FileLoader, ImageLoader, Texture } from 'three';
import type { PictureLink } from '../pictures/meshPictures.js';

/**
 * Runs one of three's loaders without a document, as in a worker, and without loading anything: every texture gets a {@link PictureLink}.
 * Until it returns, it replaces the image and file loaders, which need a document and would fetch files that were not dropped; blob URLs,
 * which some pages forbid; the XML parser and the window size, which workers lack; Float32Array, which is too coarse for map coordinates;
 * and the console, where loaders report what the user cannot change.
 *
 * @param parse must be synchronous
 * @param Parser of XML
 */
export function withFakeDocument<Result>(parse: () => Result, Parser: new () => XmlParser = XmlParser): Result {
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

/** An attribute of an element, with the members that three's loaders use. */
interface XmlAttribute {
  readonly name: string;
  readonly value: string;
  readonly specified: true;
}

const MAX_DEPTH = 500;
const ATTRIBUTE = /([^\s=/>]+)\s*=\s*(?:"([^"]*)"|'([^']*)')/g;

/**
 * An XML element: the part of the DOM that three's loaders for COLLADA and 3MF use, which workers lack. Names are looked up without their
 * namespace prefix. Children are elements only.
 */
export class XmlElement {
  readonly nodeType = 1;
  readonly childNodes: XmlElement[] = [];
  readonly attributes: XmlAttribute[] = [];
  private readonly localName: string;
  private ownText = '';

  constructor(readonly nodeName: string) {
    this.localName = withoutPrefix(nodeName);
  }

  get children(): readonly XmlElement[] {
    return this.childNodes;
  }

  /** The trimmed text of the element and its descendants. */
  get textContent(): string {
    return [this.ownText, ...this.childNodes.map((child) => child.textContent)].join('').trim();
  }

  getAttribute(name: string): string | null {
    return this.attributes.find((attribute) => attribute.name === name)?.value ?? null;
  }

  /** three's COLLADA loader assigns ids to nodes without one. */
  setAttribute(name: string, value: string): void {
    const at = this.attributes.findIndex((attribute) => attribute.name === name);
    const attribute = { name, value, specified: true } as const;
    if (at === -1) this.attributes.push(attribute);
    else this.attributes[at] = attribute;
  }

  getAttributeNS(_namespace: string, name: string): string | null {
    return this.attributes.find((attribute) => withoutPrefix(attribute.name) === name)?.value ?? null;
  }

  hasAttribute(name: string): boolean {
    return this.getAttribute(name) !== null;
  }

  getElementsByTagName(name: string): XmlElement[] {
    return this.below((element) => element.nodeName === name);
  }

  getElementsByTagNameNS(_namespace: string, name: string): XmlElement[] {
    return this.below((element) => element.localName === name);
  }

  /** @param selector names, each of an element below the one before it */
  querySelectorAll(selector: string): XmlElement[] {
    let found: XmlElement[] = [this];
    for (const name of selector.trim().split(/\s+/)) {
      found = [...new Set(found.flatMap((element) => element.getElementsByTagNameNS('', name)))];
    }
    return found;
  }

  querySelector(selector: string): XmlElement | null {
    return this.querySelectorAll(selector)[0] ?? null;
  }

  /** Adds a child. For the parser only. */
  addText(text: string): void {
    this.ownText += text;
  }

  private below(isWanted: (element: XmlElement) => boolean): XmlElement[] {
    const found: XmlElement[] = [];
    const pending = [...this.childNodes].reverse();
    for (let element = pending.pop(); element; element = pending.pop()) {
      if (isWanted(element)) found.push(element);
      for (let i = element.childNodes.length - 1; i >= 0; i--) pending.push(element.childNodes[i]);
    }
    return found;
  }
}

/** A document: the parent of the root element. */
class XmlDocument extends XmlElement {
  constructor() {
    super('#document');
  }

  get documentElement(): XmlElement {
    return this.childNodes[0];
  }
}

/**
 * Parses XML, without custom entities, which could make a short text huge.
 *
 * @throws Error if elements do not close in order, or are nested too deep
 */
export class XmlParser {
  parseFromString(text: string): XmlDocument {
    const document = new XmlDocument();
    const open: XmlElement[] = [document];
    for (let at = 0; at < text.length; ) {
      const start = text.indexOf('<', at);
      const end = start === -1 ? text.length : start;
      if (end > at) open.at(-1)!.addText(withoutEntities(text.slice(at, end)));
      if (start === -1) break;
      at = readMarkup(text, start, open);
    }
    if (open.length > 1 || document.childNodes.length === 0) throw new Error('its XML is cut short');
    return document;
  }
}

/** Reads markup that begins with `<`. @returns its end */
function readMarkup(text: string, start: number, open: XmlElement[]): number {
  if (text.startsWith('<!--', start)) return after(text, '-->', start + 4);
  if (text.startsWith('<![CDATA[', start)) {
    const end = after(text, ']]>', start);
    open.at(-1)!.addText(text.slice(start + 9, end - 3));
    return end;
  }
  if (text.startsWith('<?', start)) return after(text, '?>', start);
  if (text.startsWith('<!', start)) return afterDeclaration(text, start);
  const end = afterTag(text, start);
  if (text[start + 1] === '/') {
    const name = text.slice(start + 2, end - 1).trim();
    if (open.length < 2 || open.pop()!.nodeName !== name) throw new Error('its XML elements do not close in order');
    return end;
  }
  const isEmpty = text[end - 2] === '/';
  const inside = text.slice(start + 1, isEmpty ? end - 2 : end - 1);
  const name = /^[^\s/>]+/.exec(inside)?.[0];
  if (!name) throw new Error('its XML has an element without a name');
  const element = new XmlElement(name);
  for (const [, key, double, single] of inside.slice(name.length).matchAll(ATTRIBUTE)) {
    element.attributes.push({ name: key!, value: withoutEntities(double ?? single ?? ''), specified: true });
  }
  open.at(-1)!.childNodes.push(element);
  if (!isEmpty && open.push(element) > MAX_DEPTH) throw new Error(`its XML is nested more than ${MAX_DEPTH} deep`);
  return end;
}

function after(text: string, mark: string, from: number): number {
  const at = text.indexOf(mark, from);
  if (at === -1) throw new Error('its XML is cut short');
  return at + mark.length;
}

/** The end of a tag, whose attributes may contain `>`. */
function afterTag(text: string, start: number): number {
  let quote = '';
  for (let at = start + 1; at < text.length; at++) {
    const letter = text[at];
    if (quote) {
      if (letter === quote) quote = '';
    } else if (letter === '"' || letter === "'") quote = letter;
    else if (letter === '>') return at + 1;
  }
  throw new Error('its XML is cut short');
}

/** The end of a declaration, which may contain others in brackets. */
function afterDeclaration(text: string, start: number): number {
  const bracket = text.indexOf('[', start);
  const end = after(text, '>', start);
  return bracket === -1 || bracket > end ? end : after(text, '>', after(text, ']', bracket));
}

const ENTITIES: Readonly<Record<string, string>> = { lt: '<', gt: '>', amp: '&', quot: '"', apos: "'" };

function withoutEntities(text: string): string {
  if (!text.includes('&')) return text;
  return text.replace(/&(?:#(\d+)|#x([\da-f]+)|(\w+));/gi, (whole, decimal, hex, name) => {
    if (name) return ENTITIES[name] ?? whole;
    const code = decimal ? Number(decimal) : Number.parseInt(hex, 16);
    return code <= 0x10ffff ? String.fromCodePoint(code) : whole;
  });
}

const withoutPrefix = (name: string): string => name.slice(name.indexOf(':') + 1);
