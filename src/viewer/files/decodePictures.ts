import type { Surroundings } from './common/Surroundings.js';
import { counted } from './common/shownText.js';
import { settleBlendedPictures } from './gltf/blendedPictures.js';
import { settleTransmittedPictures } from './gltf/transmittedPictures.js';
import type { ReadModel } from './readModel.js';

/** Decodes the pictures of a model. Should run in a worker, since a large picture takes seconds. */
export async function withPictures(
  model: ReadModel,
  onStage: (stage: string) => void,
  { decodePicture }: Pick<Surroundings, 'decodePicture'>,
): Promise<ReadModel> {
  if (model.kind === 'mesh') return model;
  const { parts } = model;
  const count = parts.pictures.filter(Boolean).length;
  // One at a time, because each briefly needs its full size in memory.
  let number = 0;
  let lost = 0;
  for (const [i, picture] of parts.pictures.entries()) {
    if (!picture) continue;
    onStage(`decoding picture ${++number} of ${count}`);
    const { content, width, height } = picture;
    try {
      parts.bitmaps[i] = await decodePicture(content, { width, height, flipY: false });
    } catch {
      lost++;
    }
  }
  settleBlendedPictures(parts);
  settleTransmittedPictures(parts);
  const notes = lost > 0 ? [counted(lost, 'damaged picture', 'left out')] : [];
  return { ...model, notes: [...model.notes, ...notes], lostPictures: (model.lostPictures ?? 0) + lost };
}
