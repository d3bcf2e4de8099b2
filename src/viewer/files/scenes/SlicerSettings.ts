import { type XmlElement, XmlParser } from './XmlElement.js';

/** A slicer's setting for an object or a part of it. */
interface Setting {
  /** The index of its filament, from 0; undefined for the default. */
  filament: number | undefined;
  /** Whether it is a helper: a cut-out, modifier or support. */
  isHelper: boolean;
}

const COLOUR = /^#[\da-f]{6}/i;

/** What a slicer's files in a 3MF package say about the model: filament colours, and helpers that are not printed. */
export class SlicerSettings {
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
