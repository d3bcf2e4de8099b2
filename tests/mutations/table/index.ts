import type { Mutation } from '../Mutation.js';
import { adjacency } from './adjacency.js';
import { archives } from './archives.js';
import { background } from './background.js';
import { bake } from './bake.js';
import { blending } from './blending.js';
import { command } from './command.js';
import { consent } from './consent.js';
import { detail } from './detail.js';
import { element } from './element.js';
import { engraving } from './engraving.js';
import { exports } from './exports.js';
import { exposure } from './exposure.js';
import { fading } from './fading.js';
import { files } from './files.js';
import { form } from './form.js';
import { frames } from './frames.js';
import { hand } from './hand.js';
import { kept } from './kept.js';
import { keys } from './keys.js';
import { lights } from './lights.js';
import { links } from './links.js';
import { maps } from './maps.js';
import { material } from './material.js';
import { meaning } from './meaning.js';
import { mistakes } from './mistakes.js';
import { nodes } from './nodes.js';
import { normals } from './normals.js';
import { occlusion } from './occlusion.js';
import { outlines } from './outlines.js';
import { page } from './page.js';
import { react } from './react.js';
import { repair } from './repair.js';
import { scan } from './scan.js';
import { scene } from './scene.js';
import { shadows } from './shadows.js';
import { slices } from './slices.js';
import { stipple } from './stipple.js';
import { strokes } from './strokes.js';
import { svg } from './svg.js';
import { tone } from './tone.js';
import { undo } from './undo.js';
import { worker } from './worker.js';

/** The breaks, by the area of the project that they are in. */
export const table: Readonly<Record<string, readonly Mutation[]>> = {
  adjacency,
  archives,
  background,
  bake,
  blending,
  command,
  consent,
  detail,
  element,
  fading,
  engraving,
  exports,
  exposure,
  files,
  form,
  frames,
  hand,
  kept,
  keys,
  lights,
  links,
  maps,
  material,
  meaning,
  mistakes,
  nodes,
  normals,
  occlusion,
  outlines,
  page,
  react,
  repair,
  scan,
  scene,
  shadows,
  slices,
  stipple,
  strokes,
  svg,
  tone,
  undo,
  worker,
};
