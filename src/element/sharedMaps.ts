import { type MapDrawing, TonalArtMap } from 'three-hatching';

/** A map that drawings of one preset share, and how many do. */
interface SharedMap {
  map: Promise<TonalArtMap>;
  users: number;
}

/** By what is drawn: presets are frozen, so it is the same object every time. */
const shared = new Map<Readonly<MapDrawing>, SharedMap>();

/** The map of a preset, drawn once for all who use it. To be given back with {@link returnMap}, also where it failed. */
export function borrowMap(drawing: Readonly<MapDrawing>): Promise<TonalArtMap> {
  let entry = shared.get(drawing);
  if (!entry) {
    entry = { map: TonalArtMap.generate(drawing), users: 0 };
    shared.set(drawing, entry);
  }
  entry.users++;
  return entry.map;
}

/** Frees a map when its last user gives it back. */
export function returnMap(drawing: Readonly<MapDrawing>): void {
  const entry = shared.get(drawing);
  if (!entry || --entry.users > 0) return;
  shared.delete(drawing);
  entry.map.then(
    (map) => map.dispose(),
    () => {
      // Whoever borrowed it has heard of that.
    },
  );
}
