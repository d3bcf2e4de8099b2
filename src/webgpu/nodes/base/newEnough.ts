/** The oldest version of three.js, after its `0.`, whose nodes draw what GLSL draws. */
const OLDEST = 186;

/**
 * The nodes of three.js, if they are of a version that has all that is asked of them.
 *
 * @param revision the version after its `0.`, such as `187` or `187dev`
 * @throws Error that says what to do
 */
export function newEnough<Nodes>(nodes: Nodes, revision: string): Nodes {
  if (Number.parseInt(revision, 10) >= OLDEST) return nodes;
  throw new Error(
    `three-hatching/webgpu needs three.js 0.${OLDEST} or newer, but this is 0.${revision}. Update three.js, or draw with WebGLRenderer and import from 'three-hatching', which works with any version from 0.170 on.`,
  );
}
