/** A chunk of its own, loaded after the first drawing. */
export { bakeOcclusion } from 'three-hatching';
