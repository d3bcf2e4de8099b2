import type { Mutation } from '../Mutation.js';
import { adjacency } from './adjacency.js';
import { archives } from './archives.js';
import { bake } from './bake.js';
import { files } from './files.js';
import { normals } from './normals.js';

/** The breaks, by the area of the project that they are in. */
export const table: Readonly<Record<string, readonly Mutation[]>> = { adjacency, archives, bake, files, normals };
