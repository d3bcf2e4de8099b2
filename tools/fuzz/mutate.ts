import type { ModelFile } from '../../src/viewer/files/readModel.js';
import type { Random } from '../../src/viewer/settings/Random.js';
import type { Json } from '../modelFiles/GltfBuilder.js';
import type { GoodDrop, GoodFile } from './goodFiles.js';

/** Values that readers are likely to mishandle. */
export const NASTY: readonly unknown[] = [
  -1,
  0,
  1,
  2,
  3,
  7,
  255,
  65536,
  0.5,
  -0.001,
  1e9,
  2 ** 31,
  2 ** 32,
  2 ** 53,
  1e38,
  1e308,
  -1e308,
  null,
  true,
  '',
  '0',
  '__proto__',
  'constructor',
  'https://example.org/a.bin',
  [],
  [0],
  {},
  { length: 1e9 },
];
const NASTY_WORDS = [
  'nan',
  'inf',
  '-1',
  '0',
  '1e400',
  '99999999999',
  '4294967295',
  '/',
  '#',
  '',
  'f',
  'v',
  '\0',
  'é',
  '1e-320',
];
const NASTY_FLOATS = [Number.NaN, Infinity, -Infinity, 1e38, -1e38, 1e-45, 0, -0];
const NASTY_INTEGERS = [0, 1, 0x7fffffff, 0x80000000, 0xffffffff, 0x10000, 255];

/** Every place of a document that holds a value. */
function placesIn(value: Json, places: { holder: Json; key: string }[] = []): { holder: Json; key: string }[] {
  if (typeof value !== 'object' || value === null) return places;
  for (const key of Object.keys(value)) {
    places.push({ holder: value, key });
    placesIn(value[key], places);
  }
  return places;
}

function mutateDocument(json: Json, random: Random): void {
  const { holder, key } = random.pick(placesIn(json));
  const value = holder[key];
  switch (random.below(6)) {
    case 0:
      if (Array.isArray(holder)) holder.splice(Number(key), 1);
      else delete holder[key];
      break;
    case 1:
      if (Array.isArray(holder)) holder.push(structuredClone(value));
      else holder[random.pick(Object.keys(holder))] = structuredClone(value);
      break;
    case 2:
      // Another value of the same document probably has a plausible type.
      {
        const other = random.pick(placesIn(json));
        holder[key] = structuredClone(other.holder[other.key]);
      }
      break;
    case 3:
      if (typeof value === 'number') holder[key] = value + random.pick([-1, 1, 0.5, 100]);
      else holder[key] = random.pick(NASTY);
      break;
    default:
      holder[key] = random.pick(NASTY);
  }
}

export function mutateBytes(source: Uint8Array, random: Random): Uint8Array {
  const bytes = source.slice();
  if (bytes.length < 8) return bytes;
  const view = new DataView(bytes.buffer);
  const at = random.below(bytes.length - 4);
  switch (random.below(7)) {
    case 0:
      bytes[at] ^= 1 << random.below(8);
      return bytes;
    case 1:
      return bytes.slice(0, random.below(bytes.length));
    case 2:
      view.setFloat32(at & ~3, random.pick(NASTY_FLOATS), true);
      return bytes;
    case 3:
      view.setUint32(at & ~3, random.pick(NASTY_INTEGERS), true);
      return bytes;
    case 4:
      bytes.copyWithin(at, random.below(bytes.length));
      return bytes;
    case 5:
      // Damage to the header has the most effect.
      view.setUint32(Math.min(4 * random.below(32), bytes.length - 4) & ~3, random.pick(NASTY_INTEGERS), true);
      return bytes;
    default: {
      const longer = new Uint8Array(bytes.length + 1 + random.below(64));
      longer.set(bytes);
      longer.copyWithin(at + 1, at, bytes.length);
      return longer;
    }
  }
}

export function mutateText(text: string, random: Random): string {
  const lines = text.split('\n');
  const at = random.below(lines.length);
  switch (random.below(7)) {
    case 0:
      lines.splice(at, 1);
      break;
    case 1:
      lines.splice(at, 0, lines[random.below(lines.length)]);
      break;
    case 2:
      return text.slice(0, random.below(text.length));
    case 3:
      return text.replaceAll('\n', random.pick(['\r', '\r\n', ' ', '\\\n']));
    case 4:
      // A file that is one line would be doubled as a whole.
      if (lines[at].length < 2000) lines[at] = lines[at].repeat(1 + random.below(50));
      break;
    default: {
      const words = lines[at].split(' ');
      words[random.below(words.length)] = random.pick(NASTY_WORDS);
      lines[at] = words.join(' ');
    }
  }
  return lines.join('\n');
}

/** Damages some values of good files, and returns the files to be dropped. */
export function mutate(drop: GoodDrop, random: Random): ModelFile[] {
  const times = random.pick([0, 1, 1, 1, 2, 3, 6]);
  const chosen = random.below(drop.length);
  const files = drop.flatMap((file, i) => write(file, i === chosen ? times : 0, random));
  // Removes one of the files.
  if (files.length > 1 && random.chance(0.15)) files.splice(1 + random.below(files.length - 1), 1);
  return files.map(([name, content]) => ({ name, content: new Blob([content as Uint8Array<ArrayBuffer>]) }));
}

function write(file: GoodFile, times: number, random: Random): [name: string, content: Uint8Array | string][] {
  if (file.kind === 'text') {
    let { text } = file;
    for (let i = 0; i < times; i++) text = mutateText(text, random);
    return [[file.name, text]];
  }
  if (file.kind === 'bytes') {
    let { bytes } = file;
    for (let i = 0; i < times; i++) bytes = mutateBytes(bytes, random);
    return [[file.name, bytes]];
  }
  const { builder, isBinary } = file;
  let { bytes } = builder;
  builder.json.buffers[0].byteLength = bytes.length;
  if (!isBinary) builder.json.buffers[0].uri = 'ball.bin';
  for (let i = 0; i < times; i++) {
    // The document is damaged most often, else its data or, below, the whole file.
    if (random.chance(0.75)) mutateDocument(builder.json, random);
    else bytes = mutateBytes(bytes, random);
  }
  if (!isBinary) {
    return [
      [file.name, JSON.stringify(builder.json)],
      ['ball.bin', bytes],
    ];
  }
  const glb = builder.glb(bytes);
  return [[file.name, times > 0 && random.chance(0.1) ? mutateBytes(glb, random) : glb]];
}
