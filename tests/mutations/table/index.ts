import type { Mutation } from '../Mutation.js';
import { adjacency } from './adjacency.js';
import { archives } from './archives.js';
import { bake } from './bake.js';
import { exports } from './exports.js';
import { files } from './files.js';
import { hand } from './hand.js';
import { kept } from './kept.js';
import { links } from './links.js';
import { maps } from './maps.js';
import { normals } from './normals.js';
import { repair } from './repair.js';
import { scan } from './scan.js';
import { strokes } from './strokes.js';
import { undo } from './undo.js';

/** The breaks, by the area of the project that they are in. */
export const table: Readonly<Record<string, readonly Mutation[]>> = {
  adjacency,
  archives,
  bake,
  exports,
  files,
  hand,
  kept,
  links,
  maps,
  normals,
  repair,
  scan,
  strokes,
  undo,
};
