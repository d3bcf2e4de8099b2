import type { Mesh, Object3D } from 'three';
import { strToU8, zipSync } from 'three/addons/libs/fflate.module.js';
import { ThreeMFLoader } from 'three/addons/loaders/3MFLoader.js';
import { toUtf8 } from '../common/AsciiReader.js';
import { counted, ModelError } from '../common/ModelError.js';
import { unzip } from '../readArchive.js';
import { withFakeDocument, type XmlElement, XmlParser } from './fakeDocument.js';
import { type LoadedScene, sceneOf } from './LoadedScene.js';

/** Reads a 3MF file. @throws ModelError if it is damaged; Error of the loader */
export async function read3mf(bytes: Uint8Array, name: string): Promise<LoadedScene> {
  const joined = join3mf(await unzip(bytes, name, () => true), name);
  const scene = sceneOf(
    withFakeDocument(() => new ThreeMFLoader().parse(joined.bytes.slice().buffer)),
    name,
  );
  showAlpha(scene.root);
  return { ...scene, notes: joined.notes };
}

/** Makes materials with an alpha colour transparent: the loader sets only their opacity. */
function showAlpha(root: Object3D): void {
  root.traverse((object) => {
    for (const material of [(object as Partial<Mesh>).material ?? []].flat())
      if (material.opacity < 1) material.transparent = true;
  });
}

/** The units of models, in millimetres. */
const UNITS: Readonly<Record<string, number>> = {
  micron: 0.001,
  millimeter: 1,
  centimeter: 10,
  inch: 25.4,
  foot: 304.8,
  meter: 1000,
};
const MODEL = '3D/3dmodel.model';
/** Ids of added resources: a white material, and the filament colours. */
const WHITE = 'white';
const FILAMENTS = 'filaments';
const IDENTITY = '1 0 0 0 1 0 0 0 1 0 0 0';

/** A model file of a package. */
interface Part {
  text: string;
  /** The prefix of its ids in the joined model, since each file has its own ids. */
  prefix: string;
  /** Its unit, in millimetres. */
  unit: number;
  /** Ids of objects that are not part of the model, such as supports. */
  helpers: ReadonlySet<string>;
}

/**
 * Joins the model files of a 3MF package for three's loader. That loader looks for all components in the root file, mixes up objects with
 * the same id in several files, and ignores units. It draws triangles without a colour twice where others have one, and drops those whose
 * property is not a colour.
 *
 * @param files the content of the package, by path
 * @returns the package, and notes on what was left out
 * @throws ModelError if its relationships are missing, or name no model
 */
function join3mf(files: ReadonlyMap<string, Uint8Array>, name: string): { bytes: Uint8Array; notes: string[] } {
  const parts = new Parts(files);
  const joined = parts.join(rootOf(files, name));
  const textures = [...files].filter(([path]) => /^3D\/Textures?\//i.test(path));
  const relations = textures.map(([path]) => `<Relationship Target="/${path}" Id="" Type="texture"/>`);
  const bytes = zipSync(
    {
      '_rels/.rels': strToU8(`<Relationships><Relationship Target="/${MODEL}" Id="" Type="model"/></Relationships>`),
      '3D/_rels/3dmodel.model.rels': strToU8(`<Relationships>${relations.join('')}</Relationships>`),
      [MODEL]: strToU8(joined),
      ...Object.fromEntries(textures),
    },
    { level: 0 },
  );
  return { bytes, notes: parts.notes() };
}

/** The path of the root model. */
function rootOf(files: ReadonlyMap<string, Uint8Array>, name: string): string {
  const list = [...files].find(([path]) => /^_rels\/\.rels$/i.test(path));
  if (!list) throw new ModelError(`${name} is damaged or cut short: its list of parts is missing.`);
  const targets = [...decoded(list[1]).matchAll(/\sTarget\s*=\s*["']\/?([^"']+\.model)["']/gi)].map(([, path]) => path);
  const root = [...targets, ...files.keys()].find((path) => /\.model$/i.test(path) && fileAt(files, path));
  if (!root) throw new ModelError(`${name} is damaged or cut short: its model is missing.`);
  return root;
}

/** The file at a path; paths in packages ignore case. */
function fileAt(files: ReadonlyMap<string, Uint8Array>, path: string): Uint8Array | undefined {
  const wanted = path.replace(/^\//, '').toLowerCase();
  return files.get(path) ?? [...files].find(([other]) => other.toLowerCase() === wanted)?.[1];
}

const decoded = (bytes: Uint8Array): string => new TextDecoder().decode(toUtf8(bytes));

/** The model files of a package that are used. */
class Parts {
  private readonly parts = new Map<string, Part>();
  private readonly settings: SlicerSettings;
  /** The filament index of each object, by its id in the joined model. */
  private readonly filaments = new Map<string, number>();
  private readonly leftOut = { missing: 0, helpers: 0, mixed: 0, painted: 0 };

  constructor(private readonly files: ReadonlyMap<string, Uint8Array>) {
    const settings = fileAt(files, 'Metadata/model_settings.config');
    const project = fileAt(files, 'Metadata/project_settings.config');
    this.settings = new SlicerSettings(settings && decoded(settings), project && decoded(project));
  }

  notes(): string[] {
    const { missing, helpers, mixed, painted } = this.leftOut;
    return [
      counted(missing, 'part', 'left out: not in its file'),
      counted(helpers, 'helper', 'of the slicer left out'),
      mixed > 0 ? 'mixed colours left out' : '',
      painted > 0 ? 'painted colours left out' : '',
    ].filter(Boolean);
  }

  /** The text of a model joined with all models that it uses. */
  join(path: string): string {
    const root = this.partAt(path)!;
    const own = this.withPaths(root);
    const others: string[] = [];
    // The loop also visits parts that are added while it runs.
    for (const part of this.parts.values()) if (part !== root) others.push(resourcesOf(this.withPaths(part)));
    const base = (colour: string): string => `<base name="" displaycolor="${colour}"/>`;
    const colours = [
      `<basematerials id="${WHITE}">${base('#FFFFFF')}</basematerials>`,
      `<basematerials id="${FILAMENTS}">${this.settings.colours.map(base).join('')}</basematerials>`,
    ];
    return this.withColours(withResources(own, [...colours, ...others].join('')));
  }

  /** The model file at a path, read once; undefined if there is none. */
  private partAt(path: string): Part | undefined {
    const key = path.replace(/^\//, '').toLowerCase();
    const known = this.parts.get(key);
    const bytes = known ? undefined : fileAt(this.files, path);
    if (!bytes) return known;
    const text = decoded(bytes).replace(/<!--[\s\S]*?-->/g, '');
    const unit = /<(?:\w+:)?model\b[^>]*?\sunit\s*=\s*["'](\w+)["']/.exec(text)?.[1] ?? 'millimeter';
    const prefix = this.parts.size === 0 ? '' : `part${this.parts.size}-`;
    const helpers = new Set(
      [...text.matchAll(OBJECT)].filter(([tag]) => isHelper(tag)).map(([tag]) => prefix + attributeOf(tag, 'id')),
    );
    const joined = prefix ? withPrefix(text, prefix) : text;
    const part = { prefix, unit: UNITS[unit.toLowerCase()] ?? 1, text: joined, helpers };
    if (PAINTED.test(text)) this.leftOut.painted++;
    this.parts.set(key, part);
    return part;
  }

  /** The text of a part with the references of components and items changed to the ids and units of the joined model. */
  private withPaths({ text, unit, prefix, helpers }: Part): string {
    let object = '';
    return text.replace(OBJECT_OR_USE, (tag, use?: 'component' | 'item') => {
      if (!use) {
        object = attributeOf(tag, 'id') ?? '';
        return tag;
      }
      const path = attributeOf(tag, '(?:\\w+:)?path');
      const part = path === undefined ? { prefix, unit, helpers } : this.partAt(path);
      if (!part) {
        this.leftOut.missing++;
        return '';
      }
      const plainId = (attributeOf(tag, 'objectid') ?? '').slice(prefix.length);
      const id = part.prefix + plainId;
      if (part.helpers.has(id)) {
        this.leftOut.helpers++;
        return '';
      }
      // Slicer settings refer to objects of the root file and their components.
      if (use === 'component' && prefix === '') {
        if (this.settings.isHelper(object, plainId)) {
          this.leftOut.helpers++;
          return '';
        }
        const filament = this.settings.filamentOf(object, plainId);
        if (filament !== undefined) this.filaments.set(id, filament);
      }
      const scale = part.unit / unit;
      const numbers = (attributeOf(tag, 'transform') ?? IDENTITY).trim().split(/\s+/);
      const matrix = numbers.map((number, i) => (i < 9 && scale !== 1 ? Number(number) * scale : number));
      return `<${use} objectid="${id}" transform="${matrix.join(' ')}"/>`;
    });
  }

  /** Gives every mesh a colour that three's loader can draw. */
  private withColours(text: string): string {
    const opaque = withoutClearGroups(text);
    const known = new Set([...text.matchAll(COLOURS)].map(([, id]) => id));
    const plain = opaque.replace(/\spid\s*=\s*["']([^"']*)["']/g, (whole, id: string) => {
      if (known.has(id)) return whole;
      this.leftOut.mixed++;
      return '';
    });
    const isColoured = /<(?:\w+:)?triangle\b[^>]*\spid\s*=/.test(plain);
    return plain.replace(/<(?:\w+:)?object\b[^>]*?(?=\/?>)/g, (tag) => {
      if (attributeOf(tag, 'pid') !== undefined)
        return attributeOf(tag, 'pindex') === undefined ? `${tag} pindex="0"` : tag;
      const bare = tag.replace(/\spindex\s*=\s*["'][^"']*["']/, '');
      const id = attributeOf(tag, 'id') ?? '';
      const filament = this.filaments.get(id) ?? this.settings.filamentOf(id);
      if (filament !== undefined) return `${bare} pid="${FILAMENTS}" pindex="${filament}"`;
      return isColoured ? `${bare} pid="${WHITE}" pindex="0"` : bare;
    });
  }
}

const OBJECT = /<(?:\w+:)?object\b[^>]*>/g;
/** Whether an object's type marks it as not part of the model. */
const isHelper = (tag: string): boolean => /^(?:support|solidsupport|other)$/i.test(attributeOf(tag, 'type') ?? '');

/** An object's start tag; or a whole component or item. */
const OBJECT_OR_USE =
  /<(?:\w+:)?(?:object\b[^>]*>|(component|item)\b[^>]*?(?:\/>|>[\s\S]*?<\/(?:\w+:)?(?:component|item)\s*>))/g;
/** A resource with colours, with its id. */
const COLOURS = /<(?:\w+:)?(?:basematerials|colorgroup|texture2dgroup)\b[^>]*?\sid\s*=\s*["']([^"']*)["']/g;

/** A triangle with a slicer's paint colour. Paint for supports and seams does not count. */
const PAINTED = /<(?:\w+:)?triangle\b[^>]*?\s(?:paint_color|(?:\w+:)?mmu_segmentation)\s*=\s*["'][^"']/;

/** Converts colour groups with alpha to base materials: three's loader ignores the alpha of colour groups. */
const withoutClearGroups = (text: string): string =>
  text.replace(
    /<(?:\w+:)?colorgroup\b([^>]*)>([\s\S]*?)<\/(?:\w+:)?colorgroup\s*>/g,
    (whole, attributes: string, colours: string) => {
      const values = [...colours.matchAll(/\scolor\s*=\s*["']([^"']*)["']/g)].map(([, value]) => value);
      if (!values.some((value) => /^#[\da-f]{8}$/i.test(value) && !/ff$/i.test(value))) return whole;
      const bases = values.map((value) => `<base name="" displaycolor="${value}"/>`);
      return `<basematerials${attributes}>${bases.join('')}</basematerials>`;
    },
  );

const attributeOf = (tag: string, name: string): string | undefined =>
  new RegExp(`\\s${name}\\s*=\\s*(?:"([^"]*)"|'([^']*)')`)
    .exec(tag)
    ?.slice(1)
    .find((value) => value !== undefined);

/** Prefixes all ids of a text, and the references to them. */
const withPrefix = (text: string, prefix: string): string =>
  text.replace(/(\s(?:id|pid|objectid|texid|displaypropertiesid)\s*=\s*["'])/g, `$1${prefix}`);

/** The content of a model's resources element. */
function resourcesOf(text: string): string {
  const [start = ''] = /<(?:\w+:)?resources\b[^>]*>/.exec(text) ?? [];
  if (!start || start.endsWith('/>')) return '';
  const from = text.indexOf(start) + start.length;
  const [end = ''] = /<\/(?:\w+:)?resources\s*>/.exec(text.slice(from)) ?? [];
  return end ? text.slice(from, text.indexOf(end, from)) : '';
}

/** Adds resources to a model. */
const withResources = (text: string, more: string): string =>
  text.replace(/<((?:\w+:)?resources)\b[^>]*>/, (tag, name: string) =>
    tag.endsWith('/>') ? `<${name}>${more}</${name}>` : tag + more,
  );

/** A slicer's setting for an object or a part of it. */
interface Setting {
  /** The index of its filament, from 0; undefined for the default. */
  filament: number | undefined;
  /** Whether it is a helper: a cut-out, modifier or support. */
  isHelper: boolean;
}

const COLOUR = /^#[\da-f]{6}/i;

/** What a slicer's files in a 3MF package say about the model: filament colours, and helpers that are not printed. */
class SlicerSettings {
  /** The filament colours as in 3MF; empty if everything has one colour. */
  readonly colours: readonly string[];
  private readonly settings = new Map<string, Setting>();

  /**
   * @param objects an XML file with the filaments of objects and parts
   * @param project a JSON file with filament colours
   */
  constructor(objects: string | undefined, project: string | undefined) {
    for (const object of objects === undefined ? [] : elementsOf(objects, 'object')) {
      const id = object.getAttribute('id') ?? '';
      this.settings.set(id, settingOf(object));
      for (const part of object.children.filter(({ nodeName }) => nodeName === 'part'))
        this.settings.set(`${id} ${part.getAttribute('id')}`, settingOf(part));
    }
    const colours = coloursOf(project);
    const printed = [...this.settings.values()].filter(({ isHelper }) => !isHelper);
    const used = new Set(printed.map(({ filament }) => colours[filament ?? 0]));
    this.colours = used.size > 1 ? colours : [];
  }

  /** The index of the filament of an object or part, from 0; undefined if it has none. */
  filamentOf(object: string, part?: string): number | undefined {
    const filament = this.settings.get(`${object} ${part}`)?.filament ?? this.settings.get(object)?.filament ?? 0;
    return filament < this.colours.length ? filament : undefined;
  }

  isHelper(object: string, part: string): boolean {
    return this.settings.get(`${object} ${part}`)?.isHelper ?? false;
  }
}

/** The elements with a name; none if the text is damaged. */
function elementsOf(text: string, name: string): XmlElement[] {
  try {
    return new XmlParser().parseFromString(text).getElementsByTagName(name);
  } catch {
    return [];
  }
}

function settingOf(element: XmlElement): Setting {
  const { children } = element;
  const extruder = children.find((child) => child.nodeName === 'metadata' && child.getAttribute('key') === 'extruder');
  const number = Number(extruder?.getAttribute('value') ?? NaN);
  const subtype = element.getAttribute('subtype') ?? 'normal_part';
  return { filament: number >= 1 ? number - 1 : undefined, isHelper: subtype !== 'normal_part' };
}

function coloursOf(project: string | undefined): string[] {
  try {
    const colours: unknown = JSON.parse(project ?? '{}').filament_colour;
    const isUsable = Array.isArray(colours) && colours.every((colour) => COLOUR.test(String(colour)));
    return isUsable ? colours.map((colour) => String(colour).slice(0, 7)) : [];
  } catch {
    return [];
  }
}
