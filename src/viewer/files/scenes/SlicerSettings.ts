import { type XmlElement, XmlParser } from './XmlElement.js';

/** The settings of an object, or of a part of it. */
interface Setting {
  /** The number of its filament, from 0 on; undefined for that of the whole, or the first. */
  filament: number | undefined;
  /** Whether it is no part of the model: what is cut out, changed or supported while it is printed. */
  isHelper: boolean;
}

const COLOUR = /^#[\da-f]{6}/i;

/** What the settings of a slicer, in files beside the model of a 3MF package, say of the model: colours, and what is not printed. */
export class SlicerSettings {
  /** The colours of the filaments, as 3MF has them; none if all that is printed has one colour. */
  readonly colours: readonly string[];
  private readonly settings = new Map<string, Setting>();

  /**
   * @param objects an XML file with the filaments of objects and their parts
   * @param project a JSON file with the colours of filaments
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

  /** The number of the filament of an object or a part of it, from 0 on; undefined if it has no colour. */
  filamentOf(object: string, part?: string): number | undefined {
    const filament = this.settings.get(`${object} ${part}`)?.filament ?? this.settings.get(object)?.filament ?? 0;
    return filament < this.colours.length ? filament : undefined;
  }

  isHelper(object: string, part: string): boolean {
    return this.settings.get(`${object} ${part}`)?.isHelper ?? false;
  }
}

/** The elements of a name; none if the text is damaged. */
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
