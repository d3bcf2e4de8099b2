import type { PlannedTones, SurfaceFacts } from './ToneFit.js';

/** A name for a surface: materials of the same name and paint are one. */
export const surfaceKey = ({ name, color, map, vertexColors }: SurfaceFacts): string =>
  [name, color.getHexString(), map?.uuid, vertexColors].join(' ');

/** The tone of a material, and what it was found by. */
interface Known extends SurfaceFacts {
  readonly tone: number | undefined;
}

/** The tones that a plan of values has for whole surfaces. */
export class SurfaceTones implements PlannedTones {
  private readonly known = new WeakMap<SurfaceFacts, Known>();

  /** @param byKey darknesses by the names of surfaces */
  constructor(private readonly byKey: ReadonlyMap<string, number>) {}

  /** Allocates nothing unless the material has changed. */
  of(material: SurfaceFacts): number | undefined {
    const { name, color, map, vertexColors } = material;
    const before = this.known.get(material);
    if (
      before?.name === name &&
      before.map === map &&
      before.vertexColors === vertexColors &&
      before.color.equals(color)
    )
      return before.tone;
    const tone = this.byKey.get(surfaceKey(material));
    this.known.set(material, { name, color: color.clone(), map, vertexColors, tone });
    return tone;
  }
}
