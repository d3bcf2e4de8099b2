import { bake } from './bake/bake.mjs';
import { detail } from './detail/detail.mjs';
import { drop } from './drop/drop.mjs';
import { firstPicture } from './firstPicture/firstPicture.mjs';
import { form } from './form/form.mjs';
import { frame } from './frame/frame.mjs';
import { lineFields } from './lineFields/lineFields.mjs';
import { lines } from './lines/lines.mjs';
import { many } from './many/many.mjs';
import { media } from './media/media.mjs';
import { memory } from './memory/memory.mjs';
import { nodes } from './nodes/nodes.mjs';
import { occlusion } from './occlusion/occlusion.mjs';
import { presets } from './presets/presets.mjs';
import { shadows } from './shadows/shadows.mjs';
import { tam } from './tam/tam.mjs';
import { upload } from './upload/upload.mjs';
import { vector } from './vector/vector.mjs';

/**
 * All benchmarks, in the order they run in. Each has a name, knows whether its measures depend on the rasterizer, runs in
 * a browser (`openBrowser`) to a result of plain data, and describes such a result in Markdown.
 */
export const benchmarks = [
  presets,
  frame,
  nodes,
  many,
  media,
  lines,
  shadows,
  lineFields,
  bake,
  form,
  memory,
  occlusion,
  upload,
  tam,
  vector,
  firstPicture,
  drop,
  detail,
];
