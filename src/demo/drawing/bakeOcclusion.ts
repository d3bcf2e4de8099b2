/** Fetched when a drawing is to be darkened in its hollows, which is after it was first drawn. */
export { bakeOcclusion } from 'three-hatching';
