import type { DecoderModule } from 'draco3d';
import { ModelError } from '../common/ModelError.js';
import type { Surroundings } from '../common/Surroundings.js';
import { type DracoAttribute, type DracoPart, decodeDraco } from './decodeDraco.js';
import type { DracoSource } from './GltfGeometry.js';
import type { GltfValues } from './GltfValues.js';
import type { GltfDocument } from './gltfDocument.js';

/** Unpacks the primitives of a document that are packed with Draco. The decoder is fetched for the first of them. */
export function dracoSource(
  document: GltfDocument,
  values: GltfValues,
  fileName: string,
  loadDraco: Surroundings['loadDraco'],
): DracoSource {
  let loaded: Promise<DecoderModule> | undefined;
  return async ({ bufferView, attributes }, primitive) => {
    const wanted = new Map<string, DracoAttribute>();
    for (const [name, id] of Object.entries(attributes)) {
      const accessor = primitive.attributes[name];
      if (accessor !== undefined) wanted.set(name, { id, componentType: document.accessors[accessor].componentType });
    }
    const bytes = values.viewOf(bufferView);
    loaded ??= loadDraco();
    const draco = await loaded.catch(() => {
      throw new ModelError(
        `${fileName} is packed with Draco, whose decoder could not be fetched. Look after the connection, and open it again.`,
      );
    });
    let part: DracoPart;
    try {
      part = decodeDraco(draco, bytes, wanted);
    } catch (error) {
      if (error instanceof ModelError) throw error;
      throw new ModelError(`${fileName} is damaged: a part packed with Draco cannot be unpacked.`);
    }
    for (const [name, attribute] of part.attributes) values.normalize(primitive.attributes[name], attribute.values);
    return part;
  };
}
