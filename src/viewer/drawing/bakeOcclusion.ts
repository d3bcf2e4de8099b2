/** A module of its own, which is fetched after the first drawing, when its hollows are darkened. */
export { bakeOcclusion } from 'three-hatching';
