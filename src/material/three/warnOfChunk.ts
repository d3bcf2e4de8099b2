import { REVISION } from 'three';
import { warn } from '../diagnostics/warn.js';

/** The chunks of three.js that are read or changed, each with what is wrong where its text is not one that is known. */
const EFFECTS = {
  shadowmap_pars_fragment: 'edges of shadows keep its own filter, which may crawl under strokes',
  lights_pars_begin: 'lights of an unknown kind give strokes no direction',
  lights_fragment_begin: 'strokes do not tell shadows from shade',
  envmap_physical_pars_fragment: 'environments give no light',
};

export type ChunkName = keyof typeof EFFECTS;

const warned = new Set<ChunkName>();

/** Warns once of each chunk. The text is loaded only when there is something to say. */
export function warnOfChunk(name: ChunkName): void {
  if (warned.has(name)) return;
  warned.add(name);
  warn(
    `three-hatching: the shader chunk "${name}" of this three.js (0.${REVISION}, or changed by the page) is none of those of 0.170 to 0.187: ${EFFECTS[name]}.`,
  );
}
